#include "polylap/apply/conversions.hpp"

#include <array>

#include "polylap/apply/noise.hpp"
#include "polylap/face/triangulate_mesh.hpp"
#include "polylap/mesh/convert.hpp"

namespace polylap {
namespace {

constexpr const char* subdivision_rules[] = {"linear", "catmull-clark"};

constexpr std::array quads_parameters{
    choice_parameter("rule", "rule", subdivision_rules, "keep the surface, or smooth it"),
};
constexpr std::array triangles_parameters{
    choice_parameter("rule", "rule", triangulation_rule_names, "which diagonals cut a face"),
};
constexpr std::array noise_parameters{
    Parameter{.id = "amplitude",
              .label = "amplitude",
              .kind = Parameter::Kind::real,
              .min = 0,
              .max = 100,
              .slider_max = 1,
              .step = 0.01,
              .initial = 0.3,
              .hint = "of the mean edge length"},
    Parameter{.id = "seed",
              .label = "seed",
              .kind = Parameter::Kind::integer,
              .min = 0,
              .max = 4294967295.0,
              .slider_max = 100,
              .step = 1,
              .initial = 1,
              .hint = "another seed, another noise; the same on every platform"},
};

constexpr ConversionInfo dual{"dual",
                              "Dual mesh",
                              "A face around each inner vertex, its corners in the middles of the faces.",
                              {},
                              [](const PolygonMesh& mesh, std::span<const double>) { return dual_mesh(mesh); }};
constexpr ConversionInfo quads{"quads", "Quads", "Each face of n corners becomes n quads around its middle.",
                               quads_parameters, [](const PolygonMesh& mesh, std::span<const double> p) {
                                   return subdivide_into_quads(mesh, static_cast<SubdivisionRule>(p[0]));
                               }};
constexpr ConversionInfo pairs{"pair-triangles",
                               "Pairs of triangles",
                               "Neighbouring triangles become quads where these are convex.",
                               {},
                               [](const PolygonMesh& mesh, std::span<const double>) { return pair_triangles(mesh); }};
constexpr ConversionInfo triangles{"triangles", "Triangles", "Diagonals cut each face into triangles.",
                                   triangles_parameters, [](const PolygonMesh& mesh, std::span<const double> p) {
                                       return triangulate_faces(mesh, static_cast<TriangulationRule>(p[0]));
                                   }};
constexpr ConversionInfo noise{"noise", "Noise", "Each vertex moves at random along its normal.", noise_parameters,
                               [](const PolygonMesh& mesh, std::span<const double> p) {
                                   return add_normal_noise(mesh, p[0], static_cast<std::uint32_t>(p[1]));
                               }};

}  // namespace

Result<PolygonMesh> triangulate_faces(const PolygonMesh& mesh, TriangulationRule rule) {
    return triangulate_mesh(mesh, rule);
}

// THE conversion table, in the order of the menus.
std::span<const ConversionInfo* const> conversions() noexcept {
    static constexpr std::array table{&dual, &quads, &pairs, &triangles, &noise};
    return table;
}

Result<const ConversionInfo*> find_conversion(std::string_view id) {
    return guard_memory([&]() -> Result<const ConversionInfo*> {
        std::string known;
        for (const ConversionInfo* info : conversions()) {
            if (id == info->id) return info;
            known += (known.empty() ? "" : ", ") + std::string(info->id);
        }
        return Error{ErrorCode::bad_argument, "there is no conversion '" + std::string(id) + "'; known are " + known};
    });
}

Result<PolygonMesh> convert(const PolygonMesh& mesh, std::string_view id, Settings settings) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        const auto info = find_conversion(id);
        if (!info) return info.error();
        const auto values = parse_settings("conversion '" + std::string(id) + "'", (*info)->parameters, settings);
        if (!values) return values.error();
        return (*info)->convert(mesh, *values);
    });
}

}  // namespace polylap

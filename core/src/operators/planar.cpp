#include "polylap/operators/planar.hpp"

#include <array>

#include "operators/assemble_faces.hpp"
#include "polylap/face/triangulate_mesh.hpp"
#include "polylap/operators/mass.hpp"

namespace polylap {
namespace {

/// Adds ½ cot of each angle of a counter-clockwise triangle to the side opposite (Pinkall & Polthier 1993; Herholz
/// 2012, eq. 3.16).
void add_cotan(std::span<const Eigen::Vector2d> points, const Triangle& t, LocalMatrix& s) {
    for (std::size_t k = 0; k < 3; ++k) {
        const Index i = t[(k + 1) % 3];
        const Index j = t[(k + 2) % 3];
        const Eigen::Vector2d u = points[static_cast<std::size_t>(i)] - points[static_cast<std::size_t>(t[k])];
        const Eigen::Vector2d v = points[static_cast<std::size_t>(j)] - points[static_cast<std::size_t>(t[k])];
        const double w = 0.5 * u.dot(v) / (u.x() * v.y() - u.y() * v.x());
        s(i, i) += w;
        s(j, j) += w;
        s(i, j) -= w;
        s(j, i) -= w;
    }
}

class LocalStiffness {
public:
    explicit LocalStiffness(TriangulationRule rule) : rule_(rule) {}

    Status operator()(std::span<const Index>, Corners corners, LocalMatrix& s) {
        if (!project_maximally(corners, projection_)) {
            return Error{ErrorCode::degenerate_face, "its vector area is zero"};
        }
        if (Status status = triangulate_polygon(projection_.points, rule_, triangles_); !status) return status;
        for (const Triangle& t : triangles_) {
            add_cotan(projection_.points, t, s);
        }
        return Done{};
    }

private:
    TriangulationRule rule_;
    Projection projection_;
    std::vector<Triangle> triangles_;
};

constexpr std::array parameters{
    choice_parameter("rule", "rule", triangulation_rule_names, "how the projected face is triangulated")};

}  // namespace

Result<SparseMatrix> planar_stiffness(const PolygonMesh& mesh, PlanarOptions options, Monitor monitor) {
    return assemble_faces(mesh, monitor, LocalStiffness(options.rule));
}

constinit const OperatorInfo planar_info{
    .id = "planar",
    .label = "Planar",
    .formula_latex = R"(w_{ij} = \tfrac12\left(\cot\gamma_{ij} + \cot\gamma_{ji}\right))",
    .citation =
        "P. Herholz: General discrete Laplace operators on polygonal meshes. Diploma thesis, Humboldt-Universität zu "
        "Berlin, 2012, section 4.2.4",
    .summary =
        "Each face is projected along its vector area and triangulated there; the cotangents of its triangles are "
        "summed.",
    .parameters = parameters,
    .claims = {.symmetric = {Claim::yes, "cotangents weigh both directions of an edge alike"},
               .local = {Claim::yes, "a sum over faces"},
               .positive_weights = {Claim::no, "two angles opposite an edge can exceed 180° in sum"},
               .positive_semidefinite = {Claim::yes, "each triangle adds a Dirichlet energy"},
               .constants_in_kernel = {Claim::yes, "only differences along edges enter"},
               .linear_precision = {Claim::yes, "planar faces are projected onto themselves"},
               .maximum_principle = {Claim::no, "a negative weight lets values overshoot"},
               .convergent = {Claim::yes, "linear finite elements on the projected triangles"}},
    .build =
        [](const PolygonMesh& mesh, const OperatorSpec& spec, Monitor monitor) {
            const PlanarOptions options{static_cast<TriangulationRule>(static_cast<int>(spec.values[0]))};
            return with_lumped_mass(mesh, planar_stiffness(mesh, options, monitor));
        },
};

}  // namespace polylap

#include "apply/refined_families.hpp"

#include <array>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "polylap/mesh/shapes.hpp"
#include "polylap/mesh/topology.hpp"

namespace polylap {
namespace {

using Setting = std::pair<std::string, std::string>;

Result<PolygonMesh> shape(const char* id, std::initializer_list<std::pair<const char*, int>> counts) {
    std::vector<Setting> settings;
    for (const auto& [name, count] : counts) {
        settings.emplace_back(name, std::to_string(count));
    }
    return make_shape(id, settings);
}

/// Moves inner vertices within the plane by up to a fifth of their shortest edge each way, so that no order of the
/// grid survives refinement: operators that converge only on regular meshes are found out.
Result<PolygonMesh> shake(const PolygonMesh& mesh) {
    const Topology topology = build_topology(*mesh.connectivity());
    Vector reach = Vector::Constant(mesh.vertex_count(), std::numeric_limits<double>::infinity());
    for (const Edge& e : topology.edges) {
        const double length = (mesh.position(e.v1) - mesh.position(e.v0)).norm();
        for (const Index v : {e.v0, e.v1}) {
            reach[v] = std::min(reach[v], 0.2 * length);
        }
    }
    for (const Index v : topology.boundary_vertices) {
        reach[v] = 0;
    }
    std::mt19937 random(1);
    const auto uniform = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };  // [-1, 1)
    Points positions = mesh.positions();
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        positions(v, 0) += reach[v] * uniform();
        positions(v, 1) += reach[v] * uniform();
    }
    return mesh.with_positions(std::move(positions));
}

Result<PolygonMesh> quads(int level) {
    const auto grid = shape("skew-grid", {{"nx", 8 << level}, {"ny", 8 << level}});
    return grid ? shake(*grid) : grid;
}

/// Each quad cut along its first corner's diagonal, which leaves obtuse angles.
Result<PolygonMesh> triangles(int level) {
    auto mesh = quads(level);
    if (!mesh) return mesh;
    std::vector<Index> offsets{0};
    std::vector<Index> corners;
    for (Index f = 0; f < mesh->face_count(); ++f) {
        const auto q = mesh->face(f);
        corners.insert(corners.end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
        offsets.push_back(offsets.back() + 3);
        offsets.push_back(offsets.back() + 3);
    }
    return PolygonMesh::create(mesh->positions(), std::move(offsets), std::move(corners));
}

constexpr std::array families{
    Family{"skewed, uneven triangles", false, triangles},
    Family{"skewed, uneven quads", false, quads},
    Family{"Voronoi cells", false,
           [](int level) {
               return shape("voronoi", {{"nx", 6 << level}, {"ny", 6 << level}});
           }},
    Family{"concave hexagons", false,
           [](int level) {
               return shape("concave-hexagons", {{"nx", 4 << level}, {"ny", 8 << level}});
           }},
    Family{"sphere of triangles", true,
           [](int level) {
               return shape("ico-sphere", {{"level", level + 1}});
           }},
    Family{"sphere of meridians", true,
           [](int level) {
               return shape("uv-sphere", {{"nu", 12 << level}, {"nv", 6 << level}});
           }},
    Family{"sphere of quads", true,
           [](int level) {
               return shape("cube-sphere", {{"n", 4 << level}});
           }},
    Family{"sphere of hexagons", true,
           [](int level) {
               return shape("hexagon-sphere", {{"level", level + 1}});
           }},
};

}  // namespace

std::span<const Family> refined_families() noexcept {
    return families;
}

}  // namespace polylap

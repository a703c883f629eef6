#include "polylap/apply/noise.hpp"

#include <cmath>
#include <random>
#include <vector>

#include "polylap/face/vector_area.hpp"
#include "polylap/mesh/topology.hpp"

namespace polylap {

Result<PolygonMesh> add_normal_noise(const PolygonMesh& mesh, double amplitude, std::uint32_t seed) {
    if (!std::isfinite(amplitude)) return Error{ErrorCode::bad_argument, "the amplitude of the noise must be finite"};
    return guard_memory([&]() -> Result<PolygonMesh> {
        Points normals = Points::Zero(mesh.vertex_count(), 3);
        std::vector<Vector3> corners;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            gather_corners(mesh, f, corners);
            const Vector3 a = vector_area(corners);
            for (const Index v : mesh.face(f)) {
                normals.row(v) += a.transpose();
            }
        }
        const Topology topology = build_topology(*mesh.connectivity());
        double length = 0;
        for (const Edge& e : topology.edges) {
            length += (mesh.position(e.v1) - mesh.position(e.v0)).norm();
        }
        length /= static_cast<double>(topology.edges.size());

        // std::uniform_real_distribution differs between standard libraries; the engine does not.
        std::mt19937 random(seed);
        Points positions = mesh.positions();
        for (Index v = 0; v < mesh.vertex_count(); ++v) {
            const double value = static_cast<double>(random()) * 0x1p-31 - 1;
            positions.row(v) += amplitude * length * value * normals.row(v).stableNormalized();
        }
        return mesh.with_positions(std::move(positions));
    });
}

}  // namespace polylap

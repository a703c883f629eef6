#include "polylap/face/triangulate_mesh.hpp"

#include <string>

#include "polylap/face/vector_area.hpp"

namespace polylap {

Result<PolygonMesh> triangulate_mesh(const PolygonMesh& mesh, TriangulationRule rule, Monitor monitor) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        constexpr Index faces_per_tick = 4096;
        const auto fail = [](Index f, const Error& error) {
            return Error{error.code, "face " + std::to_string(f) + ": " + error.message, f};
        };
        std::vector<Index> offsets{0};
        std::vector<Index> corners;
        std::vector<Vector3> points;
        std::vector<Triangle> triangles;
        Projection projection;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            if (f % faces_per_tick == 0 && !monitor.proceed(static_cast<double>(f) / mesh.face_count())) {
                return Error{ErrorCode::cancelled, "cancelled"};
            }
            gather_corners(mesh, f, points);
            if (!project_maximally(points, projection)) {
                return fail(f, {ErrorCode::degenerate_face, "its vector area is zero"});
            }
            if (Status status = triangulate_polygon(projection.points, rule, triangles); !status) {
                return fail(f, status.error());
            }
            for (const Triangle& t : triangles) {
                for (const Index corner : t) {
                    corners.push_back(mesh.face(f)[static_cast<std::size_t>(corner)]);
                }
                offsets.push_back(static_cast<Index>(corners.size()));
            }
        }
        return PolygonMesh::create(mesh.positions(), std::move(offsets), std::move(corners));
    });
}

Index face_of_triangle(const PolygonMesh& mesh, Index triangle) {
    Index f = 0;
    while (f + 1 < mesh.face_count() && triangle >= static_cast<Index>(mesh.face(f).size()) - 2) {
        triangle -= static_cast<Index>(mesh.face(f).size()) - 2;
        ++f;
    }
    return f;
}

}  // namespace polylap

#include "operators/triangulated.hpp"

#include "operators/triangle_sum.hpp"
#include "operators/vertex_weights.hpp"

namespace polylap {
namespace {

inline Eigen::Matrix3d weighted_cotan(const FaceTriangle& triangle, std::span<const double> weights) {
    const auto corner = [&](std::size_t k) { return static_cast<std::size_t>(triangle.corners[k % 3]); };
    const auto x = [&](std::size_t k) -> const Vector3& { return triangle.x[corner(k)]; };
    const auto omega = [&](std::size_t k) { return weights[static_cast<std::size_t>(triangle.vertices[corner(k)])]; };
    const double half_inverse = 0.5 / safe_norm((x(1) - x(0)).cross(x(2) - x(0)));
    Vector3 w;
    for (std::size_t k = 0; k < 3; ++k) {
        double& value = w[static_cast<Eigen::Index>(k)];
        value = (x(k + 1) - x(k)).dot(x(k + 2) - x(k)) * half_inverse;
        if (weights.empty()) continue;
        const Vector3 edge = x(k + 2) - x(k + 1);
        const double foot = edge.dot(x(k) - x(k + 1)) / edge.squaredNorm();
        // Differences, so that a constant weight changes nothing.
        value += (omega(k + 1) - omega(k) + foot * (omega(k + 2) - omega(k + 1))) * half_inverse;
    }
    return triangle_laplacian(w);
}

}  // namespace

Result<CutFaces> cut_large_faces(const PolygonMesh& mesh, TriangulationRule rule, Monitor monitor) {
    return guard_memory([&]() -> Result<CutFaces> {
        CutFaces cut{.offsets = {0}, .corners = {}, .triangles = {}};
        std::vector<Vector3> x;
        std::vector<Triangle> triangles;
        Projection projection;
        const auto add = [&cut](std::span<const Index> cell) {
            cut.corners.insert(cut.corners.end(), cell.begin(), cell.end());
            cut.offsets.push_back(static_cast<Index>(cut.corners.size()));
        };
        Status status = for_faces(mesh, monitor, [&](Index f) -> Status {
            const auto face = mesh.face(f);
            if (face.size() <= largest_whole_face) {
                add(face);
                return Done{};
            }
            gather_corners(mesh, f, x);
            if (!project_maximally(x, projection)) {
                return Error{ErrorCode::degenerate_face, "its vector area is zero"};
            }
            if (Status done = triangulate_polygon(projection.points, rule, triangles); !done) return done;
            for (const Triangle& t : triangles) {
                const auto vertex = [&](std::size_t k) { return face[static_cast<std::size_t>(t[k])]; };
                add(std::array{vertex(0), vertex(1), vertex(2)});
            }
            cut.triangles.insert(cut.triangles.end(), triangles.begin(), triangles.end());
            return Done{};
        });
        if (!status) return status.error();
        return cut;
    });
}

Status triangulated_operator(const PolygonMesh& mesh, std::span<const double> weights, TriangulationRule rule,
                             MassRule mass, OperatorMatrices& out, Monitor monitor) {
    if (Status status = check_vertex_weights(mesh, weights); !status) return status;
    const auto cotan = [weights](const FaceTriangle& t) { return weighted_cotan(t, weights); };
    if (mass != MassRule::galerkin) return assemble_triangles(mesh, rule, mass, cotan, out, monitor);
    Stretch first{monitor, 0, 0.5};
    Stretch second{monitor, 0.5, 1};
    // Its hat functions overlap wherever the stiffness has an entry: the mass is assembled in the same way.
    const auto hats = [](const FaceTriangle& t) { return galerkin_mass(t.x, t.corners); };
    if (Status status = assemble_triangles(mesh, rule, MassRule::lumped, hats, out, first.monitor()); !status) {
        return status;
    }
    SparseMatrix assembled;
    assembled.swap(out.stiffness);
    Status status = assemble_triangles(mesh, rule, MassRule::lumped, cotan, out, second.monitor());
    out.mass.swap(assembled);
    return status;
}

}  // namespace polylap

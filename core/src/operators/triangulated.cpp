#include "operators/triangulated.hpp"

#include <Eigen/Geometry>

#include "operators/assemble_faces.hpp"
#include "operators/vertex_weights.hpp"

namespace polylap {
namespace {

void add_weighted_cotan(std::span<const Index> vertices, Corners x, std::span<const double> weights, LocalMatrix& s) {
    const double twice_area = (x[1] - x[0]).cross(x[2] - x[0]).stableNorm();
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3;
        const std::size_t j = (k + 2) % 3;
        double w = 0.5 * (x[i] - x[k]).dot(x[j] - x[k]) / twice_area;
        if (!weights.empty()) {
            const Vector3 edge = x[j] - x[i];
            const double foot = edge.dot(x[k] - x[i]) / edge.squaredNorm();
            const auto omega = [&](std::size_t corner) { return weights[static_cast<std::size_t>(vertices[corner])]; };
            // Differences, so that a constant weight changes nothing.
            w += (omega(i) - omega(k) + foot * (omega(j) - omega(i))) / (2 * twice_area);
        }
        const auto a = static_cast<Index>(i);
        const auto b = static_cast<Index>(j);
        s(a, a) += w;
        s(b, b) += w;
        s(a, b) -= w;
        s(b, a) -= w;
    }
}

}  // namespace

Result<OperatorMatrices> triangulated_operator(const PolygonMesh& mesh, std::span<const double> weights,
                                               TriangulationRule rule, MassRule mass, Monitor monitor) {
    if (Status status = check_vertex_weights(mesh, weights); !status) return status.error();
    return guard_memory([&]() -> Result<OperatorMatrices> {
        Stretch cutting{monitor, 0, 0.5};
        const auto triangles = triangulate_mesh(mesh, rule, cutting.monitor());
        if (!triangles) return triangles.error();
        Stretch summing{monitor, 0.5, 1};
        auto stiffness = assemble_faces(*triangles, summing.monitor(),
                                        [&](std::span<const Index> face, Corners x, LocalMatrix& s) -> Status {
                                            add_weighted_cotan(face, x, weights, s);
                                            return Done{};
                                        });
        if (!stiffness) {
            const Error& error = stiffness.error();
            if (error.code != ErrorCode::degenerate_face) return error;
            const Index f = face_of_triangle(mesh, static_cast<Index>(error.element));
            return Error{error.code, "face " + std::to_string(f) + ": one of its triangles is too thin or too large",
                         f};
        }
        auto built = surface_mass(mesh, *triangles, mass);
        if (!built) return built.error();
        return OperatorMatrices{*std::move(stiffness), *std::move(built)};
    });
}

}  // namespace polylap

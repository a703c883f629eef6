#include "polylap/operators/mass.hpp"

#include <algorithm>
#include <string>

#include <Eigen/Geometry>

#include "polylap/face/vector_area.hpp"

namespace polylap {

Result<SparseMatrix> lumped_mass(const PolygonMesh& mesh) {
    return guard_memory([&]() -> Result<SparseMatrix> {
        Vector mass = Vector::Zero(mesh.vertex_count());
        std::vector<Vector3> corners;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            gather_corners(mesh, f, corners);
            const double share = vector_area(corners).stableNorm() / static_cast<double>(corners.size());
            for (const Index v : mesh.face(f)) {
                mass[v] += share;
            }
        }
        return SparseMatrix(mass.asDiagonal());
    });
}

Result<OperatorMatrices> with_lumped_mass(const PolygonMesh& mesh, Result<SparseMatrix> stiffness) {
    if (!stiffness) return stiffness.error();
    auto mass = lumped_mass(mesh);
    if (!mass) return mass.error();
    return OperatorMatrices{*std::move(stiffness), *std::move(mass)};
}

namespace {

/// What a triangle adds to its three corners. @param area of it
Vector3 corner_masses(Corners x, double area, MassRule rule) {
    if (rule == MassRule::barycentric) return Vector3::Constant(area / 3);
    if (rule == MassRule::ring) return Vector3::Constant(2 * area);
    Vector3 dot;     // of the edges that meet at each corner
    Vector3 shares;  // ½ dot · |opposite edge|² / 2A = ½ cot γ |e|²
    for (int k = 0; k < 3; ++k) {
        const auto at = [x, k](int step) { return x[static_cast<std::size_t>((k + step) % 3)]; };
        dot[k] = (at(1) - at(0)).dot(at(2) - at(0));
        shares[k] = dot[k] / (4 * area) * (at(2) - at(1)).squaredNorm();
    }
    if (rule == MassRule::mixed_voronoi && dot.minCoeff() < 0) {
        Eigen::Index obtuse = 0;
        dot.minCoeff(&obtuse);
        Vector3 masses = Vector3::Constant(area / 4);
        masses[obtuse] = area / 2;
        return masses;
    }
    // Each edge's share of the area, half to each end.
    return 0.25 * (shares.sum() - shares.array());
}

}  // namespace

Result<SparseMatrix> surface_mass(const PolygonMesh& mesh, const PolygonMesh& triangles, MassRule rule) {
    if (rule == MassRule::lumped) return lumped_mass(mesh);
    return guard_memory([&]() -> Result<SparseMatrix> {
        Vector diagonal = Vector::Zero(triangles.vertex_count());
        std::vector<Eigen::Triplet<double, Index>> entries;
        std::vector<Vector3> x;
        for (Index f = 0; f < triangles.face_count(); ++f) {
            const auto face = triangles.face(f);
            if (face.size() != 3) {
                return Error{ErrorCode::bad_argument, "face " + std::to_string(f) + " is no triangle", f};
            }
            gather_corners(triangles, f, x);
            const double area = 0.5 * (x[1] - x[0]).cross(x[2] - x[0]).stableNorm();
            if (rule == MassRule::galerkin) {
                for (const Index i : face) {
                    for (const Index j : face) {
                        entries.emplace_back(i, j, i == j ? area / 6 : area / 12);
                    }
                }
                continue;
            }
            const Vector3 masses = corner_masses(x, area, rule);
            for (int k = 0; k < 3; ++k) {
                diagonal[face[static_cast<std::size_t>(k)]] += masses[k];
            }
        }
        if (rule != MassRule::galerkin) return SparseMatrix(diagonal.asDiagonal());
        SparseMatrix sum(triangles.vertex_count(), triangles.vertex_count());
        sum.setFromTriplets(entries.begin(), entries.end());
        return sum;
    });
}

}  // namespace polylap

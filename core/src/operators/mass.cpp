#include "polylap/operators/mass.hpp"

#include <algorithm>
#include <string>

#include <Eigen/Geometry>

#include "base/safe_norm.hpp"
#include "operators/corner_masses.hpp"
#include "operators/sparse_pattern.hpp"

namespace polylap {

void assemble_lumped_mass(const PolygonMesh& mesh, SparseMatrix& out) {
    set_diagonal(mesh.vertex_count(), out);
    double* const mass = out.valuePtr();
    std::vector<Vector3> corners;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        gather_corners(mesh, f, corners);
        const double share = safe_norm(vector_area(corners)) / static_cast<double>(corners.size());
        for (const Index v : mesh.face(f)) {
            mass[v] += share;
        }
    }
}

Result<SparseMatrix> lumped_mass(const PolygonMesh& mesh) {
    return guard_memory([&]() -> Result<SparseMatrix> {
        SparseMatrix mass;
        assemble_lumped_mass(mesh, mass);
        return mass;
    });
}

namespace {

double area_of(Corners x, const Triangle& t) {
    const auto at = [&](std::size_t k) -> const Vector3& { return x[static_cast<std::size_t>(t[k])]; };
    return 0.5 * safe_norm((at(1) - at(0)).cross(at(2) - at(0)));
}

}  // namespace

Vector3 corner_masses(Corners x, const Triangle& triangle, MassRule rule) {
    const double area = area_of(x, triangle);
    if (rule == MassRule::barycentric) return Vector3::Constant(area / 3);
    if (rule == MassRule::ring) return Vector3::Constant(2 * area);
    Vector3 dot;     // of the edges that meet at each corner
    Vector3 shares;  // ½ dot · |opposite edge|² / 2A = ½ cot γ |e|²
    for (std::size_t k = 0; k < 3; ++k) {
        const auto at = [&](std::size_t step) { return x[static_cast<std::size_t>(triangle[(k + step) % 3])]; };
        const auto corner = static_cast<Eigen::Index>(k);
        dot[corner] = (at(1) - at(0)).dot(at(2) - at(0));
        shares[corner] = dot[corner] / (4 * area) * (at(2) - at(1)).squaredNorm();
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

Eigen::Matrix3d galerkin_mass(Corners x, const Triangle& triangle) {
    const double area = area_of(x, triangle);
    return Eigen::Matrix3d::Constant(area / 12) + Eigen::Matrix3d::Identity() * (area / 12);
}

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
            if (rule == MassRule::galerkin) {
                const Eigen::Matrix3d local = galerkin_mass(x, {0, 1, 2});
                for (std::size_t i = 0; i < 3; ++i) {
                    for (std::size_t j = 0; j < 3; ++j) {
                        entries.emplace_back(face[i], face[j],
                                             local(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
                    }
                }
                continue;
            }
            const Vector3 masses = corner_masses(x, {0, 1, 2}, rule);
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

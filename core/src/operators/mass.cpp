#include "polylap/operators/mass.hpp"

#include "polylap/face/vector_area.hpp"

namespace polylap {
namespace {

Vector lumped_mass(const PolygonMesh& mesh) {
    Vector mass = Vector::Zero(mesh.vertex_count());
    std::vector<Vector3> corners;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        gather_corners(mesh, f, corners);
        const double share = vector_area(corners).stableNorm() / static_cast<double>(corners.size());
        for (const Index v : mesh.face(f)) {
            mass[v] += share;
        }
    }
    return mass;
}

}  // namespace

Result<SparseMatrix> mass_matrix(const PolygonMesh& mesh, Mass mass) {
    return guard_memory([&]() -> Result<SparseMatrix> {
        switch (mass) {
            case Mass::lumped:
                return SparseMatrix(lumped_mass(mesh).asDiagonal());
        }
        return Error{ErrorCode::bad_argument, "unknown mass"};
    });
}

Result<OperatorMatrices> with_mass(const PolygonMesh& mesh, Result<SparseMatrix> stiffness, Mass mass) {
    if (!stiffness) return stiffness.error();
    auto m = mass_matrix(mesh, mass);
    if (!m) return m.error();
    return OperatorMatrices{*std::move(stiffness), *std::move(m)};
}

}  // namespace polylap

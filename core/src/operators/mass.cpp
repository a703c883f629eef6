#include "polylap/operators/mass.hpp"

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

}  // namespace polylap

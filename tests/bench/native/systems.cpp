#include "systems.hpp"

namespace polylap::bench {

OperatorMatrices build(const PolygonMesh& mesh, const char* id) {
    return opened(build_operator(mesh, {.id = id, .values = {}}));
}

double squared_edge(const PolygonMesh& mesh) {
    double sum = 0;
    double count = 0;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            sum += (mesh.position(face[i]) - mesh.position(face[(i + 1) % face.size()])).squaredNorm();
            ++count;
        }
    }
    return sum / count;
}

System smoothing_system(const PolygonMesh& mesh) {
    const OperatorMatrices matrices = build(mesh);
    System system;
    system.a = matrices.mass + squared_edge(mesh) * matrices.stiffness;
    system.a.makeCompressed();
    system.positions = mesh.positions();
    system.rhs = matrices.mass * mesh.positions();
    return system;
}

}  // namespace polylap::bench

#include "polylap/mesh/shapes.hpp"

#include "mesh/shape_builder.hpp"

namespace polylap {

Result<PolygonMesh> make_shape(std::string_view id, Settings settings) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        const auto info = find_shape(id);
        if (!info) return info.error();
        const auto values = parse_settings("shape '" + std::string(id) + "'", (*info)->parameters, settings);
        if (!values) return values.error();
        return (*info)->make(*values);
    });
}

void MeshBuilder::add(const PolygonMesh& mesh, const Vector3& shift) {
    const auto first = static_cast<Index>(points.size());
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        vertex(mesh.position(v) + shift);
    }
    for (Index f = 0; f < mesh.face_count(); ++f) {
        for (const Index v : mesh.face(f)) {
            corners.push_back(first + v);
        }
        offsets.push_back(static_cast<Index>(corners.size()));
    }
}

Result<PolygonMesh> MeshBuilder::finish() && {
    Points positions(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v) {
        positions.row(static_cast<Eigen::Index>(v)) = points[v].transpose();
    }
    return PolygonMesh::create(std::move(positions), std::move(offsets), std::move(corners));
}

}  // namespace polylap

#include "polylap/mesh/shapes.hpp"

#include <array>

#include "mesh/shape_builder.hpp"

namespace polylap {

// THE shape table: one line per shape, in the order of the menus.
std::span<const ShapeInfo* const> shapes() noexcept {
    static constexpr std::array table{
        &grid_shape,        &skew_grid_shape,    &saddle_shape,         &torus_shape,
        &uv_sphere_shape,   &ico_sphere_shape,   &hexagon_sphere_shape, &cube_shape,
        &cube_sphere_shape, &cylinder_shape,     &disc_shape,           &concave_hexagons_shape,
        &voronoi_shape,     &l_tiles_shape,      &tetris_shape,         &polygon_shape,
        &star_shape,        &wavy_polygon_shape, &trapezium_shape,      &two_components_shape,
    };
    return table;
}

Result<const ShapeInfo*> find_shape(std::string_view id) {
    return guard_memory([&]() -> Result<const ShapeInfo*> {
        std::string known;
        for (const ShapeInfo* info : shapes()) {
            if (id == info->id) return info;
            known += (known.empty() ? "" : ", ") + std::string(info->id);
        }
        return Error{ErrorCode::bad_argument, "there is no shape '" + std::string(id) + "'; known are " + known};
    });
}

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

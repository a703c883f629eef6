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

}  // namespace polylap

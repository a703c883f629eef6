#pragma once

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <span>
#include <vector>

#include "polylap/mesh/shapes.hpp"

// What the files of shapes share, and what each of them hands to the table.

namespace polylap {

/// Collects vertices and faces one by one.
struct MeshBuilder {
    std::vector<Vector3> points;
    std::vector<Index> offsets{0};
    std::vector<Index> corners;

    Index vertex(const Vector3& p) {
        points.push_back(p);
        return static_cast<Index>(points.size()) - 1;
    }
    void face(std::span<const Index> vertices) {
        corners.insert(corners.end(), vertices.begin(), vertices.end());
        offsets.push_back(static_cast<Index>(corners.size()));
    }
    void face(std::initializer_list<Index> vertices) { face(std::span(vertices.begin(), vertices.size())); }
    /// Adds a copy of a mesh, moved by `shift`.
    void add(const PolygonMesh& mesh, const Vector3& shift);
    Result<PolygonMesh> finish() &&;
};

/// The number of vertices must fit an Index.
inline bool fits(Index rows, Index columns) {
    return static_cast<std::int64_t>(rows) * columns <= std::numeric_limits<Index>::max() / 4;
}

inline bool is_length(double x) {
    return std::isfinite(x) && x > 0;
}

/// A number of cells, corners or levels. Its upper limit keeps a mesh within some millions of vertices.
constexpr Parameter count_parameter(const char* id, const char* label, Index min, Index max, Index slider_max,
                                    Index initial, const char* hint = "") {
    return {.id = id,
            .label = label,
            .kind = Parameter::Kind::integer,
            .min = static_cast<double>(min),
            .max = static_cast<double>(max),
            .slider_max = static_cast<double>(slider_max),
            .step = 1,
            .initial = static_cast<double>(initial),
            .hint = hint};
}

constexpr Parameter real_parameter(const char* id, const char* label, double min, double max, double slider_max,
                                   double step, double initial, const char* hint = "") {
    return {.id = id,
            .label = label,
            .kind = Parameter::Kind::real,
            .min = min,
            .max = max,
            .slider_max = slider_max,
            .step = step,
            .initial = initial,
            .hint = hint};
}

constexpr Parameter length_parameter(const char* id, const char* label, double initial) {
    return real_parameter(id, label, 0.01, 1e6, 10, 0.01, initial);
}

constexpr Parameter seed_parameter() {
    return count_parameter("seed", "seed", 0, std::numeric_limits<Index>::max(), 100, 1,
                           "another seed, another mesh; the same on every platform");
}

inline Index count_of(double value) {
    return static_cast<Index>(value);
}

extern const ShapeInfo grid_shape;
extern const ShapeInfo skew_grid_shape;
extern const ShapeInfo saddle_shape;
extern const ShapeInfo torus_shape;
extern const ShapeInfo uv_sphere_shape;
extern const ShapeInfo ico_sphere_shape;
extern const ShapeInfo hexagon_sphere_shape;
extern const ShapeInfo cube_shape;
extern const ShapeInfo cube_sphere_shape;
extern const ShapeInfo cylinder_shape;
extern const ShapeInfo disc_shape;
extern const ShapeInfo concave_hexagons_shape;
extern const ShapeInfo voronoi_shape;
extern const ShapeInfo l_tiles_shape;
extern const ShapeInfo tetris_shape;
extern const ShapeInfo polygon_shape;
extern const ShapeInfo star_shape;
extern const ShapeInfo wavy_polygon_shape;
extern const ShapeInfo trapezium_shape;
extern const ShapeInfo two_components_shape;

}  // namespace polylap

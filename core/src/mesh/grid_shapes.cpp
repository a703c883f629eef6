#include <cmath>
#include <numbers>

#include "mesh/shape_builder.hpp"

namespace polylap {
namespace {

std::vector<Index> quad_offsets(Index faces) {
    std::vector<Index> offsets(static_cast<std::size_t>(faces) + 1);
    for (Index f = 0; f <= faces; ++f) {
        offsets[static_cast<std::size_t>(f)] = 4 * f;
    }
    return offsets;
}

}  // namespace

Result<PolygonMesh> make_grid(Index nx, Index ny, double width, double height) {
    if (nx < 1 || ny < 1 || !fits(nx, ny) || !is_length(width) || !is_length(height)) {
        return Error{ErrorCode::bad_argument, "a grid needs at least one cell each way and a positive size"};
    }
    return guard_memory([&]() -> Result<PolygonMesh> {
        Points positions((nx + 1) * (ny + 1), 3);
        for (Index j = 0; j <= ny; ++j) {
            for (Index i = 0; i <= nx; ++i) {
                positions.row(j * (nx + 1) + i) << width * i / nx, height * j / ny, 0;
            }
        }
        std::vector<Index> corners;
        for (Index j = 0; j < ny; ++j) {
            for (Index i = 0; i < nx; ++i) {
                const Index v = j * (nx + 1) + i;
                corners.insert(corners.end(), {v, v + 1, v + nx + 2, v + nx + 1});
            }
        }
        return PolygonMesh::create(std::move(positions), quad_offsets(nx * ny), std::move(corners));
    });
}

Result<PolygonMesh> make_saddle(Index n, double height) {
    if (!std::isfinite(height)) return Error{ErrorCode::bad_argument, "the height of a saddle must be finite"};
    return guard_memory([&]() -> Result<PolygonMesh> {
        auto grid = make_grid(n, n);
        if (!grid) return grid;
        Points positions = grid->positions();
        for (auto p : positions.rowwise()) {
            p.head<2>().array() -= 0.5;
            p.z() = 2 * height * (p.x() * p.x() - p.y() * p.y());
        }
        return grid->with_positions(std::move(positions));
    });
}

Result<PolygonMesh> make_torus(Index nu, Index nv, double major, double minor) {
    if (nu < 3 || nv < 3 || !fits(nu, nv)) {
        return Error{ErrorCode::bad_argument, "a torus needs at least three quads each way"};
    }
    if (!is_length(major) || !is_length(minor) || minor >= major) {
        return Error{ErrorCode::bad_argument, "the radii of a torus must fit major > minor > 0"};
    }
    return guard_memory([&]() -> Result<PolygonMesh> {
        Points positions(nu * nv, 3);
        for (Index i = 0; i < nu; ++i) {
            const double u = 2 * std::numbers::pi * i / nu;
            for (Index j = 0; j < nv; ++j) {
                const double v = 2 * std::numbers::pi * j / nv;
                const double r = major + minor * std::cos(v);
                positions.row(i * nv + j) << r * std::cos(u), r * std::sin(u), minor * std::sin(v);
            }
        }
        std::vector<Index> corners;
        for (Index i = 0; i < nu; ++i) {
            const Index right = (i + 1) % nu;
            for (Index j = 0; j < nv; ++j) {
                const Index up = (j + 1) % nv;
                corners.insert(corners.end(), {i * nv + j, right * nv + j, right * nv + up, i * nv + up});
            }
        }
        return PolygonMesh::create(std::move(positions), quad_offsets(nu * nv), std::move(corners));
    });
}

namespace {

constexpr Index most_cells = 2000;

constexpr std::array grid_parameters{
    count_parameter("nx", "cells along x", 1, most_cells, 64, 8),
    count_parameter("ny", "cells along y", 1, most_cells, 64, 8),
    length_parameter("width", "width", 1),
    length_parameter("height", "height", 1),
};
constexpr std::array saddle_parameters{
    count_parameter("n", "cells a side", 1, most_cells, 64, 12),
    real_parameter("height", "height", 0, 1e6, 4, 0.01, 1, "from the lowest to the highest corner"),
};
constexpr std::array torus_parameters{
    count_parameter("nu", "quads around the hole", 3, most_cells, 128, 32),
    count_parameter("nv", "quads around the tube", 3, most_cells, 64, 16),
    length_parameter("major", "radius of the ring", 1),
    length_parameter("minor", "radius of the tube", 0.4),
};

Result<PolygonMesh> grid_of(std::span<const double> p) {
    return make_grid(count_of(p[0]), count_of(p[1]), p[2], p[3]);
}
Result<PolygonMesh> saddle_of(std::span<const double> p) {
    return make_saddle(count_of(p[0]), p[1]);
}
Result<PolygonMesh> torus_of(std::span<const double> p) {
    return make_torus(count_of(p[0]), count_of(p[1]), p[2], p[3]);
}

}  // namespace

const ShapeInfo grid_shape{"grid", "Grid", "Equal rectangles on a rectangle of the plane.", grid_parameters, grid_of};
const ShapeInfo saddle_shape{"saddle", "Saddle", "A square grid lifted to x² − y²: none of its quads is planar.",
                             saddle_parameters, saddle_of};
const ShapeInfo torus_shape{"torus", "Torus", "Planar quads around a ring; closed.", torus_parameters, torus_of};

}  // namespace polylap

#include "polylap/mesh/shapes.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace polylap {
namespace {

bool is_length(double x) {
    return std::isfinite(x) && x > 0;
}

/// The number of vertices must fit an Index.
bool fits(Index rows, Index columns) {
    return static_cast<std::int64_t>(rows) * columns <= std::numeric_limits<Index>::max() / 4;
}

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

}  // namespace polylap

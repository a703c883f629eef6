#include <cmath>
#include <numbers>

#include "mesh/shape_builder.hpp"

// Open meshes: in the plane z = 0 with their faces looking up, single polygons, and the cylinder.

namespace polylap {
namespace {

constexpr double pi = std::numbers::pi;

/// Where the k-th of n steps ends on [0, 1] when the lengths of steps grow evenly to `stretch` times the first.
double graded(Index k, Index n, double stretch) {
    const double t = static_cast<double>(k) / n;
    return t * (2 + (stretch - 1) * t) / (1 + stretch);
}

Result<PolygonMesh> skew_grid(std::span<const double> p) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        const Index nx = count_of(p[0]);
        const Index ny = count_of(p[1]);
        auto grid = make_grid(nx, ny);
        if (!grid) return grid;
        Points positions = grid->positions();
        for (Index j = 0; j <= ny; ++j) {
            for (Index i = 0; i <= nx; ++i) {
                const double y = graded(j, ny, p[3]);
                positions.row(j * (nx + 1) + i) << graded(i, nx, p[3]) + p[2] * y, y, 0;
            }
        }
        return grid->with_positions(std::move(positions));
    });
}

/// Bricks in a running bond whose long sides are pushed in.
Result<PolygonMesh> concave_hexagons(std::span<const double> p) {
    const Index nx = count_of(p[0]);
    const Index ny = count_of(p[1]);
    return guard_memory([&]() -> Result<PolygonMesh> {
        MeshBuilder mesh;
        const Index columns = 2 * nx + 2;  // points of a line: the bricks of odd rows start at the second
        const double scale = 1.0 / (columns - 1);
        std::vector<Index> number(static_cast<std::size_t>((ny + 1) * columns), -1);
        for (Index j = 0; j <= ny; ++j) {
            for (Index i = 0; i < columns; ++i) {
                // The outermost lines lack a point that only the next row would have used.
                if ((j == 0 && i == columns - 1) || (j == ny && i == (ny % 2 == 1 ? columns - 1 : 0))) continue;
                const double up = (i + j) % 2 == 1 ? p[2] / 2 : -p[2] / 2;
                number[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)] =
                    mesh.vertex({scale * i, scale * (j + up), 0});
            }
        }
        const auto at = [&](Index i, Index j) {
            return number[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                          static_cast<std::size_t>(i)];
        };
        for (Index j = 0; j < ny; ++j) {
            for (Index i = j % 2; i + 2 < columns; i += 2) {
                mesh.face({at(i, j), at(i + 1, j), at(i + 2, j), at(i + 2, j + 1), at(i + 1, j + 1), at(i, j + 1)});
            }
        }
        return std::move(mesh).finish();
    });
}

/// One face whose k-th corner is at `radius(k)` and `height(k)`.
template <class Radius, class Height>
Result<PolygonMesh> one_face(Index n, Radius&& radius, Height&& height) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        MeshBuilder mesh;
        std::vector<Index> face;
        for (Index k = 0; k < n; ++k) {
            const double t = 2 * pi * k / n;
            face.push_back(mesh.vertex({radius(k) * std::cos(t), radius(k) * std::sin(t), height(k)}));
        }
        mesh.face(face);
        return std::move(mesh).finish();
    });
}

double one(Index) {
    return 1;
}
double zero(Index) {
    return 0;
}

Result<PolygonMesh> polygon(std::span<const double> p) {
    return one_face(count_of(p[0]), one, zero);
}

Result<PolygonMesh> star(std::span<const double> p) {
    return one_face(
        2 * count_of(p[0]), [&](Index k) { return k % 2 == 0 ? 1 : p[1]; }, zero);
}

Result<PolygonMesh> wavy_polygon(std::span<const double> p) {
    const Index n = count_of(p[0]);
    return one_face(n, one, [&](Index k) { return p[1] / 2 * std::cos(4 * pi * k / n); });
}

Result<PolygonMesh> trapezium(std::span<const double>) {
    return guard_memory([]() -> Result<PolygonMesh> {
        MeshBuilder mesh;
        mesh.points = {{-2, 0, 0}, {2, 0, 0}, {1, 1, 0}, {-1, 1, 0}};
        mesh.face({0, 1, 2, 3});
        return std::move(mesh).finish();
    });
}

/// A polygon in the middle and rings of quads around it.
Result<PolygonMesh> disc(std::span<const double> p) {
    const Index n = count_of(p[0]);
    const Index rings = count_of(p[1]);
    return guard_memory([&]() -> Result<PolygonMesh> {
        MeshBuilder mesh;
        std::vector<Index> middle;
        for (Index j = 1; j <= rings + 1; ++j) {
            for (Index i = 0; i < n; ++i) {
                const double t = 2 * pi * i / n;
                const double r = static_cast<double>(j) / (rings + 1);
                mesh.vertex({r * std::cos(t), r * std::sin(t), 0});
                if (j == 1) middle.push_back(i);
            }
        }
        mesh.face(middle);
        for (Index j = 0; j < rings; ++j) {
            for (Index i = 0; i < n; ++i) {
                const Index next = (i + 1) % n;
                mesh.face({j * n + i, (j + 1) * n + i, (j + 1) * n + next, j * n + next});
            }
        }
        return std::move(mesh).finish();
    });
}

Result<PolygonMesh> cylinder(std::span<const double> p) {
    const Index nu = count_of(p[0]);
    const Index nv = count_of(p[1]);
    return guard_memory([&]() -> Result<PolygonMesh> {
        MeshBuilder mesh;
        for (Index j = 0; j <= nv; ++j) {
            for (Index i = 0; i < nu; ++i) {
                const double u = 2 * pi * i / nu;
                mesh.vertex({p[2] * std::cos(u), p[2] * std::sin(u), p[3] * j / nv});
            }
        }
        for (Index j = 0; j < nv; ++j) {
            for (Index i = 0; i < nu; ++i) {
                const Index next = (i + 1) % nu;
                mesh.face({j * nu + i, j * nu + next, (j + 1) * nu + next, (j + 1) * nu + i});
            }
        }
        return std::move(mesh).finish();
    });
}

/// A saddle beneath a sphere.
Result<PolygonMesh> two_components(std::span<const double> p) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        auto sheet = make_saddle(count_of(p[0]), 0.5);
        if (!sheet) return sheet;
        auto ball = cube_sphere_shape.make(p);
        if (!ball) return ball;
        MeshBuilder mesh;
        mesh.add(*sheet, Vector3::Zero());
        mesh.add(*ball, Vector3(0, 0, 1.5));
        return std::move(mesh).finish();
    });
}

constexpr std::array skew_parameters{
    count_parameter("nx", "cells along x", 1, 2000, 64, 8),
    count_parameter("ny", "cells along y", 1, 2000, 64, 8),
    real_parameter("shear", "shear", 0, 100, 2, 0.01, 0.5, "how far the upper side is moved along x"),
    real_parameter("stretch", "stretch", 1, 100, 10, 0.1, 3,
                   "how much faster the spacing is at the end than at the start"),
};
constexpr std::array brick_parameters{
    count_parameter("nx", "hexagons a row", 1, 1000, 32, 6),
    count_parameter("ny", "rows", 1, 2000, 64, 12),
    real_parameter("depth", "depth", 0, 0.95, 0.95, 0.01, 0.4, "how far the long sides are pushed in; 0: bricks"),
};
constexpr std::array polygon_parameters{
    count_parameter("n", "corners", 3, 10000, 24, 6),
};
constexpr std::array star_parameters{
    count_parameter("points", "points", 3, 5000, 16, 5),
    real_parameter("inner", "inner radius", 0.05, 1, 1, 0.01, 0.4, "radius of the corners between the points"),
};
constexpr std::array wavy_parameters{
    count_parameter("n", "corners", 4, 10000, 24, 6),
    real_parameter("height", "height", 0, 100, 2, 0.01, 0.5, "from the lowest to the highest corner or nearly so"),
};
constexpr std::array disc_parameters{
    count_parameter("n", "corners a ring", 3, 2000, 64, 12),
    count_parameter("rings", "rings", 0, 2000, 32, 5),
};
constexpr std::array cylinder_parameters{
    count_parameter("nu", "quads around", 3, 2000, 128, 24),
    count_parameter("nv", "quads along", 1, 2000, 64, 8),
    length_parameter("radius", "radius", 0.5),
    length_parameter("height", "height", 1),
};
constexpr std::array component_parameters{
    count_parameter("n", "quads an edge", 1, 500, 32, 6),
};

}  // namespace

const ShapeInfo skew_grid_shape{"skew-grid", "Skewed grid", "Parallelograms of growing size in the plane.",
                                skew_parameters, skew_grid};
const ShapeInfo concave_hexagons_shape{"concave-hexagons", "Concave hexagons",
                                       "The plane tiled by hexagons with two concave corners each.", brick_parameters,
                                       concave_hexagons};
const ShapeInfo polygon_shape{"polygon", "Polygon", "One regular polygon.", polygon_parameters, polygon};
const ShapeInfo star_shape{"star", "Star", "One concave polygon.", star_parameters, star};
const ShapeInfo wavy_polygon_shape{
    "wavy-polygon", "Wavy polygon",
    "One polygon that lies in no plane: regular seen from above, twice up and twice down.", wavy_parameters,
    wavy_polygon};
const ShapeInfo trapezium_shape{"trapezium", "Trapezium", "The face of Herholz 2012, Table 4.1.", {}, trapezium};
const ShapeInfo disc_shape{"disc", "Disc", "A polygon and rings of planar quads around it.", disc_parameters, disc};
const ShapeInfo cylinder_shape{"cylinder", "Cylinder", "Planar quads around a tube that is open at both ends.",
                               cylinder_parameters, cylinder};
const ShapeInfo two_components_shape{"two-components", "Two components", "An open saddle beneath a closed sphere.",
                                     component_parameters, two_components};

}  // namespace polylap

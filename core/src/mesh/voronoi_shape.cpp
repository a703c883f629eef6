#include <algorithm>
#include <cmath>
#include <random>

#include "mesh/shape_builder.hpp"

// The Voronoi cells of a shaken triangular lattice in a rectangle.

namespace polylap {
namespace {

using Point = Eigen::Vector2d;

/// A corner of a cell and what the side that starts there divides it from: a site, or a wall (numbers after the sites).
struct CellCorner {
    Point point;
    Index beyond;
};

const double row_height = std::sqrt(3.0) / 2;

/// Sites at distance about 1 in [0, nx] × [0, ny · row_height].
struct Sites {
    Index nx, ny;
    std::vector<Point> points;

    Sites(Index columns, Index rows, double jitter, std::uint32_t seed) : nx(columns), ny(rows) {
        // std::uniform_real_distribution differs between standard libraries; the engine does not.
        std::mt19937 random(seed);
        const auto shake = [&] { return 0.35 * jitter * (static_cast<double>(random()) * 0x1p-31 - 1); };
        // Sites stay this far inside, so that no cell is a mere sliver at a wall.
        constexpr double margin = 0.05;
        for (Index j = 0; j < ny; ++j) {
            for (Index i = 0; i < nx; ++i) {
                const double x = i + (j % 2 == 0 ? 0.25 : 0.75) + shake();
                const double y = (j + 0.5) * row_height + shake();
                points.emplace_back(std::clamp(x, margin, nx - margin),
                                    std::clamp(y, margin, ny * row_height - margin));
            }
        }
    }

    Index count() const { return static_cast<Index>(points.size()); }
    const Point& operator[](Index s) const { return points[static_cast<std::size_t>(s)]; }
};

/// Cuts off what is nearer to site `other` than to site `s`.
void clip(const Sites& sites, Index s, Index other, std::vector<CellCorner>& cell, std::vector<CellCorner>& kept) {
    const Point across = sites[other] - sites[s];
    const double level = across.dot(sites[s] + sites[other]) / 2;
    kept.clear();
    for (std::size_t k = 0; k < cell.size(); ++k) {
        const CellCorner& a = cell[k];
        const CellCorner& b = cell[k + 1 < cell.size() ? k + 1 : 0];
        const double da = across.dot(a.point) - level;
        const double db = across.dot(b.point) - level;
        if (da <= 0) kept.push_back(a);
        if ((da <= 0) == (db <= 0)) continue;
        const Point cut = a.point + da / (da - db) * (b.point - a.point);
        kept.push_back({cut, da <= 0 ? other : a.beyond});
    }
    cell.swap(kept);
}

/// The cell of site s, counter-clockwise.
void build_cell(const Sites& sites, Index s, std::vector<CellCorner>& cell, std::vector<CellCorner>& kept) {
    const double width = sites.nx;
    const double height = sites.ny * row_height;
    const Index wall = sites.count();
    cell = {{{0, 0}, wall}, {{width, 0}, wall + 1}, {{width, height}, wall + 2}, {{0, height}, wall + 3}};
    const Index i = s % sites.nx;
    const Index j = s / sites.nx;
    // Rings of lattice sites around s, until the next is too far to reach the cell: a site moves by less than half a
    // lattice step, and row_height is the least distance between rings.
    for (Index ring = 1; ring < std::max(sites.nx, sites.ny); ++ring) {
        double reach = 0;
        for (const CellCorner& c : cell) {
            reach = std::max(reach, (c.point - sites[s]).norm());
        }
        if (ring * row_height - 1.5 > 2 * reach) break;
        for (Index v = std::max(j - ring, 0); v <= std::min(j + ring, sites.ny - 1); ++v) {
            const bool whole_row = std::abs(v - j) == ring;
            for (Index u = i - ring; u <= i + ring; u += whole_row ? 1 : 2 * ring) {
                if (u >= 0 && u < sites.nx) clip(sites, s, v * sites.nx + u, cell, kept);
            }
        }
    }
}

/// A corner of the mesh is where three of the sites and walls meet: all cells around it know it by these.
struct Meeting {
    std::array<Index, 3> at;
    std::size_t corner;
    Point point;
};

Result<PolygonMesh> voronoi(std::span<const double> p) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        const Sites sites(count_of(p[0]), count_of(p[1]), p[2], static_cast<std::uint32_t>(p[3]));
        MeshBuilder mesh;
        std::vector<Meeting> meetings;
        std::vector<CellCorner> cell;
        std::vector<CellCorner> kept;
        for (Index s = 0; s < sites.count(); ++s) {
            build_cell(sites, s, cell, kept);
            for (std::size_t k = 0; k < cell.size(); ++k) {
                std::array<Index, 3> at{s, cell[k > 0 ? k - 1 : cell.size() - 1].beyond, cell[k].beyond};
                std::sort(at.begin(), at.end());
                meetings.push_back({at, meetings.size(), cell[k].point});
            }
            mesh.offsets.push_back(static_cast<Index>(meetings.size()));
        }
        std::sort(meetings.begin(), meetings.end(), [](const Meeting& a, const Meeting& b) {
            return std::tie(a.at, a.corner) < std::tie(b.at, b.corner);
        });
        mesh.corners.resize(meetings.size());
        for (std::size_t k = 0; k < meetings.size();) {
            const Meeting& m = meetings[k];
            const Index v = mesh.vertex({m.point.x() / sites.nx, m.point.y() / sites.nx, 0});
            std::ptrdiff_t cells = std::count_if(m.at.begin(), m.at.end(), [&](Index a) { return a < sites.count(); });
            for (; k < meetings.size() && meetings[k].at == m.at; ++k, --cells) {
                mesh.corners[meetings[k].corner] = v;
            }
            if (cells == 0) continue;
            return Error{ErrorCode::bad_mesh, "near cell " + std::to_string(m.at[0]) +
                                                  " four cells meet in what may be one point; take another seed"};
        }
        return std::move(mesh).finish();
    });
}

constexpr std::array voronoi_parameters{
    count_parameter("nx", "cells a row", 1, 1000, 48, 12),
    count_parameter("ny", "rows", 1, 1000, 48, 12),
    real_parameter("jitter", "jitter", 0, 1, 1, 0.01, 0.7, "how far the sites are shaken; 0: regular hexagons"),
    seed_parameter(),
};

}  // namespace

const ShapeInfo voronoi_shape{"voronoi", "Voronoi cells",
                              "Convex polygons of three to about ten corners in a rectangle.", voronoi_parameters,
                              voronoi};

}  // namespace polylap

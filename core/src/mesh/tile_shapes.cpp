#include "mesh/shape_builder.hpp"

// Rectangles cut into tetrominoes: concave polygons of four squares each. All ten lattice points on the boundary of a
// piece are its corners, so that neighbours share whole edges.

namespace polylap {
namespace {

/// A block of pieces: cells with the same letter are one piece. No piece has 2 × 2 cells, so that no lattice point
/// is inside one.
struct Pattern {
    Index width, height;
    const char* cells;  ///< Row by row from y = 0.
};

constexpr Pattern two_l{4, 2,
                        "AAAB"
                        "ABBB"};
constexpr Pattern blocks[] = {
    {4, 4,
     "AAAB"
     "CABB"
     "CCDB"
     "CDDD"},
    {4, 4,
     "AABB"
     "ACDB"
     "ACDB"
     "CCDD"},
    {4, 4,
     "AAAB"
     "ACBB"
     "CCBD"
     "CDDD"},
};

/// The corners of one piece counter-clockwise, in cells from the corner of the block.
std::vector<std::array<Index, 2>> outline(const Pattern& pattern, char piece) {
    const auto inside = [&](Index x, Index y) {
        return x >= 0 && y >= 0 && x < pattern.width && y < pattern.height &&
               pattern.cells[y * pattern.width + x] == piece;
    };
    // Walk with the piece on the left: turn left where possible, so from the lowest leftmost cell along +x.
    std::array<Index, 2> start{};
    while (!inside(start[0], start[1])) {
        if (++start[0] == pattern.width) start = {0, start[1] + 1};
    }
    std::vector<std::array<Index, 2>> corners;
    std::array<Index, 2> at = start;
    std::array<Index, 2> step{1, 0};
    do {
        corners.push_back(at);
        at = {at[0] + step[0], at[1] + step[1]};
        // Of the four cells around `at`: ahead on the right and ahead on the left.
        const auto ahead = [&](Index side) {
            return inside(at[0] + (step[0] - side * step[1] - 1) / 2, at[1] + (step[1] + side * step[0] - 1) / 2);
        };
        if (ahead(-1)) {
            step = {step[1], -step[0]};
        } else if (!ahead(1)) {
            step = {-step[1], step[0]};
        }
    } while (at != start);
    return corners;
}

/// nx × ny blocks of unit squares, scaled to width 1.
template <class PatternAt>
Result<PolygonMesh> tiled(Index nx, Index ny, PatternAt&& pattern_at) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        const Pattern& first = pattern_at(0, 0);
        const Index columns = nx * first.width + 1;
        const Index rows = ny * first.height + 1;
        MeshBuilder mesh;
        for (Index y = 0; y < rows; ++y) {
            for (Index x = 0; x < columns; ++x) {
                mesh.vertex(Vector3(x, y, 0) / (columns - 1));
            }
        }
        std::vector<Index> face;
        for (Index j = 0; j < ny; ++j) {
            for (Index i = 0; i < nx; ++i) {
                const Pattern& pattern = pattern_at(i, j);
                for (char piece = 'A'; piece - 'A' < pattern.width * pattern.height / 4; ++piece) {
                    face.clear();
                    for (const auto& [x, y] : outline(pattern, piece)) {
                        face.push_back((j * pattern.height + y) * columns + i * pattern.width + x);
                    }
                    mesh.face(face);
                }
            }
        }
        return std::move(mesh).finish();
    });
}

Result<PolygonMesh> l_tiles(std::span<const double> p) {
    return tiled(count_of(p[0]), count_of(p[1]), [](Index, Index) -> const Pattern& { return two_l; });
}

Result<PolygonMesh> tetris(std::span<const double> p) {
    return tiled(count_of(p[0]), count_of(p[1]),
                 [](Index i, Index j) -> const Pattern& { return blocks[static_cast<std::size_t>(i + j) % 3]; });
}

constexpr std::array l_parameters{
    count_parameter("nx", "pairs along x", 1, 500, 16, 3),
    count_parameter("ny", "pairs along y", 1, 1000, 32, 6),
};
constexpr std::array tetris_parameters{
    count_parameter("nx", "blocks along x", 1, 500, 16, 3),
    count_parameter("ny", "blocks along y", 1, 500, 16, 3),
};

}  // namespace

const ShapeInfo l_tiles_shape{"l-tiles", "L tiles", "A rectangle cut into L-shaped polygons with ten corners each.",
                              l_parameters, l_tiles};
const ShapeInfo tetris_shape{"tetris", "Tetris", "A rectangle cut into T, L, J and S pieces with ten corners each.",
                             tetris_parameters, tetris};

}  // namespace polylap

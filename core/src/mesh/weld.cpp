#include "weld.hpp"

#include <algorithm>
#include <cmath>

namespace polylap {
namespace {

std::vector<Index> merge_equal(const Points& positions) {
    std::vector<Index> merged(static_cast<std::size_t>(positions.rows()));
    Welder welder;
    for (Index v = 0; v < positions.rows(); ++v)
        merged[static_cast<std::size_t>(v)] = welder.weld({positions(v, 0), positions(v, 1), positions(v, 2)}, v);
    return merged;
}

}  // namespace

std::vector<Index> merge_vertices(const Points& positions, double distance_ratio) {
    const double scale = positions.rows() == 0 ? 0 : positions.cwiseAbs().maxCoeff();
    if (distance_ratio == 0 || scale == 0) return merge_equal(positions);
    // At a size of about 1, nothing over- or underflows.
    const Points points = positions / scale;
    const Eigen::RowVector3d low = points.colwise().minCoeff();
    const double diagonal = (points.colwise().maxCoeff() - low).norm();
    const double distance = distance_ratio * diagonal;
    // Cells no smaller than the distance, and not so small that their numbers would not fit.
    constexpr double least_cell = 0x1p-40;
    const double cell = std::max(distance, least_cell * diagonal);
    if (cell == 0) return merge_equal(positions);

    // Only vertices that stay are in the cells. They are farther apart than the distance, so a cell holds few.
    std::unordered_map<std::array<std::uint64_t, 3>, std::vector<Index>, HashTriple> cells;
    std::vector<Index> merged(static_cast<std::size_t>(positions.rows()));
    for (Index v = 0; v < points.rows(); ++v) {
        const Eigen::RowVector3d at = ((points.row(v) - low) / cell).array().floor();
        const auto key = [&at](int i, int j, int k) {
            return std::array{static_cast<std::uint64_t>(static_cast<std::int64_t>(at[0]) + i),
                              static_cast<std::uint64_t>(static_cast<std::int64_t>(at[1]) + j),
                              static_cast<std::uint64_t>(static_cast<std::int64_t>(at[2]) + k)};
        };
        Index lowest = v;
        for (int neighbour = 0; neighbour < 27; ++neighbour) {
            const auto found = cells.find(key(neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1));
            if (found == cells.end()) continue;
            for (const Index w : found->second)
                if (w < lowest && (points.row(v) - points.row(w)).norm() <= distance) lowest = w;
        }
        merged[static_cast<std::size_t>(v)] = lowest;
        if (lowest == v) cells[key(0, 0, 0)].push_back(v);
    }
    return merged;
}

}  // namespace polylap

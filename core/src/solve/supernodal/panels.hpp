#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "solve/dense/kernels.hpp"

namespace polylap {

/// How the factor keeps a trapezoid (rows ≥ columns): in panels of block_columns columns, column-major, each from its
/// own diagonal on. Little of the unused upper triangle takes memory.
struct Panels {
    std::ptrdiff_t rows = 0, columns = 0;

    static constexpr std::ptrdiff_t width = dense::block_columns;

    /// Where a panel begins. @param first its first column, a multiple of `width`
    std::int64_t panel(std::int64_t first) const { return first * rows - first * (first - width) / 2; }
    /// From one column of the panel to the next.
    std::ptrdiff_t stride(std::ptrdiff_t first) const { return rows - first; }
    std::ptrdiff_t columns_of(std::ptrdiff_t first) const { return std::min(width, columns - first); }
    /// Where row 0 of a column would be; those from the panel's first column on are stored.
    std::ptrdiff_t column(std::ptrdiff_t j) const {
        const std::ptrdiff_t first = j / width * width;
        return static_cast<std::ptrdiff_t>(panel(first)) + (j - first) * stride(first) - first;
    }
    std::int64_t doubles() const {
        const std::ptrdiff_t last = columns / width * width;
        return panel(last) + std::int64_t{columns - last} * stride(last);
    }
};

}  // namespace polylap

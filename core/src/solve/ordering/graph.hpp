#pragma once

#include <span>
#include <vector>

#include "polylap/base/types.hpp"

namespace polylap {

/// The pattern of a symmetric matrix without its diagonal, and where the matrix keeps each entry.
struct Graph {
    std::vector<Index> start;       ///< n + 1: where a vertex's neighbours begin.
    std::vector<Index> neighbours;  ///< Each edge from both of its ends.
    std::vector<Index> source;      ///< Of each neighbour, the entry's place among the matrix's values.
    std::vector<Index> diagonal;    ///< n: the same of the diagonal entries; -1 for one that is not stored.

    /// @param a compressed; the lower triangle is read
    explicit Graph(const SparseMatrix& a);

    Index size() const { return static_cast<Index>(diagonal.size()); }
    std::span<const Index> around(Index v) const {
        const auto at = static_cast<std::size_t>(v);
        return {neighbours.data() + start[at], static_cast<std::size_t>(start[at + 1] - start[at])};
    }
};

}  // namespace polylap

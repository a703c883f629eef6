#pragma once

#include <span>
#include <vector>

#include "polylap/base/types.hpp"

namespace polylap {

/// The pattern of a symmetric matrix without its diagonal, and where the matrix keeps each entry.
struct Graph {
    std::vector<Index> start{0};    ///< n + 1: where a vertex's neighbours begin.
    std::vector<Index> neighbours;  ///< Each edge from both of its ends.
    std::vector<Index> source;      ///< Of each neighbour, the entry's place among the matrix's values.
    std::vector<Index> diagonal;    ///< n: the same of the diagonal entries; -1 for one that is not stored.

    Graph() = default;
    /// @param a compressed; the lower triangle is read
    explicit Graph(const SparseMatrix& a);

    /// Becomes the part of a graph around some vertices: they come first, their other neighbours follow and have no
    /// neighbours here. Knows of no matrix.
    /// @param local one a vertex of `whole`, -1; the same after
    /// @return the vertex of `whole` for each
    std::vector<Index> induce(const Graph& whole, std::span<const Index> vertices, std::vector<Index>& local);

    Index size() const { return static_cast<Index>(start.size()) - 1; }
    std::span<const Index> around(Index v) const {
        const auto at = static_cast<std::size_t>(v);
        return {neighbours.data() + start[at], static_cast<std::size_t>(start[at + 1] - start[at])};
    }
};

}  // namespace polylap

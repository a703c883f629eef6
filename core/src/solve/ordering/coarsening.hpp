#pragma once

#include <span>
#include <vector>

#include "polylap/base/types.hpp"
#include "solve/ordering/graph.hpp"

namespace polylap {

/// A graph of clusters, each some vertices that lie together.
struct Coarsening {
    Graph graph;                 ///< Clusters are neighbours where their vertices are. Knows of no matrix.
    std::vector<Index> cluster;  ///< Of each vertex, or -1 for those left out.
    Points positions;            ///< Means over the clusters; no rows where vertices have none.

    /// @param vertices of the graph; others are left out
    Coarsening(const Graph& whole, const Points& positions, std::span<const Index> vertices);
};

}  // namespace polylap

#pragma once

#include <vector>

#include "polylap/base/types.hpp"
#include "solve/ordering/graph.hpp"

namespace polylap {

/// The parent of a column is the row of its first entry below the diagonal.
struct EliminationTree {
    std::vector<Index> parent;  ///< -1: a root.
    std::vector<Index> count;   ///< nnz of each column of L, the diagonal included.
};

/// Puts `order` into a postorder of its elimination tree, which changes nothing of the fill, and returns that tree.
EliminationTree eliminate(const Graph& graph, std::vector<Index>& order);

/// A postorder of a forest whose parents come after their children: the vertices, children's subtrees in the order of
/// the children.
std::vector<Index> postorder(const std::vector<Index>& parent);

}  // namespace polylap

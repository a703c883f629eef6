#pragma once

#include <vector>

#include "polylap/base/monitor.hpp"
#include "polylap/base/types.hpp"
#include "solve/ordering/graph.hpp"

namespace polylap {

/// An order of elimination with little fill.
/// @param positions where the vertices lie, or no rows: then the graph alone decides
/// @return n: the vertices, first eliminated first; empty when cancelled
std::vector<Index> fill_reducing_order(const Graph& graph, const Points& positions, const Monitor& monitor);

}  // namespace polylap

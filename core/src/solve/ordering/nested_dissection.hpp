#pragma once

#include <vector>

#include "polylap/base/monitor.hpp"
#include "polylap/base/types.hpp"
#include "solve/ordering/graph.hpp"

namespace polylap {

/// Up to as many vertices, approximate minimum degree gives the same fill in half the time; measured on quad meshes.
inline constexpr Index minimum_degree_size = 20000;

/// An order of elimination with little fill.
/// @param positions where the vertices lie, or no rows: then the graph alone decides
/// @param dissect_above smaller graphs are ordered by minimum degree
/// @return n: the vertices, first eliminated first; empty when cancelled
std::vector<Index> fill_reducing_order(const Graph& graph, const Points& positions, const Monitor& monitor,
                                       Index dissect_above = minimum_degree_size);

}  // namespace polylap

#pragma once

#include <vector>

#include "polylap/base/monitor.hpp"
#include "polylap/base/types.hpp"
#include "solve/ordering/graph.hpp"

namespace polylap {

/// Up to as many vertices, approximate minimum degree takes a third of the time, and analysis and factor together less
/// even where its fill is a third larger: on hexagons, or where neighbours have numbers far apart. Measured on quad
/// meshes and hexagons of 20k to 120k vertices.
inline constexpr Index minimum_degree_size = 50000;

/// An order of elimination with little fill.
/// @param positions where the vertices lie, or no rows: then the graph alone decides
/// @param dissect_above smaller graphs are ordered by minimum degree
/// @return n: the vertices, first eliminated first; empty when cancelled
std::vector<Index> fill_reducing_order(const Graph& graph, const Points& positions, const Monitor& monitor,
                                       Index dissect_above = minimum_degree_size);

}  // namespace polylap

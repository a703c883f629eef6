#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "polylap/base/types.hpp"
#include "solve/ordering/graph.hpp"

namespace polylap {

/// Orders small sets of vertices, reusing its memory.
class MinimumDegree {
public:
    explicit MinimumDegree(const Graph& graph) : graph_(graph), local_(static_cast<std::size_t>(graph.size()), -1) {}

    /// Brings `vertices` into an order of elimination. Neighbours outside of the set count as eliminated later.
    void order(std::span<Index> vertices);

private:
    const Graph& graph_;
    std::vector<Index> local_;  ///< Per vertex its number in the set at work, or -1.
    std::vector<Index> halo_, degree_, result_;
    std::vector<std::uint64_t> adjacent_;  ///< One row of bits for each vertex of the set.
};

/// The same for many vertices, blind to those outside: Eigen's approximate minimum degree.
void order_by_amd(const Graph& graph, std::span<Index> vertices);

}  // namespace polylap

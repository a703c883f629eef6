// Nested dissection: separators go last, the parts between them are ordered the same way and small ones by minimum
// degree. George, Nested dissection of a regular finite element mesh, 1973; Lipton, Rose & Tarjan, Generalized nested
// dissection, 1979: O(n log n) entries and O(n^1.5) flops for meshes of surfaces.

#include "solve/ordering/nested_dissection.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>

#include "solve/ordering/minimum_degree.hpp"
#include "solve/ordering/separator.hpp"

namespace polylap {
namespace {

/// Parts of up to as many vertices are ordered by minimum degree; measured.
constexpr std::size_t leaf_size = 120;

class Dissection {
public:
    Dissection(const Graph& graph, const Points& positions, const Monitor& monitor)
        : graph_(graph), splitter_(graph, positions), minimum_degree_(graph), monitor_(monitor) {}

    /// @return false when cancelled
    bool order(std::span<Index> vertices) {
        if (vertices.size() <= leaf_size) {
            minimum_degree_.order(vertices);
            return proceed(vertices.size());
        }
        splitter_.mark(vertices);
        const std::size_t connected = splitter_.reach(vertices.front()).size();
        return connected == vertices.size() ? dissect(vertices) : order_components(vertices);
    }

private:
    bool order_components(std::span<Index> vertices) {
        std::vector<std::size_t> ends;
        std::vector<Index> grouped;
        std::vector<char> seen(static_cast<std::size_t>(graph_.size()), 0);
        for (const Index v : vertices) {
            if (seen[static_cast<std::size_t>(v)] != 0) continue;
            for (const Index u : splitter_.reach(v)) {
                seen[static_cast<std::size_t>(u)] = 1;
                grouped.push_back(u);
            }
            ends.push_back(grouped.size());
        }
        std::copy(grouped.begin(), grouped.end(), vertices.begin());
        std::size_t begin = 0;
        for (const std::size_t end : ends) {
            const auto component = vertices.subspan(begin, end - begin);
            begin = end;
            if (!order(component)) return false;
        }
        return true;
    }

    bool dissect(std::span<Index> vertices) {
        const auto sizes = splitter_.split(vertices);
        // Where no small separator exists (random graphs, cliques), dissection gains nothing.
        const auto n = static_cast<double>(vertices.size());
        if (sizes.separator > 0.25 * n || std::max(sizes.first, sizes.second) > 0.9 * n) {
            order_by_amd(graph_, vertices);
            return proceed(vertices.size());
        }
        scratch_.assign(vertices.begin(), vertices.end());
        auto first = vertices.begin();
        auto second = first + sizes.first;
        auto separator = second + sizes.second;
        const auto halves =
            std::pair(vertices.first(static_cast<std::size_t>(sizes.first)),
                      vertices.subspan(static_cast<std::size_t>(sizes.first), static_cast<std::size_t>(sizes.second)));
        for (const Index v : scratch_) {
            const Side side = splitter_.side(v);
            *(side == Side::first ? first : side == Side::second ? second : separator)++ = v;
        }
        return proceed(static_cast<std::size_t>(sizes.separator)) && order(halves.first) && order(halves.second);
    }

    bool proceed(std::size_t ordered) {
        done_ += ordered;
        if (done_ - told_ < 4096) return true;
        told_ = done_;
        return monitor_.proceed(static_cast<double>(done_) / graph_.size());
    }

    const Graph& graph_;
    Splitter splitter_;
    MinimumDegree minimum_degree_;
    std::vector<Index> scratch_;
    const Monitor& monitor_;
    std::size_t done_ = 0, told_ = 0;
};

}  // namespace

std::vector<Index> fill_reducing_order(const Graph& graph, const Points& positions, const Monitor& monitor) {
    std::vector<Index> order(static_cast<std::size_t>(graph.size()));
    std::iota(order.begin(), order.end(), 0);
    // Rows that meet a good part of the others go last, as in AMD: they would be in every separator.
    const double dense = std::max(16.0, 10 * std::sqrt(static_cast<double>(graph.size())));
    const auto end = std::stable_partition(
        order.begin(), order.end(), [&](Index v) { return static_cast<double>(graph.around(v).size()) <= dense; });
    Dissection dissection(graph, positions, monitor);
    if (!dissection.order(std::span(order).first(static_cast<std::size_t>(end - order.begin())))) return {};
    return order;
}

}  // namespace polylap

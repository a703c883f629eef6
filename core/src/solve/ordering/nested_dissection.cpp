// Nested dissection: separators go last, the parts between them are ordered the same way and small ones by minimum
// degree. George, Nested dissection of a regular finite element mesh, 1973; Lipton, Rose & Tarjan, Generalized nested
// dissection, 1979: O(n log n) entries and O(n^1.5) flops for meshes of surfaces.

#include "solve/ordering/nested_dissection.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "solve/ordering/coarsening.hpp"
#include "solve/ordering/minimum_degree.hpp"
#include "solve/ordering/separator.hpp"

namespace polylap {
namespace {

/// Parts of up to as many vertices are ordered by minimum degree; measured.
constexpr std::size_t leaf_size = 200;

/// Parts of up to as many vertices are copied into a graph of their own, whose data lie together in the cache.
constexpr std::size_t compact_size = 8192;

/// Separators of a patch of a surface have up to √n vertices. Wider ones may come from a bend that no plane follows, or
/// from positions that say little of the graph: distances get their chance then.
constexpr double suspicious_width = 1.3;

/// Splits regions of many vertices by their clusters, which costs a fraction.
class CoarseSplitter {
public:
    CoarseSplitter(const Graph& graph, const Points& positions, std::span<const Index> vertices)
        : coarsening_(graph, positions, vertices),
          splitter_(coarsening_.graph, coarsening_.positions),
          seen_(static_cast<std::size_t>(coarsening_.graph.size()), -1) {}

    /// @param fine knows the region as marked
    Splitter::Sizes split(std::span<const Index> region, Splitter& fine) {
        clusters_.clear();
        for (const Index v : region) {
            const Index c = cluster(v);
            if (std::exchange(seen_[static_cast<std::size_t>(c)], region_) != region_) clusters_.push_back(c);
        }
        ++region_;
        splitter_.mark(clusters_);
        Splitter::Sizes sizes;
        if (coarsening_.positions.rows() > 0) sizes = splitter_.split_by_position(clusters_);
        if (splitter_.reach(clusters_.front()).size() == clusters_.size()) {
            sizes = splitter_.split_by_distance(clusters_, sizes);
        }
        if (!sizes.useful()) return sizes;
        const Side between = sizes.first < sizes.second ? Side::first : Side::second;
        for (const Index v : region) {
            const Side side = splitter_.side(cluster(v));
            fine.give(v, side == Side::separator ? between : side);
        }
        return fine.separate(region);
    }

private:
    Index cluster(Index v) const { return coarsening_.cluster[static_cast<std::size_t>(v)]; }

    Coarsening coarsening_;
    Splitter splitter_;
    Index region_ = 0;
    std::vector<Index> seen_;  ///< The region that each cluster was in last.
    std::vector<Index> clusters_;
};

class Dissection {
public:
    Dissection(const Graph& graph, const Points& positions, const Monitor& monitor)
        : graph_(graph),
          positions_(positions),
          monitor_(monitor),
          splitter_(graph, positions),
          minimum_degree_(graph) {}

    /// The same, for so large a graph that clusters pay.
    bool order_coarsely(std::span<Index> vertices) {
        if (vertices.size() > 2 * compact_size) coarse_.emplace(graph_, positions_, vertices);
        return order(vertices);
    }

    /// @return false when cancelled
    bool order(std::span<Index> vertices) {
        if (vertices.size() <= leaf_size) {
            minimum_degree_.order(vertices);
            return proceed(vertices.size());
        }
        if (vertices.size() <= compact_size && static_cast<std::size_t>(graph_.size()) > 2 * compact_size) {
            return order_compact(vertices);
        }
        splitter_.mark(vertices);
        Splitter::Sizes sizes;
        if (coarse_) {
            sizes = coarse_->split(vertices, splitter_);
            if (sizes.useful()) return dissect(vertices, sizes);
        }
        if (positions_.rows() > 0) {
            sizes = splitter_.split_by_position(vertices);
            const double width = suspicious_width * std::sqrt(static_cast<double>(vertices.size()));
            if (sizes.useful() && sizes.separator < width) return dissect(vertices, sizes);
        }
        if (splitter_.reach(vertices.front()).size() != vertices.size()) return order_components(vertices);
        sizes = splitter_.split_by_distance(vertices, sizes);
        if (sizes.useful()) return dissect(vertices, sizes);
        order_by_amd(graph_, vertices);
        return proceed(vertices.size());
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

    bool order_compact(std::span<Index> vertices) {
        if (local_.empty()) local_.assign(static_cast<std::size_t>(graph_.size()), -1);
        Graph graph;
        const std::vector<Index> global = graph.induce(graph_, vertices, local_);
        Points positions(positions_.rows() > 0 ? static_cast<Eigen::Index>(vertices.size()) : 0, 3);
        for (Eigen::Index k = 0; k < positions.rows(); ++k) {
            positions.row(k) = positions_.row(vertices[static_cast<std::size_t>(k)]);
        }
        Stretch stretch{monitor_, fraction(done_), fraction(done_ + vertices.size())};
        const Monitor monitor = stretch.monitor();
        std::vector<Index> order(vertices.size());
        std::iota(order.begin(), order.end(), 0);
        if (!Dissection(graph, positions, monitor).order(order)) return false;
        for (std::size_t k = 0; k < order.size(); ++k) {
            vertices[k] = global[static_cast<std::size_t>(order[k])];
        }
        return proceed(vertices.size());
    }

    bool dissect(std::span<Index> vertices, const Splitter::Sizes& sizes) {
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
        return monitor_.proceed(fraction(done_));
    }
    double fraction(std::size_t ordered) const {
        return std::min(1.0, static_cast<double>(ordered) / static_cast<double>(graph_.size()));
    }

    const Graph& graph_;
    const Points& positions_;
    const Monitor& monitor_;
    Splitter splitter_;
    std::optional<CoarseSplitter> coarse_;
    MinimumDegree minimum_degree_;
    std::vector<Index> scratch_, local_;
    std::size_t done_ = 0, told_ = 0;
};

}  // namespace

std::vector<Index> fill_reducing_order(const Graph& graph, const Points& positions, const Monitor& monitor,
                                       Index dissect_above) {
    std::vector<Index> order(static_cast<std::size_t>(graph.size()));
    std::iota(order.begin(), order.end(), 0);
    if (graph.size() <= dissect_above) {
        order_by_amd(graph, order);
        return order;
    }
    // Rows that meet a good part of the others go last, as in AMD: they would be in every separator.
    const double dense = std::max(16.0, 10 * std::sqrt(static_cast<double>(graph.size())));
    const auto end = std::stable_partition(
        order.begin(), order.end(), [&](Index v) { return static_cast<double>(graph.around(v).size()) <= dense; });
    // Squares of larger ones would overflow; with others than numbers there is no middle.
    constexpr double farthest = 1e100;
    const bool usable = (positions.array().abs() <= farthest).all();
    const Points none(0, 3);
    Dissection dissection(graph, usable ? positions : none, monitor);
    if (!dissection.order_coarsely(std::span(order).first(static_cast<std::size_t>(end - order.begin())))) return {};
    return order;
}

}  // namespace polylap

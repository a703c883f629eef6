// Clusters as in Vanek, Mandel & Brezina, Algebraic multigrid by smoothed aggregation, 1996: vertices with all of their
// neighbours where these are still free, then what is left joins a cluster beside it.

#include "solve/ordering/coarsening.hpp"

#include <algorithm>

namespace polylap {
namespace {

std::size_t at(Index v) {
    return static_cast<std::size_t>(v);
}

constexpr Index left_out = -1, waiting = -2;

/// @return how many clusters there are
Index find_clusters(const Graph& whole, std::span<const Index> vertices, std::vector<Index>& cluster) {
    cluster.assign(at(whole.size()), left_out);
    for (const Index v : vertices)
        cluster[at(v)] = waiting;
    Index count = 0;
    const auto found = [&](Index v) {
        cluster[at(v)] = count;
        for (const Index u : whole.around(v)) {
            if (cluster[at(u)] == waiting) cluster[at(u)] = count;
        }
        ++count;
    };
    for (const Index v : vertices) {
        const auto around = whole.around(v);
        if (cluster[at(v)] == waiting &&
            std::all_of(around.begin(), around.end(), [&](Index u) { return cluster[at(u)] < 0; }))
            found(v);
    }
    const Index roots = count;
    std::vector<Index> size(at(roots), 0);
    for (const Index v : vertices) {
        if (cluster[at(v)] >= 0) ++size[at(cluster[at(v)])];
    }
    std::vector<std::pair<Index, Index>> joins;  // made at once, so that no cluster grows along a row
    for (const Index v : vertices) {
        if (cluster[at(v)] != waiting) continue;
        Index best = waiting;
        for (const Index u : whole.around(v)) {
            const Index c = cluster[at(u)];
            if (c >= 0 && (best < 0 || size[at(c)] < size[at(best)])) best = c;
        }
        if (best < 0) continue;
        joins.emplace_back(v, best);
        ++size[at(best)];
    }
    for (const auto& [v, c] : joins)
        cluster[at(v)] = c;
    for (const Index v : vertices) {
        if (cluster[at(v)] == waiting) found(v);
    }
    return count;
}

}  // namespace

Coarsening::Coarsening(const Graph& whole, const Points& fine, std::span<const Index> vertices) {
    const Index count = find_clusters(whole, vertices, cluster);
    std::vector<Index> start(at(count) + 1, 0);
    for (const Index v : vertices)
        ++start[at(cluster[at(v)])];
    Index total = 0;
    for (Index& s : start)
        total = s += total;
    std::vector<Index> members(vertices.size());
    for (std::size_t k = vertices.size(); k-- > 0;)
        members[at(--start[at(cluster[at(vertices[k])])])] = vertices[k];
    positions.setZero(fine.rows() > 0 ? count : 0, 3);
    std::vector<Index> seen(at(count), -1);
    for (Index c = 0; c < count; ++c) {
        seen[at(c)] = c;
        for (Index k = start[at(c)]; k < start[at(c) + 1]; ++k) {
            const Index v = members[at(k)];
            if (fine.rows() > 0) positions.row(c) += fine.row(v) / static_cast<double>(start[at(c) + 1] - start[at(c)]);
            for (const Index u : whole.around(v)) {
                const Index d = cluster[at(u)];
                if (d < 0 || seen[at(d)] == c) continue;
                seen[at(d)] = c;
                graph.neighbours.push_back(d);
            }
        }
        graph.start.push_back(static_cast<Index>(graph.neighbours.size()));
    }
}

}  // namespace polylap

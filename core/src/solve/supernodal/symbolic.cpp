// Supernodes: Ng & Peyton, Block sparse Cholesky algorithms on advanced uniprocessor computers, 1993. Small ones are
// merged with their parents where that stores few zeros: Ashcraft & Grimes, The influence of relaxed supernode
// partitions on the multifrontal method, 1989. Children in the order that keeps the stack low: Liu, On the storage
// requirement in the out-of-core multifrontal method for sparse factorization, 1986.

#include "solve/supernodal/symbolic.hpp"

#include <algorithm>
#include <limits>
#include <new>
#include <numeric>

#include "solve/dense/kernels.hpp"
#include "solve/ordering/graph.hpp"
#include "solve/supernodal/elimination_tree.hpp"

namespace polylap {
namespace {

std::size_t at(Index v) {
    return static_cast<std::size_t>(v);
}

/// Supernodes on their way: numbered by rising columns, later merged into their parents.
struct Merging {
    std::vector<Index> first;  ///< First column.
    std::vector<Index> columns, below, parent;
    std::vector<double> zeros;  ///< Stored, but not in L.
    std::vector<Index> into;    ///< -1, or the supernode that took its columns.
};

Merging find_supernodes(const EliminationTree& tree) {
    const auto n = static_cast<Index>(tree.parent.size());
    Merging m;
    std::vector<Index> of(tree.parent.size());
    for (Index j = 0; j < n; ++j) {
        const bool joins = j > 0 && tree.parent[at(j - 1)] == j && tree.count[at(j - 1)] == tree.count[at(j)] + 1;
        if (!joins) {
            m.first.push_back(j);
            m.columns.push_back(0);
            m.below.push_back(0);
        }
        ++m.columns.back();
        m.below.back() = tree.count[at(j)] - 1;
        of[at(j)] = static_cast<Index>(m.first.size()) - 1;
    }
    for (std::size_t s = 0; s < m.first.size(); ++s) {
        const Index up = tree.parent[at(m.first[s] + m.columns[s] - 1)];
        m.parent.push_back(up < 0 ? -1 : of[at(up)]);
    }
    m.zeros.assign(m.first.size(), 0);
    m.into.assign(m.first.size(), -1);
    return m;
}

double trapezoid(double columns, double below) {
    return columns * (columns + 1) / 2 + columns * below;
}

/// Children's columns go before the parent's; the rows below stay the parent's.
void merge(Merging& m) {
    const auto count = static_cast<Index>(m.first.size());
    std::vector<Index> first_child(at(count), -1);
    std::vector<Index> sibling(at(count), -1);
    for (Index s = count - 1; s >= 0; --s) {
        if (m.parent[at(s)] < 0) continue;
        sibling[at(s)] = first_child[at(m.parent[at(s)])];
        first_child[at(m.parent[at(s)])] = s;
    }
    std::vector<Index> children;
    for (Index p = 0; p < count; ++p) {
        children.clear();
        for (Index c = first_child[at(p)]; c >= 0; c = sibling[at(c)])
            children.push_back(c);
        // Those that lose least first: the closer their rows are to the parent's, the fewer zeros.
        std::stable_sort(children.begin(), children.end(),
                         [&](Index a, Index b) { return m.below[at(a)] > m.below[at(b)]; });
        for (const Index c : children) {
            const double columns = m.columns[at(c)] + m.columns[at(p)];
            const double added = double(m.columns[at(c)]) * (m.columns[at(p)] + m.below[at(p)] - m.below[at(c)]);
            const double zeros = m.zeros[at(c)] + m.zeros[at(p)] + added;
            const double share = zeros / trapezoid(columns, m.below[at(p)]);
            const bool worth = zeros == 0 || (columns <= 4) || (columns <= 16 && share < 0.2) ||
                               (columns <= 48 && share < 0.1) || share < 0.03;
            if (!worth) continue;
            m.into[at(c)] = p;
            m.columns[at(p)] = static_cast<Index>(columns);
            m.zeros[at(p)] = zeros;
        }
    }
}

/// Doubles that a supernode leaves on the stack.
std::int64_t left(const Merging& m, Index s) {
    return Panels{m.below[at(s)], m.below[at(s)]}.doubles();
}

/// A count of doubles that memory can be asked for.
std::size_t allocatable(std::int64_t doubles) {
    constexpr auto most = std::numeric_limits<std::ptrdiff_t>::max() / std::ptrdiff_t{sizeof(double)};
    if (doubles > most - std::ptrdiff_t{dense::slack}) throw std::bad_alloc();
    return static_cast<std::size_t>(doubles);
}

/// Order of the supernodes that remain: a postorder with the greediest child first.
/// @param stack the most doubles on the stack at once
std::vector<Index> order_supernodes(const Merging& m, std::vector<Index>& parent, std::size_t& stack) {
    const auto count = static_cast<Index>(m.first.size());
    parent.assign(at(count), -1);
    const auto taken_by = [&](Index s) {
        while (m.into[at(s)] >= 0)
            s = m.into[at(s)];
        return s;
    };
    std::vector<Index> start(at(count) + 2, 0);  // of the children of each, and of the roots
    const auto lists = [&](auto&& take) {
        for (Index s = count - 1; s >= 0; --s) {
            if (m.into[at(s)] < 0) take(s, parent[at(s)] < 0 ? at(count) : at(parent[at(s)]));
        }
    };
    for (Index s = 0; s < count; ++s) {
        if (m.into[at(s)] < 0 && m.parent[at(s)] >= 0) parent[at(s)] = taken_by(m.parent[at(s)]);
    }
    lists([&](Index, std::size_t list) { ++start[list]; });
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<Index> children(at(start.back()));
    lists([&](Index s, std::size_t list) { children[at(--start[list])] = s; });
    const auto of = [&](Index s) {
        return std::span(children).subspan(at(start[at(s)]), at(start[at(s) + 1] - start[at(s)]));
    };
    std::vector<std::int64_t> peak(at(count) + 1, 0);
    for (Index s = 0; s <= count; ++s) {  // children come first
        if (s < count && m.into[at(s)] >= 0) continue;
        const auto mine = of(s);
        std::stable_sort(mine.begin(), mine.end(),
                         [&](Index a, Index b) { return peak[at(a)] - left(m, a) > peak[at(b)] - left(m, b); });
        std::int64_t held = 0;
        for (const Index c : mine) {
            peak[at(s)] = std::max(peak[at(s)], held + peak[at(c)]);
            held += left(m, c);
        }
        if (s < count) peak[at(s)] = std::max(peak[at(s)], held + left(m, s));
    }
    stack = allocatable(peak.back());
    std::vector<Index> order;
    std::vector<std::pair<Index, std::size_t>> path{{count, 0}};
    while (!path.empty()) {
        auto& [s, next] = path.back();
        const auto mine = of(s);
        if (next < mine.size()) {
            const Index child = mine[next++];
            path.emplace_back(child, 0);
        } else {
            order.push_back(s);
            path.pop_back();
        }
    }
    order.pop_back();  // the parent of the roots
    return order;
}

/// Columns in their last order; fills in supernodes but for their rows. @return supernode of each column
std::vector<Index> lay_out(const Merging& m, Symbolic& symbolic) {
    const std::size_t count = m.first.size();
    std::vector<Index> parent;
    const std::vector<Index> order = order_supernodes(m, parent, symbolic.stack);
    // Columns of the supernodes that went into each, in their old order, which is a postorder.
    std::vector<Index> place(count, -1);
    for (std::size_t k = 0; k < order.size(); ++k)
        place[at(order[k])] = static_cast<Index>(k);
    std::vector<Index> next(order.size() + 1, 0);
    auto& supernodes = symbolic.supernodes;
    supernodes.resize(order.size() + 1);
    std::size_t rows = 0;
    std::int64_t values = 0;
    Index column = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const std::size_t s = at(order[k]);
        const Index up = parent[s];
        supernodes[k] = {column, up < 0 ? -1 : place[at(up)], 0, m.below[s], rows};
        next[k] = column;
        column += m.columns[s];
        rows += at(m.below[s]);
        values += Panels{m.columns[s] + m.below[s], m.columns[s]}.doubles();
        symbolic.largest_front = std::max(symbolic.largest_front, m.columns[s] + m.below[s]);
        symbolic.widest = std::max(symbolic.widest, m.columns[s]);
    }
    supernodes.back() = {column, -1, 0, 0, rows};
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (supernodes[k].parent >= 0) ++supernodes[at(supernodes[k].parent)].children;
    }
    symbolic.values = allocatable(values);
    std::vector<Index> original(symbolic.original.size());
    std::vector<Index> of(original.size());
    for (std::size_t s = 0; s < count; ++s) {
        std::size_t into = s;
        while (m.into[into] >= 0)
            into = at(m.into[into]);
        const Index k = place[into];
        const std::size_t end = s + 1 < count ? at(m.first[s + 1]) : original.size();
        for (std::size_t j = at(m.first[s]); j < end; ++j) {
            of[at(next[at(k)])] = k;
            original[at(next[at(k)]++)] = symbolic.original[j];
        }
    }
    symbolic.original = std::move(original);
    return of;
}

/// Row i is below supernode s exactly where s is on a path from a neighbour of i up the tree; taking the rows in order,
/// each list is sorted.
void find_rows(const Graph& graph, const std::vector<Index>& place, const std::vector<Index>& of, Symbolic& symbolic) {
    auto& supernodes = symbolic.supernodes;
    symbolic.rows.resize(supernodes.back().rows);
    std::vector<std::size_t> next(supernodes.size());
    std::vector<Index> seen(supernodes.size(), -1);
    for (std::size_t s = 0; s < supernodes.size(); ++s)
        next[s] = supernodes[s].rows;
    for (Index i = 0; i < symbolic.size; ++i) {
        seen[at(of[at(i)])] = i;
        for (const Index u : graph.around(symbolic.original[at(i)])) {
            if (place[at(u)] >= i) continue;
            for (Index s = of[at(place[at(u)])]; seen[at(s)] != i; s = supernodes[at(s)].parent) {
                seen[at(s)] = i;
                symbolic.rows[next[at(s)]++] = i;
            }
        }
    }
}

void find_entries(const Graph& graph, const std::vector<Index>& place, Symbolic& symbolic) {
    const auto n = at(symbolic.size);
    symbolic.entry_start.reserve(n + 1);
    symbolic.entries_in.reserve(graph.neighbours.size() / 2 + n);
    std::vector<Index> in_front(n, -1);
    for (std::size_t s = 0; s + 1 < symbolic.supernodes.size(); ++s) {
        const auto& supernode = symbolic.supernodes[s];
        const Index columns = symbolic.columns(s);
        for (Index k = 0; k < columns; ++k)
            in_front[at(supernode.first + k)] = k;
        for (Index k = 0; k < supernode.below; ++k)
            in_front[at(symbolic.rows[supernode.rows + at(k)])] = columns + k;
        for (Index j = supernode.first; j < supernode.first + columns; ++j) {
            symbolic.entry_start.push_back(static_cast<Index>(symbolic.entries_in.size()));
            const Index v = symbolic.original[at(j)];
            symbolic.entries_in.push_back({graph.diagonal[at(v)], j - supernode.first});
            const auto around = graph.around(v);
            for (std::size_t k = 0; k < around.size(); ++k) {
                const Index i = place[at(around[k])];
                if (i > j) symbolic.entries_in.push_back({graph.source[at(graph.start[at(v)]) + k], in_front[at(i)]});
            }
        }
    }
    symbolic.entry_start.push_back(static_cast<Index>(symbolic.entries_in.size()));
}

}  // namespace

Result<Symbolic> analyse_pattern(const SparseMatrix& a, const Points& positions, const Monitor& monitor,
                                 Index dissect_above) {
    const Error cancelled{ErrorCode::cancelled, "cancelled"};
    if (!monitor.proceed(0)) return cancelled;
    const Graph graph(a);
    Symbolic symbolic;
    symbolic.size = graph.size();
    Stretch ordering{monitor, 0.1, 0.7};
    symbolic.original = fill_reducing_order(graph, positions, ordering.monitor(), dissect_above);
    if (symbolic.original.size() != at(symbolic.size)) return cancelled;
    Merging merging;
    {
        const EliminationTree tree = eliminate(graph, symbolic.original);
        for (const Index count : tree.count)
            symbolic.entries += count;
        merging = find_supernodes(tree);
    }
    if (!monitor.proceed(0.8)) return cancelled;
    merge(merging);
    const std::vector<Index> of = lay_out(merging, symbolic);
    std::vector<Index> place(at(symbolic.size));
    for (Index j = 0; j < symbolic.size; ++j)
        place[at(symbolic.original[at(j)])] = j;
    find_rows(graph, place, of, symbolic);
    if (!monitor.proceed(0.9)) return cancelled;
    find_entries(graph, place, symbolic);
    for (std::size_t s = 0; s + 1 < symbolic.supernodes.size(); ++s) {
        const double below = symbolic.supernodes[s].below;
        const double columns = symbolic.columns(s);
        for (double k = 0; k < columns; ++k)
            symbolic.flops += (below + k + 1) * (below + k + 1);
    }
    return symbolic;
}

}  // namespace polylap

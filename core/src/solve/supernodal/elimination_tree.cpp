// Liu, The role of elimination trees in sparse factorization, 1990; column counts: Gilbert, Ng & Peyton, An efficient
// algorithm to compute row and column counts for sparse Cholesky factorization, 1994.

#include "solve/supernodal/elimination_tree.hpp"

#include <numeric>

namespace polylap {
namespace {

std::size_t at(Index v) {
    return static_cast<std::size_t>(v);
}

std::vector<Index> inverse(const std::vector<Index>& order) {
    std::vector<Index> place(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        place[at(order[k])] = static_cast<Index>(k);
    return place;
}

std::vector<Index> find_parents(const Graph& graph, const std::vector<Index>& order) {
    const std::vector<Index> place = inverse(order);
    const auto n = static_cast<Index>(order.size());
    std::vector<Index> parent(order.size(), -1);
    std::vector<Index> ancestor(order.size(), -1);
    for (Index j = 0; j < n; ++j) {
        for (const Index u : graph.around(order[at(j)])) {
            for (Index i = place[at(u)]; i < j;) {
                const Index next = ancestor[at(i)];
                ancestor[at(i)] = j;
                if (next < 0) parent[at(i)] = j;
                if (next < 0 || next == j) break;
                i = next;
            }
        }
    }
    return parent;
}

/// For a postordered tree. Row i of L is a subtree of it that begins at the leaves j with a_ij ≠ 0; a column's count is
/// the number of row subtrees that it is in: each leaf adds a path, which overlaps the one before from their common
/// ancestor on.
std::vector<Index> count_columns(const Graph& graph, const std::vector<Index>& order,
                                 const std::vector<Index>& parent) {
    const std::vector<Index> place = inverse(order);
    const auto n = static_cast<Index>(order.size());
    std::vector<Index> first(order.size(), -1);  // first descendant
    std::vector<Index> count(order.size(), 0);
    for (Index j = 0; j < n; ++j) {
        if (first[at(j)] < 0) count[at(j)] = 1;  // a leaf of the whole tree is in its own row's subtree
        for (Index i = j; i >= 0 && first[at(i)] < 0; i = parent[at(i)])
            first[at(i)] = j;
    }
    std::vector<Index> newest(order.size(), -1);  // newest leaf of each row's subtree
    std::vector<Index> last_seen(order.size(), -1);
    std::vector<Index> ancestor(order.size());
    std::iota(ancestor.begin(), ancestor.end(), 0);
    const auto root = [&](Index i) {
        Index top = i;
        while (ancestor[at(top)] != top)
            top = ancestor[at(top)];
        while (i != top) {
            const Index next = ancestor[at(i)];
            ancestor[at(i)] = top;
            i = next;
        }
        return top;
    };
    for (Index j = 0; j < n; ++j) {
        if (parent[at(j)] >= 0) --count[at(parent[at(j)])];
        for (const Index u : graph.around(order[at(j)])) {
            const Index i = place[at(u)];
            if (i <= j || first[at(j)] <= last_seen[at(i)]) continue;  // not a leaf of row i's subtree
            ++count[at(j)];
            if (newest[at(i)] >= 0) --count[at(root(newest[at(i)]))];
            newest[at(i)] = j;
            last_seen[at(i)] = j;
        }
        if (parent[at(j)] >= 0) ancestor[at(j)] = parent[at(j)];
    }
    for (Index j = 0; j < n; ++j) {
        if (parent[at(j)] >= 0) count[at(parent[at(j)])] += count[at(j)];
    }
    return count;
}

}  // namespace

std::vector<Index> postorder(const std::vector<Index>& parent) {
    const auto n = static_cast<Index>(parent.size());
    std::vector<Index> first_child(parent.size(), -1);
    std::vector<Index> sibling(parent.size(), -1);
    for (Index j = n - 1; j >= 0; --j) {
        if (parent[at(j)] < 0) continue;
        sibling[at(j)] = first_child[at(parent[at(j)])];
        first_child[at(parent[at(j)])] = j;
    }
    std::vector<Index> order;
    order.reserve(parent.size());
    for (Index tree = 0; tree < n; ++tree) {
        if (parent[at(tree)] >= 0) continue;
        Index j = tree;
        while (j >= 0) {
            while (first_child[at(j)] >= 0)
                j = first_child[at(j)];
            order.push_back(j);
            while (j != tree && sibling[at(j)] < 0) {
                j = parent[at(j)];
                order.push_back(j);
            }
            j = j == tree ? -1 : sibling[at(j)];
        }
    }
    return order;
}

EliminationTree eliminate(const Graph& graph, std::vector<Index>& order) {
    EliminationTree tree;
    {
        const std::vector<Index> parent = find_parents(graph, order);
        const std::vector<Index> post = postorder(parent);
        const std::vector<Index> place = inverse(post);
        tree.parent.resize(order.size());
        std::vector<Index> reordered(order.size());
        for (std::size_t k = 0; k < order.size(); ++k) {
            reordered[k] = order[at(post[k])];
            const Index p = parent[at(post[k])];
            tree.parent[k] = p < 0 ? -1 : place[at(p)];
        }
        order = std::move(reordered);
    }
    tree.count = count_columns(graph, order, tree.parent);
    return tree;
}

}  // namespace polylap

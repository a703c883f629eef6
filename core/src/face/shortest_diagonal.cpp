#include <algorithm>
#include <utility>

#include "face/chords.hpp"
#include "face/triangulation_rules.hpp"

namespace polylap {
namespace {

bool between(Index a, Index b, Index x) {
    return a < x && x < b;
}

struct Diagonal {
    double length;
    Index i, j;
};

/// Shortest first. Runs that tie, each with the one before it, are in the order of their corners.
void sort_by_length(std::vector<Diagonal>& diagonals, double tie_distance) {
    std::sort(diagonals.begin(), diagonals.end(),
              [](const Diagonal& a, const Diagonal& b) { return a.length < b.length; });
    for (auto first = diagonals.begin(); first != diagonals.end();) {
        const auto last = std::adjacent_find(first, diagonals.end(), [=](const Diagonal& a, const Diagonal& b) {
            return b.length - a.length > tie_distance;
        });
        const auto end = last == diagonals.end() ? last : last + 1;
        std::sort(first, end,
                  [](const Diagonal& a, const Diagonal& b) { return std::pair(a.i, a.j) < std::pair(b.i, b.j); });
        first = end;
    }
}

}  // namespace

Status cut_shortest_diagonal(const PlanePolygon& polygon, std::vector<Triangle>& out) {
    const Index n = polygon.size();
    const Chords inside(polygon);
    std::vector<Diagonal> candidates;
    for (Index i = 0; i < n; ++i) {
        for (Index j = i + 2; j < n; ++j) {
            if (polygon.next(j) != i && inside.has(i, j)) {
                candidates.push_back({(polygon[j] - polygon[i]).norm(), i, j});
            }
        }
    }
    sort_by_length(candidates, polygon.tie_distance());
    Chords chosen(n);
    std::vector<Diagonal> taken;
    for (const Diagonal& d : candidates) {
        const bool crosses = std::any_of(taken.begin(), taken.end(), [&d](const Diagonal& t) {
            return d.i != t.i && d.i != t.j && d.j != t.i && d.j != t.j &&
                   between(t.i, t.j, d.i) != between(t.i, t.j, d.j);
        });
        if (crosses) continue;
        taken.push_back(d);
        chosen.join(d.i, d.j);
    }
    for (Index i = 0; i < n; ++i) {
        chosen.join(i, polygon.next(i));
    }

    // The triangle below a chord has as apex the corner that chosen chords join to both ends.
    out.clear();
    std::vector<std::pair<Index, Index>> open{{0, n - 1}};
    while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        if (j == i + 1) continue;
        Index k = i + 1;
        while (k < j && !(chosen.has(i, k) && chosen.has(k, j))) {
            ++k;
        }
        if (k == j || polygon.side(i, k, j) <= 0) {
            return Error{ErrorCode::degenerate_face, "its projection is too thin to triangulate"};
        }
        out.push_back({i, k, j});
        open.emplace_back(k, j);
        open.emplace_back(i, k);
    }
    return Done{};
}

}  // namespace polylap

#pragma once

#include <vector>

#include "base/square.hpp"
#include "face/plane_polygon.hpp"

namespace polylap {

/// Which pairs of corners an edge or an inside diagonal joins.
class Chords {
public:
    /// Joins nothing yet.
    explicit Chords(Index size) : size_(size), joined_(square(static_cast<std::size_t>(size)), 0) {}

    /// Joins all edges and inside diagonals. O(n²) if strictly convex, otherwise O(n³).
    explicit Chords(const PlanePolygon& polygon) : Chords(polygon.size()) {
        const bool all = polygon.strictly_convex();
        for (Index i = 0; i < size_; ++i) {
            for (Index j = i + 1; j < size_; ++j) {
                if (all || polygon.next(i) == j || polygon.next(j) == i || polygon.inside_diagonal(i, j)) join(i, j);
            }
        }
    }

    bool has(Index i, Index j) const { return joined_[slot(i, j)] != 0; }
    void join(Index i, Index j) { joined_[slot(i, j)] = joined_[slot(j, i)] = 1; }

private:
    std::size_t slot(Index i, Index j) const {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(j);
    }
    Index size_;
    std::vector<char> joined_;
};

}  // namespace polylap

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "base/square.hpp"
#include "face/triangulation_rules.hpp"

namespace polylap {
namespace {

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

/// Angles closer than this, in radians, tie: equal in exact arithmetic, different by rounding.
constexpr double angle_tolerance = 1e-12;

/// Up to this many corners ties are resolved exactly; their lists of angles take n³/2 numbers. Beyond, the first apex
/// wins.
constexpr Index exact_tie_corners = 64;

/// Finds the triangulation with the smallest sorted list of angles by dynamic programming over sub-polygons (Klincsek
/// 1980): such lists, largest first, keep their order when the same angles are added to both, so the best whole
/// consists of best parts.
class MinMaxAngle {
public:
    explicit MinMaxAngle(const PlanePolygon& polygon)
        : polygon_(polygon),
          chords_(polygon),
          n_(polygon.size()),
          exact_ties_(n_ <= exact_tie_corners),
          parts_(square(static_cast<std::size_t>(n_))) {}

    bool run(std::vector<Triangle>& out) {
        for (Index length = 2; length < n_; ++length) {
            for (Index i = 0; i + length < n_; ++i) {
                if (chords_.has(i, i + length)) choose(i, i + length);
            }
        }
        out.clear();
        return collect(out);
    }

private:
    using Angles = std::vector<double>;  // largest first

    /// The part of the polygon between corners i < j, cut off by the chord i–j.
    struct Part {
        double largest = std::numeric_limits<double>::infinity();
        Index apex = -1;
        Angles angles;  ///< Only for exact ties.
    };
    Part& part(Index i, Index j) {
        return parts_[static_cast<std::size_t>(i) * static_cast<std::size_t>(n_) + static_cast<std::size_t>(j)];
    }

    double angle(Index a, Index o, Index b) const {
        const Eigen::Vector2d u = polygon_[a] - polygon_[o];
        const Eigen::Vector2d v = polygon_[b] - polygon_[o];
        return std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
    }

    void choose(Index i, Index j) {
        Part best;
        for (Index k = i + 1; k < j; ++k) {
            const double left = k == i + 1 ? 0 : part(i, k).largest;
            const double right = k + 1 == j ? 0 : part(k, j).largest;
            if (std::isinf(left) || std::isinf(right) || polygon_.side(i, k, j) <= 0) continue;
            const std::array<double, 3> own{angle(k, i, j), angle(j, k, i), angle(i, j, k)};
            const double largest = std::max({left, right, own[0], own[1], own[2]});
            if (largest > best.largest + angle_tolerance) continue;
            if (!exact_ties_) {
                if (largest < best.largest - angle_tolerance) best = {largest, k, {}};
                continue;
            }
            Angles angles = merged(own, part(i, k).angles, part(k, j).angles);
            if (largest > best.largest - angle_tolerance && !smaller(angles, best.angles)) continue;
            best = {largest, k, std::move(angles)};
        }
        part(i, j) = std::move(best);
    }

    static Angles merged(std::array<double, 3> own, const Angles& left, const Angles& right) {
        std::sort(own.begin(), own.end(), std::greater<>());
        Angles sides;
        std::merge(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(sides), std::greater<>());
        Angles all;
        std::merge(sides.begin(), sides.end(), own.begin(), own.end(), std::back_inserter(all), std::greater<>());
        return all;
    }

    static bool smaller(const Angles& a, const Angles& b) {
        for (std::size_t m = 0; m < a.size(); ++m) {
            if (std::abs(a[m] - b[m]) > angle_tolerance) return a[m] < b[m];
        }
        return false;
    }

    /// Hands over the triangles of the whole; false if it has none.
    bool collect(std::vector<Triangle>& out) {
        std::vector<std::pair<Index, Index>> open{{0, n_ - 1}};
        while (!open.empty()) {
            const auto [a, b] = open.back();
            open.pop_back();
            if (b == a + 1) continue;
            const Index k = part(a, b).apex;
            if (k < 0) return false;
            out.push_back({a, k, b});
            open.emplace_back(k, b);
            open.emplace_back(a, k);
        }
        return true;
    }

    const PlanePolygon& polygon_;
    Chords chords_;
    Index n_;
    bool exact_ties_;
    std::vector<Part> parts_;
};

bool between(Index a, Index b, Index x) {
    return a < x && x < b;
}

}  // namespace

Status cut_min_max_angle(const PlanePolygon& polygon, std::vector<Triangle>& out) {
    if (MinMaxAngle(polygon).run(out)) return Done{};
    return Error{ErrorCode::degenerate_face, "its projection is too thin to triangulate"};
}

Status cut_shortest_diagonal(const PlanePolygon& polygon, std::vector<Triangle>& out) {
    struct Diagonal {
        double squared_length;
        Index i, j;
    };
    const Index n = polygon.size();
    const Chords inside(polygon);
    std::vector<Diagonal> candidates;
    for (Index i = 0; i < n; ++i) {
        for (Index j = i + 2; j < n; ++j) {
            if (polygon.next(j) != i && inside.has(i, j)) {
                candidates.push_back({(polygon[j] - polygon[i]).squaredNorm(), i, j});
            }
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Diagonal& a, const Diagonal& b) { return a.squared_length < b.squared_length; });
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

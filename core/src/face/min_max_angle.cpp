#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "face/chords.hpp"
#include "face/triangulation_rules.hpp"

namespace polylap {
namespace {

/// Angles closer than this, in radians, tie: equal in exact arithmetic, different by rounding.
constexpr double angle_tolerance = 1e-12;

/// Up to this many corners ties are resolved exactly; beyond, the two largest angles decide, then the first apex.
constexpr Index exact_tie_corners = 64;

/// Finds the triangulation with the smallest sorted list of angles by dynamic programming over sub-polygons (Klincsek
/// 1980): such lists, largest first, keep their order when the same angles are added to both, so the best whole
/// consists of best parts. The part i–j, i < j, is what the chord i–j cuts off.
///
/// First the two largest angles of every part are found, which leaves few apices. From the whole down, those that still
/// tie are then compared by all angles: sums of hashes tell equal lists, and unequal ones are compared where they
/// differ.
class MinMaxAngle {
public:
    explicit MinMaxAngle(const PlanePolygon& polygon)
        : polygon_(polygon),
          n_(polygon.size()),
          exact_ties_(n_ <= exact_tie_corners),
          chords_(polygon),
          directions_(n_, n_),
          largest_(Table::Constant(n_, n_, std::numeric_limits<double>::infinity())),
          second_(largest_),
          apices_(square(static_cast<std::size_t>(n_)), -1),
          first_choice_(n_),
          second_choice_(n_),
          at_i_(n_),
          at_j_(n_) {
        if (exact_ties_) {
            candidates_.assign(apices_.size(), 0);
            hashes_.assign(apices_.size(), 0);
        }
        measure_directions();
        for (Index i = 0; i + 1 < n_; ++i) {
            set_largest(i, i + 1, 0, 0);
        }
    }

    bool run(std::vector<Triangle>& out) {
        for (Index j = 2; j < n_; ++j) {
            for (Index i = j - 2; i >= 0; --i) {
                if (chords_.has(i, j)) bound(i, j);
            }
        }
        if (exact_ties_) resolve(0, n_ - 1);
        out.clear();
        return collect(out);
    }

private:
    using Table = Eigen::ArrayXXd;

    std::size_t slot(Index i, Index j) const {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(n_) + static_cast<std::size_t>(j);
    }

    /// Columns: directions from each corner, counter-clockwise from its next edge, in [0, 2π). The angle of a triangle
    /// is the difference of two.
    void measure_directions() {
        constexpr double turn = 2 * std::numbers::pi;
        for (Index i = 0; i < n_; ++i) {
            for (Index j = i + 1; j < n_; ++j) {
                if (!chords_.has(i, j)) continue;
                const Eigen::Vector2d u = polygon_[j] - polygon_[i];
                const double direction = std::atan2(u.y(), u.x());
                directions_(j, i) = direction;
                directions_(i, j) = direction > 0 ? direction - std::numbers::pi : direction + std::numbers::pi;
            }
        }
        for (Index i = 0; i < n_; ++i) {
            const double first = directions_(polygon_.next(i), i);
            for (Index j = 0; j < n_; ++j) {
                if (j == i || !chords_.has(i, j)) {
                    directions_(j, i) = 0;  // never used
                    continue;
                }
                directions_(j, i) -= first;
                if (directions_(j, i) < 0) directions_(j, i) += turn;
            }
        }
    }

    /// Both ways, so that a part's neighbours on either side lie in a column.
    void set_largest(Index i, Index j, double largest, double second) {
        largest_(i, j) = largest_(j, i) = largest;
        second_(i, j) = second_(j, i) = second;
    }

    /// The angles of the triangle i, k, j.
    std::array<double, 3> angles(Index i, Index k, Index j) const {
        const double a = directions_(j, i) - directions_(k, i);
        const double b = directions_(k, j) - directions_(i, j);
        return {a, b, std::numbers::pi - a - b};
    }

    /// The two largest angles of the part i–j for each apex i + 1, i + 2, …: those of its triangle and of both sides.
    void measure_apices(Index i, Index j, Index count) {
        const auto left1 = largest_.col(i).segment(i + 1, count);
        const auto left2 = second_.col(i).segment(i + 1, count);
        const auto right1 = largest_.col(j).segment(i + 1, count);
        const auto right2 = second_.col(j).segment(i + 1, count);
        auto a = at_i_.head(count);
        auto b = at_j_.head(count);
        auto most = first_choice_.head(count);
        auto next = second_choice_.head(count);
        a = directions_(j, i) - directions_.col(i).segment(i + 1, count);
        b = directions_.col(j).segment(i + 1, count) - directions_(i, j);
        most = a.max(b);
        next = a.min(b);
        a = std::numbers::pi - a - b;
        b = most.min(a).max(next).max(left2.max(right2)).max(left1.min(right1));
        most = most.max(a);
        next = most.min(left1.max(right1)).max(b);
        most = most.max(left1.max(right1));
    }

    /// Finds the two largest angles of the part i–j, and all apices that lead to them.
    void bound(Index i, Index j) {
        const Index count = j - i - 1;
        measure_apices(i, j, count);
        Index& apex = apices_[slot(i, j)];
        while (apex < 0) {
            const double limit1 = first_choice_.head(count).minCoeff() + angle_tolerance;
            if (std::isinf(limit1)) return;
            double limit2 = std::numeric_limits<double>::infinity();
            for (Index m = 0; m < count; ++m) {
                if (first_choice_[m] <= limit1) limit2 = std::min(limit2, second_choice_[m] + angle_tolerance);
            }
            for (Index m = 0; m < count; ++m) {
                if (first_choice_[m] > limit1 || second_choice_[m] > limit2) continue;
                if (polygon_.side(i, i + 1 + m, j) <= 0) {
                    first_choice_[m] = std::numeric_limits<double>::infinity();
                    continue;
                }
                if (apex < 0) apex = i + 1 + m;
                if (exact_ties_) candidates_[slot(i, j)] |= std::uint64_t{1} << m;
            }
        }
        set_largest(i, j, first_choice_[apex - i - 1], second_choice_[apex - i - 1]);
    }

    /// Chooses among the apices of the part i–j by all of its angles.
    void resolve(Index i, Index j) {
        std::uint64_t candidates = std::exchange(candidates_[slot(i, j)], 0);
        if (candidates == 0) return;  // an edge, or done
        Index best = -1;
        std::uint64_t best_hash = 0;
        for (; candidates != 0; candidates &= candidates - 1) {
            const Index k = i + 1 + std::countr_zero(candidates);
            resolve(i, k);
            resolve(k, j);
            const std::uint64_t hash = hash_of(i, k, j);
            if (best >= 0 && (hash == best_hash || !smaller(i, k, j, best))) continue;
            best = k;
            best_hash = hash;
        }
        apices_[slot(i, j)] = best;
        hashes_[slot(i, j)] = best_hash;
    }

    /// Of the angles of the part i–j with apex k. Equal hashes: the lists are equal up to the tolerance. Unequal ones
    /// may be, too.
    std::uint64_t hash_of(Index i, Index k, Index j) const {
        std::uint64_t sum = hashes_[slot(i, k)] + hashes_[slot(k, j)];
        for (const double angle : angles(i, k, j)) {
            auto h = static_cast<std::uint64_t>(angle / angle_tolerance);  // mixed as by splitmix64
            h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9;
            h = (h ^ (h >> 27)) * 0x94d049bb133111eb;
            sum += h ^ (h >> 31);
        }
        return sum;
    }

    struct Part {
        Index i, j;
        friend bool operator==(const Part&, const Part&) = default;
        friend bool operator<(const Part& a, const Part& b) {
            return std::pair(a.j - a.i, a.i) < std::pair(b.j - b.i, b.i);
        }
    };

    /// One of two triangulations that are compared: the angles of triangles, and a heap of resolved parts, the longest
    /// on top.
    struct Side {
        std::vector<double> angles;
        std::vector<Part> parts;

        void push(Part part) {
            if (part.j == part.i + 1) return;
            parts.push_back(part);
            std::push_heap(parts.begin(), parts.end());
        }
        Part pop() {
            std::pop_heap(parts.begin(), parts.end());
            const Part top = parts.back();
            parts.pop_back();
            return top;
        }
    };

    void add_triangle(Side& side, Index i, Index k, Index j) const {
        const auto own = angles(i, k, j);
        side.angles.insert(side.angles.end(), own.begin(), own.end());
        side.push({i, k});
        side.push({k, j});
    }

    /// The apex k gives smaller angles to the part i–j than the best so far. Parts that both have are left out.
    bool smaller(Index i, Index k, Index j, Index best) {
        auto& [ours, theirs] = sides_;
        ours.angles.clear();
        theirs.angles.clear();
        add_triangle(ours, i, k, j);
        add_triangle(theirs, i, best, j);
        while (!ours.parts.empty() || !theirs.parts.empty()) {
            if (!ours.parts.empty() && !theirs.parts.empty() && ours.parts[0] == theirs.parts[0]) {
                ours.pop();
                theirs.pop();
                continue;
            }
            const bool first = theirs.parts.empty() || (!ours.parts.empty() && theirs.parts[0] < ours.parts[0]);
            Side& side = first ? ours : theirs;
            const Part part = side.pop();
            add_triangle(side, part.i, apices_[slot(part.i, part.j)], part.j);
        }
        std::sort(ours.angles.begin(), ours.angles.end(), std::greater<>());
        std::sort(theirs.angles.begin(), theirs.angles.end(), std::greater<>());
        for (std::size_t m = 0; m < ours.angles.size(); ++m) {
            const double difference = ours.angles[m] - theirs.angles[m];
            if (std::abs(difference) > angle_tolerance) return difference < 0;
        }
        return false;
    }

    /// Hands over the triangles of the whole; false if it has none.
    bool collect(std::vector<Triangle>& out) const {
        std::vector<std::pair<Index, Index>> open{{0, n_ - 1}};
        while (!open.empty()) {
            const auto [a, b] = open.back();
            open.pop_back();
            if (b == a + 1) continue;
            const Index k = apices_[slot(a, b)];
            if (k < 0) return false;
            out.push_back({a, k, b});
            open.emplace_back(k, b);
            open.emplace_back(a, k);
        }
        return true;
    }

    const PlanePolygon& polygon_;
    Index n_;
    bool exact_ties_;
    Chords chords_;
    Table directions_;
    Table largest_, second_;     ///< Of each part; infinite where it has no triangulation.
    std::vector<Index> apices_;  ///< Of each part, -1: none.

    // Only for exact ties.
    std::vector<std::uint64_t> candidates_;  ///< Apices of each part, bit m for i + 1 + m; 0 once they are resolved.
    std::vector<std::uint64_t> hashes_;      ///< Sums over the angles of each part.
    std::array<Side, 2> sides_;

    // For one part at a time, by apex.
    Eigen::ArrayXd first_choice_, second_choice_;
    Eigen::ArrayXd at_i_, at_j_;
};

}  // namespace

Status cut_min_max_angle(const PlanePolygon& polygon, std::vector<Triangle>& out) {
    if (MinMaxAngle(polygon).run(out)) return Done{};
    return Error{ErrorCode::degenerate_face, "its projection is too thin to triangulate"};
}

}  // namespace polylap

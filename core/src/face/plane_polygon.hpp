#pragma once

#include <limits>
#include <span>

#include <Eigen/Core>

#include "polylap/base/types.hpp"

namespace polylap {

inline double cross(const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
    return u.x() * v.y() - u.y() * v.x();
}

/// A polygon in the plane with the predicates that its triangulations share. Corner numbers are local, from 0.
class PlanePolygon {
public:
    explicit PlanePolygon(std::span<const Eigen::Vector2d> points);

    Index size() const noexcept { return static_cast<Index>(points_.size()); }
    const Eigen::Vector2d& operator[](Index i) const { return points_[static_cast<std::size_t>(i)]; }
    Index next(Index i) const noexcept { return i + 1 == size() ? 0 : i + 1; }
    Index previous(Index i) const noexcept { return i == 0 ? size() - 1 : i - 1; }

    /// +1, 0 or -1: c lies left of, on, or right of the line a → b. On: within rounding of the coordinates.
    int side(Index a, Index b, Index c) const;

    /// Lengths that differ by less tie, as do angles that corners moved by less could make equal: they were the same
    /// before rounding. 2^-42 of the diameter: coordinates of a mesh of a thousand times that size round by this much,
    /// and projections and turns in space add little.
    double tie_distance() const noexcept;

    /// Turns left at every corner and once around; straight corners do not count as turns.
    bool strictly_convex() const;

    /// Neither crosses nor touches itself. O(n) if strictly convex, otherwise O(n²).
    bool simple() const;

    /// The open segment i–j lies in the interior. Requires simple(), i ≠ j. O(n)
    bool inside_diagonal(Index i, Index j) const;

private:
    /// Coordinates carry rounding errors of a few units in the last place of the diameter.
    static constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();

    int side_of_noise(double area, double lengths) const;
    bool touch(Index i, Index j) const;
    bool within(Index a, Index b, Index c) const;

    std::span<const Eigen::Vector2d> points_;
    double diameter_;  ///< Of the bounding box: the scale of rounding errors.
};

// What small faces spend their time in is inline.

inline PlanePolygon::PlanePolygon(std::span<const Eigen::Vector2d> points) : points_(points) {
    Eigen::Vector2d low = points.front();
    Eigen::Vector2d high = low;
    for (const auto& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    diameter_ = (high - low).norm();
}

inline int PlanePolygon::side(Index a, Index b, Index c) const {
    const Eigen::Vector2d u = (*this)[b] - (*this)[a];
    const Eigen::Vector2d v = (*this)[c] - (*this)[a];
    return side_of_noise(cross(u, v), u.lpNorm<1>() + v.lpNorm<1>());
}

inline int PlanePolygon::side_of_noise(double area, double lengths) const {
    const double noise = rounding * diameter_ * lengths;
    return area > noise ? 1 : (area < -noise ? -1 : 0);
}

inline double PlanePolygon::tie_distance() const noexcept {
    return 0x1p-42 * diameter_;
}

inline bool PlanePolygon::strictly_convex() const {
    Index turns = 0;  // how often the direction of the edges passes that of the x axis
    for (Index i = 0; i < size(); ++i) {
        if (side(previous(i), i, next(i)) <= 0) return false;
        const double before = (*this)[i].y() - (*this)[previous(i)].y();
        const double after = (*this)[next(i)].y() - (*this)[i].y();
        turns += static_cast<Index>(before < 0) & static_cast<Index>(after >= 0);  // no jump: nobody can predict it
    }
    return turns == 1;
}

}  // namespace polylap

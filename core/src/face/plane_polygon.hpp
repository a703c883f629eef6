#pragma once

#include <span>

#include <Eigen/Core>

#include "polylap/base/types.hpp"

namespace polylap {

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
    int side_of_noise(double area, double lengths) const;
    bool touch(Index i, Index j) const;
    bool within(Index a, Index b, Index c) const;

    std::span<const Eigen::Vector2d> points_;
    double diameter_;  ///< Of the bounding box: the scale of rounding errors.
};

}  // namespace polylap

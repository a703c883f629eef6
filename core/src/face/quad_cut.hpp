#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "face/plane_polygon.hpp"
#include "polylap/face/triangulate.hpp"

namespace polylap {

/// Sine and cosine of the angle a–o–b, both times the lengths of its sides.
struct Angle {
    double sine, cosine;
    Angle(const PlanePolygon& p, Index a, Index o, Index b) : Angle(p[a] - p[o], p[b] - p[o]) {}
    Angle(const Eigen::Vector2d& u, const Eigen::Vector2d& v) : sine(cross(u, v)), cosine(u.dot(v)) {}
};

/// What the angles at c and d, opposite the edge a–b, add to: more than π, π, or less.
enum class AngleSum : std::uint8_t { more, tie, less };

/// A tie: moving each corner by the tie distance can turn the sum to either side of π; the four then lie on a circle.
/// @param ca, cb, da, db from c to a, …
inline AngleSum angle_sum(const Eigen::Vector2d& ca, const Eigen::Vector2d& cb, const Eigen::Vector2d& da,
                          const Eigen::Vector2d& db, double tie_distance) {
    const Angle at_c(ca, cb);
    const Angle at_d(db, da);
    const Eigen::Array4d lengths =
        Eigen::Array4d(ca.squaredNorm(), cb.squaredNorm(), da.squaredNorm(), db.squaredNorm()).sqrt();
    const double ac = lengths[0];
    const double bc = lengths[1];
    const double ad = lengths[2];
    const double bd = lengths[3];
    // Sine and cosine of the sum, times all four lengths.
    const double sine = at_c.sine * at_d.cosine + at_c.cosine * at_d.sine;
    const double cosine = at_c.cosine * at_d.cosine - at_c.sine * at_d.sine;
    const double tolerance = tie_distance * ((ac + bc) * (ad * bd) + (ac * bc) * (ad + bd));
    if (std::abs(sine) <= tolerance && cosine < 0) return AngleSum::tie;
    return sine < 0 ? AngleSum::more : AngleSum::less;
}
inline AngleSum angle_sum(const PlanePolygon& p, Index a, Index b, Index c, Index d) {
    return angle_sum(p[a] - p[c], p[b] - p[c], p[a] - p[d], p[b] - p[d], p.tie_distance());
}

/// Edge a → b with c on its left and d on its right is not locally Delaunay: cot(c) + cot(d) < 0.
inline bool should_flip(const PlanePolygon& p, Index a, Index b, Index c, Index d) {
    return angle_sum(p, a, b, c, d) == AngleSum::more && p.side(c, a, d) > 0 && p.side(d, b, c) > 0;
}

using QuadTriangles = std::array<Triangle, 2>;
inline constexpr QuadTriangles cut_at_02{{{0, 1, 2}, {0, 2, 3}}};
inline constexpr QuadTriangles cut_at_13{{{0, 1, 3}, {1, 2, 3}}};

/// Convex beyond doubt: for a triangle or quad that turns left at every corner, far beyond what PlanePolygon::side
/// takes for rounding.
template <std::size_t n>
inline bool clearly_convex(std::span<const Eigen::Vector2d, n> p) {
    static_assert(n == 3 || n == 4, "five left turns may go around twice");
    double squares = 0;  // the square of the diameter is at most twice this
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k) {
        const Eigen::Vector2d edge = p[(k + 1) % n] - p[k];
        squares += edge.squaredNorm();
        least = std::min(least, cross(edge, p[(k + 2) % n] - p[(k + 1) % n]));
    }
    return least > 1e-12 * squares;
}

/// By which diagonal.
enum class QuadCut : std::uint8_t { at_02, at_13 };

/// The Delaunay cut that triangulate_polygon finds. @param p clearly_convex
inline QuadCut cut_convex_quad(std::span<const Eigen::Vector2d, 4> p) {
    const AngleSum sum = angle_sum(PlanePolygon(p), 0, 2, 3, 1);
    return sum == AngleSum::more ? QuadCut::at_13 : QuadCut::at_02;  // in a tie, from corner 0
}

}  // namespace polylap

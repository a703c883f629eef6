#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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

/// By which diagonal; unclear: this has to be found out with more care.
enum class QuadCut : std::uint8_t { at_02, at_13, unclear };

/// The Delaunay cut of a quad that is convex beyond doubt, the one that triangulate_polygon finds.
inline QuadCut cut_convex_quad(std::span<const Eigen::Vector2d, 4> p) {
    const Eigen::Vector2d e0 = p[1] - p[0];
    const Eigen::Vector2d e1 = p[2] - p[1];
    const Eigen::Vector2d e2 = p[3] - p[2];
    const Eigen::Vector2d e3 = p[0] - p[3];
    // Far beyond what PlanePolygon::side takes for rounding: the square of the diameter is at most twice these.
    const double squares = e0.squaredNorm() + e1.squaredNorm() + e2.squaredNorm() + e3.squaredNorm();
    const double least = std::min(std::min(cross(e3, e0), cross(e0, e1)), std::min(cross(e1, e2), cross(e2, e3)));
    if (!(least > 1e-12 * squares)) return QuadCut::unclear;
    const AngleSum sum = angle_sum(e3, -e2, -e0, e1, PlanePolygon(p).tie_distance());
    return sum == AngleSum::more ? QuadCut::at_13 : QuadCut::at_02;  // in a tie, from corner 0
}

}  // namespace polylap

#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include <Eigen/Geometry>

#include "base/safe_norm.hpp"
#include "polylap/face/vector_area.hpp"

// What vector_area.hpp declares, for faces whose number of corners may be known to the compiler.

namespace polylap {

template <std::size_t n>
inline Vector3 vector_area_of(std::span<const Vector3, n> x) {
    if (x.size() == 4) return 0.5 * (x[2] - x[0]).cross(x[3] - x[1]);
    // A fan from the first corner: differences cancel the position of the face in space.
    Vector3 twice = Vector3::Zero();
    for (std::size_t k = 1; k + 1 < x.size(); ++k) {
        twice += (x[k] - x[0]).cross(x[k + 1] - x[0]);
    }
    return 0.5 * twice;
}

/// @param size |area|
template <std::size_t n>
inline bool is_zero_area(std::span<const Vector3, n> x, double size) {
    double squares = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        squares += (x[k + 1 < x.size() ? k + 1 : 0] - x[k]).squaredNorm();
    }
    // The squared perimeter is at most n times the sum of squares; the factor leaves room for their rounding.
    const double bound = 2 * zero_area_ratio * static_cast<double>(x.size()) * squares;
    if (size > bound && bound > 1e-280) return false;
    double perimeter = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        perimeter += (x[k + 1 < x.size() ? k + 1 : 0] - x[k]).norm();
    }
    return size <= zero_area_ratio * perimeter * perimeter;
}

/// Corners in an orthonormal frame of the plane perpendicular to the unit vector `normal`, relative to the first.
/// @param out n points
template <std::size_t n, class Out>
inline void project_along(std::span<const Vector3, n> x, const Vector3& normal, Out& out) {
    // Duff et al.: Building an orthonormal basis, revisited. JCGT 6(1), 2017.
    const double sign = std::copysign(1.0, normal.z());
    const double a = -1 / (sign + normal.z());
    const double b = normal.x() * normal.y() * a;
    const Vector3 axis1(1 + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x());
    const Vector3 axis2(b, sign + normal.y() * normal.y() * a, -normal.y());
    for (std::size_t k = 0; k < x.size(); ++k) {
        const Vector3 d = x[k] - x[0];
        out[k] = Eigen::Vector2d(axis1.dot(d), axis2.dot(d));
    }
}

}  // namespace polylap

#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "polylap/apply/smoothing.hpp"
#include "polylap/operators/operator.hpp"

namespace polylap {

/// An explicit step beyond its limit doubles what is rough, or worse, at each step: coordinates that a step would take
/// beyond this are refused, while areas and volumes of the surface are still numbers.
inline constexpr double largest_coordinate = 1e38;

/// One explicit Euler step of the heat flow, x' = x - t M⁻¹ S x. Unstable beyond a limit, see explicit_stability.
/// Vertices in no face stay.
/// @param time   t > 0, length²
/// @param points V×3, finite
/// @param fixed  distinct vertices that stay; the others move as M x' = M x - t S x says with their rows alone
/// @error bad_argument (t not positive, sizes that do not fit, points not finite, a fixed vertex out of range or
///        twice), mass_not_positive (element = vertex, -1 where M is sparse and none can be named), not_converged
///        (element = vertex: beyond largest_coordinate), out_of_memory, cancelled
Result<SmoothingStep> explicit_step(const OperatorMatrices& matrices, double time, const Points& points,
                                    std::span<const Index> fixed = {}, Monitor monitor = {});

/// What bounds explicit steps: the ends of the spectrum of S x = λ M x, in 1/length².
struct Stability {
    double largest = 0;   ///< λ_max
    double smallest = 0;  ///< 0 where S is positive semi-definite.

    /// Steps t below this are stable: 2 / λ_max, length². 0: none is, for there is a negative eigenvalue, infinity:
    /// all.
    double limit() const {
        if (smallest < 0) return 0;
        return largest > 0 ? 2 / largest : std::numeric_limits<double>::infinity();
    }
    /// By what a step multiplies the roughest mode, 1 - tλ_max; negative: with alternating sign. Where the mode of the
    /// negative eigenvalue grows more, that mode.
    double growth(double time) const {
        const double top = 1 - time * largest;
        const double bottom = 1 - time * smallest;
        return smallest < 0 && std::abs(bottom) > std::abs(top) ? bottom : top;
    }
};

/// A negative eigenvalue counts from this multiple of λ_max.
inline constexpr double negative_eigenvalue_tolerance = 1e-9;

/// @param fixed as in explicit_step
/// @return λ_max, at most the true one, and by Lanczos within 1e-5 of an eigenvalue; measured, within 1e-6 of λ_max
/// @error bad_argument (sizes that do not fit, a fixed vertex out of range or twice; S not symmetric, nor becomes so
///        by weights for its rows), mass_not_positive (element = vertex), not_converged, out_of_memory, cancelled
Result<Stability> explicit_stability(const OperatorMatrices& matrices, std::span<const Index> fixed = {},
                                     Monitor monitor = {});

}  // namespace polylap

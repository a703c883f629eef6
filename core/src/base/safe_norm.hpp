#pragma once

#include <cmath>

#include "polylap/base/types.hpp"

namespace polylap {

/// |v|, quickly where its square is far from the ends of the range of double, else stably.
inline double safe_norm(const Vector3& v) {
    const double square = v.squaredNorm();
    return square > 1e-280 && square < 1e280 ? std::sqrt(square) : v.stableNorm();
}

}  // namespace polylap

#pragma once

#include <span>
#include <vector>

#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

// What problems with fixed values have in common.

namespace polylap {

/// @return per vertex its place in `fixed`, -1 where it is not in there   @error bad_argument (out of range, twice)
Result<std::vector<Index>> places_of(std::span<const Index> fixed, Index vertex_count);

/// @param values a row per fixed vertex   @error bad_argument (another number of rows, a value not finite)
Status check_values(std::span<const Index> fixed, const Eigen::Ref<const Matrix>& values);

Error values_too_far_apart();

/// A part of the matrix graph has no fixed vertex. @param vertex its lowest
Error unconstrained_part(Index vertex);

}  // namespace polylap

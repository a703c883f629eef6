#pragma once

#include <cstdint>
#include <functional>

#include "polylap/base/result.hpp"
#include "polylap/solve/eigenpairs.hpp"

namespace polylap {

/// A X of a symmetric A, column by column.
using BlockOperator = std::function<Result<Matrix>(const Eigen::Ref<const Matrix>& x)>;

struct LanczosOptions {
    Index pairs = 1;          ///< At least 1.
    Index block = 1;          ///< Columns that A is applied to at once; eigenvalues with as many copies are found.
    double tolerance = 0;     ///< Residuals |A x - θ x| end below this multiple of |θ|.
    std::uint64_t start = 0;  ///< The same start, the same result.
};

/// The largest eigenvalues of A on the complement of some directions, in descending order, with their eigenvectors.
/// @param apply    n×b → n×b; its errors end the search
/// @param deflated n×f, orthonormal
/// @return min(pairs, n - f) pairs
/// @error not_converged, and those of `apply`.   Memory: n × (f + 2·pairs + 11·block) doubles
Result<Eigenpairs> largest_eigenpairs(const BlockOperator& apply, const Matrix& deflated,
                                      const LanczosOptions& options);

}  // namespace polylap

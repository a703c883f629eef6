#pragma once

#include <cmath>
#include <string>

#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap {

/// |S|∞, the largest absolute row sum of a symmetric matrix: an upper bound of its |eigenvalues|. 0 for an empty one.
inline double largest_row_sum(const SparseMatrix& symmetric) {
    double largest = 0;
    for (Index k = 0; k < symmetric.outerSize(); ++k) {
        double sum = 0;
        for (SparseMatrix::InnerIterator it(symmetric, k); it; ++it) {
            sum += std::abs(it.value());
        }
        if (!(sum <= largest)) largest = sum;  // keeps what is not a number
    }
    return largest;
}

/// @error bad_argument: not square, not finite, not symmetric beyond rounding
inline Status check_symmetric(const SparseMatrix& matrix) {
    if (matrix.rows() != matrix.cols()) {
        return Error{ErrorCode::bad_argument, "a matrix of " + std::to_string(matrix.rows()) + "×" +
                                                  std::to_string(matrix.cols()) + " has no eigenvalues"};
    }
    constexpr double rounding = 1e-12;  // of |S|∞: far above that of sums in another order, far below what matters
    const double scale = largest_row_sum(matrix);
    if (!std::isfinite(scale)) return Error{ErrorCode::bad_argument, "the matrix is not finite"};
    const SparseMatrix transposed = matrix.transpose();
    const SparseMatrix difference = matrix - transposed;
    for (Index k = 0; k < difference.outerSize(); ++k) {
        for (SparseMatrix::InnerIterator it(difference, k); it; ++it) {
            if (std::abs(it.value()) <= rounding * scale) continue;
            return Error{
                ErrorCode::bad_argument,
                "the matrix is not symmetric at row " + std::to_string(it.index()) + ", column " + std::to_string(k),
                it.index()};
        }
    }
    return Done{};
}

}  // namespace polylap

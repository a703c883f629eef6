#pragma once

#include <cmath>
#include <string>
#include <vector>

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

/// @error bad_argument: not square, not compressed, not finite, not symmetric beyond rounding
inline Status check_symmetric(const SparseMatrix& matrix) {
    if (matrix.rows() != matrix.cols()) {
        return Error{ErrorCode::bad_argument, "a matrix of " + std::to_string(matrix.rows()) + "×" +
                                                  std::to_string(matrix.cols()) + " has no eigenvalues"};
    }
    if (!matrix.isCompressed()) return Error{ErrorCode::bad_argument, "the matrix must be compressed"};
    constexpr double rounding = 1e-12;  // of |S|∞: far above that of sums in another order, far below what matters
    const double scale = largest_row_sum(matrix);
    if (!std::isfinite(scale)) return Error{ErrorCode::bad_argument, "the matrix is not finite"};
    // Columns are taken in order, so that what faces an entry lies further on in its own column each time.
    std::vector<Index> next(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.outerSize());
    const auto facing = [&](Index row, Index column) {
        Index& k = next[static_cast<std::size_t>(column)];
        const Index end = matrix.outerIndexPtr()[column + 1];
        while (k < end && matrix.innerIndexPtr()[k] < row) {
            ++k;
        }
        return k < end && matrix.innerIndexPtr()[k] == row ? matrix.valuePtr()[k] : 0;
    };
    for (Index k = 0; k < matrix.outerSize(); ++k) {
        for (SparseMatrix::InnerIterator it(matrix, k); it; ++it) {
            const auto row = static_cast<Index>(it.index());
            if (std::abs(it.value() - facing(k, row)) <= rounding * scale) continue;
            return Error{ErrorCode::bad_argument,
                         "the matrix is not symmetric at row " + std::to_string(row) + ", column " + std::to_string(k),
                         row};
        }
    }
    return Done{};
}

}  // namespace polylap

#pragma once

#include <algorithm>
#include <cstddef>

#include "polylap/base/types.hpp"

// Plain loops, where Eigen would make a kilobyte of code of each expression.

namespace polylap {

/// Whether a column holds nothing but zeros; NaN is none.
inline bool is_zero(const SparseMatrix& a, Index column) {
    for (SparseMatrix::InnerIterator it(a, column); it; ++it) {
        if (it.value() != 0) return false;
    }
    return true;
}

/// Whether nothing is stored off the diagonal.
inline bool is_diagonal(const SparseMatrix& a) {
    for (Index k = 0; k < a.cols(); ++k) {
        for (SparseMatrix::InnerIterator it(a, k); it; ++it) {
            if (it.index() != k) return false;
        }
    }
    return true;
}

/// out = A x, column by column of `columns` that alternate in memory (a row-major n×columns matrix, or a vector).
inline void multiply(const SparseMatrix& a, const double* x, Index columns, double* out) {
    std::fill(out, out + std::ptrdiff_t{columns} * a.rows(), 0.0);
    for (Index k = 0; k < a.cols(); ++k) {
        const double* const from = x + std::ptrdiff_t{columns} * k;
        for (SparseMatrix::InnerIterator it(a, k); it; ++it) {
            double* const to = out + std::ptrdiff_t{columns} * it.index();
            for (Index c = 0; c < columns; ++c)
                to[c] += it.value() * from[c];
        }
    }
}

}  // namespace polylap

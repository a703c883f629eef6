#pragma once

#include <memory>

#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap {

/// A pivot below this multiple of the row's diagonal entry counts as zero: the matrix is not positive definite, or too
/// nearly singular to tell. Measured: Laplacians with a fixed vertex keep pivots above 1e-7, singular ones fall below
/// 1e-13.
inline constexpr double pivot_tolerance = 1e-12;

/// Sparse Cholesky (LDLᵀ) of a symmetric positive definite matrix: analyse once per pattern, factor once per values,
/// solve often.
class SpdFactor {
public:
    SpdFactor();
    SpdFactor(SpdFactor&&) noexcept;
    SpdFactor& operator=(SpdFactor&&) noexcept;
    ~SpdFactor();

    /// Orders the unknowns (AMD) and finds the pattern of the factor.
    /// @param a n×n, compressed; only the lower triangle is read
    /// @error bad_argument (not square, not compressed), out_of_memory
    Status analyse(const SparseMatrix& a);

    /// Factors. A matrix of another pattern than the last one is analysed first.
    /// @error not_positive_definite (element = row of the pivot), out_of_memory
    Status factor(const SparseMatrix& a);

    /// @param rhs n×k   @return n×k
    /// @error bad_argument (nothing is factored, another number of rows), out_of_memory
    Result<Matrix> solve(const Eigen::Ref<const Matrix>& rhs) const;

    Index size() const noexcept;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace polylap

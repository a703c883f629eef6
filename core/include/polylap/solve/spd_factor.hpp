#pragma once

#include <cstdint>
#include <memory>

#include "polylap/base/monitor.hpp"
#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap {

/// A pivot below this multiple of the row's diagonal entry counts as zero: the matrix is not positive definite, or too
/// nearly singular to tell. Measured: Laplacians with a fixed vertex keep pivots above 1e-7, singular ones fall below
/// 1e-13.
inline constexpr double pivot_tolerance = 1e-12;

/// What is known of a factor before it has numbers: the order of elimination and the pattern of L. Immutable; factors
/// of matrices with the same pattern may share one.
class SpdAnalysis {
public:
    /// @param a         n×n, compressed; only the pattern of the lower triangle is read
    /// @param positions n×3, where the unknowns lie, for nested dissection; without rows, the graph alone decides
    /// @error bad_argument (not square, not compressed, another number of positions), out_of_memory, cancelled
    static Result<std::shared_ptr<const SpdAnalysis>> create(const SparseMatrix& a, const Points& positions = {},
                                                             Monitor monitor = {});
    ~SpdAnalysis();

    /// Whether `a` has the analysed pattern, entry for entry.
    bool fits(const SparseMatrix& a) const;

    Index size() const noexcept;
    std::int64_t factor_entries() const noexcept;  ///< nnz(L), the diagonal included, padding of supernodes not.
    double factor_flops() const noexcept;          ///< Additions and multiplications of one numeric factorisation.

    struct Impl;

private:
    friend class SpdFactor;
    explicit SpdAnalysis(std::unique_ptr<const Impl> impl);
    std::unique_ptr<const Impl> impl_;
};

/// Sparse Cholesky factor of a symmetric positive definite matrix: analyse once per pattern, factor once per values,
/// solve often.
class SpdFactor {
public:
    SpdFactor();
    SpdFactor(SpdFactor&&) noexcept;
    SpdFactor& operator=(SpdFactor&&) noexcept;
    ~SpdFactor();

    /// The same as use(SpdAnalysis::create(…)).
    Status analyse(const SparseMatrix& a, const Points& positions = {}, Monitor monitor = {});
    /// Factors of matrices with that pattern will need no other; forgets the numbers.
    /// @param analysis not null
    void use(std::shared_ptr<const SpdAnalysis> analysis);
    /// Null before the first analysis.
    const std::shared_ptr<const SpdAnalysis>& analysis() const noexcept;

    /// Factors. A matrix of another pattern than the analysed one is analysed first, without positions.
    /// @param a n×n, compressed, finite; only the lower triangle is read
    /// @error not_positive_definite (element = row of the pivot), bad_argument, out_of_memory, cancelled
    Status factor(const SparseMatrix& a, Monitor monitor = {});

    /// @param rhs n×k   @return n×k
    /// @error bad_argument (nothing is factored, another number of rows), out_of_memory
    Result<Matrix> solve(const Eigen::Ref<const Matrix>& rhs) const;

    Index size() const noexcept;
    /// Of memory for the numbers of L.
    std::int64_t bytes() const noexcept;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace polylap

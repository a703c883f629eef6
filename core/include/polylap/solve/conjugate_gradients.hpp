#pragma once

#include "polylap/base/monitor.hpp"
#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap {

/// What |b - Ax| / |b| is brought below, for each right-hand side: about what a Cholesky factor leaves of matrices
/// whose condition number is 10⁴.
inline constexpr double residual_tolerance = 1e-12;

struct GradientOptions {
    double tolerance = residual_tolerance;
    int most_iterations = 10'000;
};

struct GradientSolution {
    Points x;            ///< n×3
    int iterations = 0;  ///< Of the column that needed most.
};

/// Solves A x = b for three right-hand sides by conjugate gradients (Hestenes & Stiefel 1952) with symmetric
/// Gauss-Seidel as preconditioner, whose two half sweeps take the place of the product with A (Eisenstat 1981).
/// A solution is what passes |b - Ax| ≤ tolerance · |b|, column by column, in the Euclidean norm and in that of the
/// preconditioner, which weighs small rows as much as large ones. A singular matrix has one if b is in its range.
/// @param a     n×n, symmetric, stored in full, compressed
/// @param rhs   n×3, finite   @param start n×3, finite: a guess
/// @error not_positive_definite (element = row of a diagonal entry that is not positive, -1: another sign of it),
///        not_converged (most_iterations, or rounding keeps the residual above the tolerance), bad_argument (sizes, not
///        finite),
///        out_of_memory, cancelled.   Cost per iteration: each entry of A is read once for the three columns
Result<GradientSolution> conjugate_gradients(const SparseMatrix& a, const Points& rhs, const Points& start,
                                             const GradientOptions& options = {}, Monitor monitor = {});

}  // namespace polylap

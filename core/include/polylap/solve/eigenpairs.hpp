#pragma once

#include "polylap/base/monitor.hpp"
#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap {

struct Eigenpairs {
    Vector values;   ///< k, ascending.
    Matrix vectors;  ///< n×k, orthonormal.
};

/// Residuals |S x - μ x| and the completeness of the lowest eigenpairs are held to this multiple of |S|∞, the largest
/// absolute row sum of S: at most a few times its largest |eigenvalue|.
inline constexpr double eigenpair_tolerance = 1e-9;

/// The lowest eigenpairs of a symmetric matrix, positive semi-definite or not: dense for small matrices, beyond that
/// shift-invert block Lanczos that goes on until inertia counting (or, where no count is to be had, a search of the
/// complement) shows that no eigenvalue was missed, whatever the multiplicities.
/// @param symmetric n×n, finite, stored in full
/// @param count     at least 1; at most n are returned
/// @param positions n×3, where the unknowns lie, for a better ordering; without rows, the graph alone decides
/// @return min(count, n) pairs.   Cost: two sparse factorisations and about 2·count solves, more for multiple
///         eigenvalues; O(n³) for n ≤ 100 or count > n/4
/// @error bad_argument (not square, compressed, finite and symmetric; count < 1), not_converged, out_of_memory,
/// cancelled
Result<Eigenpairs> lowest_eigenpairs(const SparseMatrix& symmetric, Index count, Monitor monitor = {},
                                     const Points& positions = {});

/// The same for S x = μ M x: the eigenpairs of M^-½ S M^-½, whose vectors M^-½ makes M-orthonormal. Residuals are
/// |S x - μ M x| in the norm of M⁻¹, and held to eigenpair_tolerance of |M^-½ S M^-½|∞. Rows that are empty in both
/// matrices are in no equation: they are left out, and vectors are 0 there.
/// @param mass n×n, diagonal
/// @error mass_not_positive (element = row), bad_argument (also where M is not diagonal or S and M do not fit), and as
///        above
Result<Eigenpairs> lowest_eigenpairs(const SparseMatrix& symmetric, const SparseMatrix& mass, Index count,
                                     Monitor monitor = {}, const Points& positions = {});

/// The largest eigenvalue of a symmetric matrix, by Lanczos: at most the true one, and within 1e-6 of |S|∞ of an
/// eigenvalue (in practice 1e-9 of the largest).
/// @error bad_argument (not square, empty, not finite, not symmetric), not_converged, out_of_memory, cancelled
Result<double> largest_eigenvalue(const SparseMatrix& symmetric, Monitor monitor = {});

/// The number of eigenvalues below `shift`: the negative pivots of S - shift·I = LDLᵀ (Sylvester's law of inertia).
/// Exact but for eigenvalues within eigenpair_tolerance of |S|∞ of the shift.
/// @error not_converged (without row exchanges this shift meets pivots too small to trust: take another one nearby),
///        bad_argument, out_of_memory
Result<Index> count_eigenvalues_below(const SparseMatrix& symmetric, double shift);

}  // namespace polylap

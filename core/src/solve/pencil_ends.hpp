#pragma once

#include "polylap/base/monitor.hpp"
#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap {

/// Of all eigenvalues of S x = μ M x.
struct PencilEnds {
    double smallest = 0;
    double largest = 0;
};

/// The largest eigenvalue is taken for found when the residual, in the norm of M⁻¹, is below this multiple of it: an
/// eigenvalue is at most that far away. Measured, against dense solvers: 1e-6 of it at most, for the error goes with
/// the square of the residual.
inline constexpr double largest_tolerance = 1e-5;
/// The same of the smallest, in multiples of the largest.
inline constexpr double smallest_tolerance = 1e-3;

/// Lanczos without restarts from a random start (Paige 1972: without reorthogonalisation, eigenvalues at the ends are
/// found again and again, but none is wrong). Memory: four vectors. At most the true largest, at least the true
/// smallest eigenvalue.
/// @param s    n×n, symmetric
/// @param mass n×n, diagonal and positive, or symmetric positive definite
/// @param smallest whether that end is asked for; otherwise it is as good as it happens to be
/// @error not_positive_definite (element = row of M), not_converged, cancelled, out_of_memory
Result<PencilEnds> pencil_ends(const SparseMatrix& s, const SparseMatrix& mass, bool smallest, Monitor monitor);

}  // namespace polylap

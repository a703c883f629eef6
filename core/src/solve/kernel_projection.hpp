#pragma once

#include "polylap/base/monitor.hpp"
#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap {

/// A singular value of the constraints below this counts as zero; their rows have length 1 or so.
inline constexpr double kernel_rank_tolerance = 1e-6;

struct KernelProjection {
    Vector shift;    ///< n: x - b
    Index rank = 0;  ///< Singular values of K beyond kernel_rank_tolerance.
};

/// The point x of {Kx = 0} nearest to b, x = b - Kᵀ(KKᵀ)⁺Kb; or, with 0 < μ < ∞, the compromise between both,
/// min |x - b|² + μ|Kx|², which is x = b - Kᵀ(KKᵀ + I/μ)⁻¹Kb.
///
/// KKᵀ may be singular, or nearly so. With a Cholesky factor of KKᵀ + ε, the filter Kᵀ(KKᵀ + ε)⁻¹K has eigenvalues 0
/// and nearly 1, so that conjugate gradients on it take the part of b along the rows of K away in a few steps; it lives
/// in the space of x, where the kernel of Kᵀ amplifies nothing. The rank is the inertia of KKᵀ - tolerance²·I, which by
/// Sylvester's law the pivots of a second factor with the same ordering show.
/// @param transposed Kᵀ, n×m, columns of length 1 or so
/// @param b          n
/// @param mu         > 0; infinite, or beyond 1e11: exactly Kx = 0, as far as rounding of b allows
/// @error cancelled, out_of_memory.   Cost: two sparse factors of order m, a few solves
Result<KernelProjection> project_onto_kernel(const SparseMatrix& transposed, const Vector& b, double mu,
                                             Monitor monitor);

}  // namespace polylap

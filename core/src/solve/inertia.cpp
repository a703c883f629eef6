#include <cmath>

#include <Eigen/SparseCholesky>

#include "polylap/solve/eigenpairs.hpp"
#include "solve/symmetric_check.hpp"

namespace polylap {
namespace {

/// Largest diagonal entry of |L| |D| |L|ᵀ relative to |S|∞ that a count may have. The pivots are those of a matrix that
/// differs from S by rounding, 1e-16 per term, times that: below eigenpair_tolerance for up to 100 terms.
constexpr double growth_limit = 1e5;

}  // namespace

Result<Index> count_eigenvalues_below(const SparseMatrix& symmetric, double shift) {
    return guard_memory([&]() -> Result<Index> {
        if (Status status = check_symmetric(symmetric); !status) return status.error();
        const auto n = static_cast<Index>(symmetric.rows());
        if (!std::isfinite(shift)) return Error{ErrorCode::bad_argument, "the shift must be finite"};
        if (n == 0) return Index{0};

        const Error refused{ErrorCode::not_converged, "the shift is too close to an eigenvalue of a leading block"};
        Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>> ldlt;
        ldlt.setShift(-shift);
        ldlt.compute(symmetric);
        if (ldlt.info() != Eigen::Success) return refused;

        const Vector pivots = ldlt.vectorD();
        const SparseMatrix& lower = ldlt.matrixL().nestedExpression();  // its diagonal of ones is not stored
        Vector size = pivots.cwiseAbs();
        for (Index k = 0; k < n; ++k) {
            for (SparseMatrix::InnerIterator it(lower, k); it; ++it) {
                size[it.index()] += it.value() * it.value() * std::abs(pivots[k]);
            }
        }
        const double scale = largest_row_sum(symmetric) + std::abs(shift);
        if (!(size.maxCoeff() <= growth_limit * scale)) return refused;  // also where it is not a number
        return static_cast<Index>((pivots.array() < 0).count());
    });
}

}  // namespace polylap

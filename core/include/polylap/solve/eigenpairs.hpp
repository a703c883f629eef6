#pragma once

#include "polylap/base/monitor.hpp"
#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap {

struct Eigenpairs {
    Vector values;   ///< k, ascending.
    Matrix vectors;  ///< n×k, orthonormal.
};

/// The lowest eigenpairs of a symmetric matrix, positive semi-definite or not: dense for small matrices, shift-invert
/// Lanczos (Spectra) beyond.
/// @param count at least 1; at most n are returned   @return residuals ≤ 1e-8 of the largest eigenvalue
/// @error bad_argument, not_converged, out_of_memory, cancelled
Result<Eigenpairs> lowest_eigenpairs(const SparseMatrix& symmetric, Index count, Monitor monitor = {});

/// The largest eigenvalue of a symmetric matrix.
/// @error not_converged, out_of_memory, cancelled
Result<double> largest_eigenvalue(const SparseMatrix& symmetric, Monitor monitor = {});

}  // namespace polylap

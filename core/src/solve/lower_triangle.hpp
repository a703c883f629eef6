#pragma once

#include "polylap/base/types.hpp"

namespace polylap {

/// The lower triangle with the diagonal of a compressed square matrix: all that a Cholesky factor reads, in memory for
/// no more. (Eigen's triangularView would make room as it goes.)
SparseMatrix lower_triangle(const SparseMatrix& a);

}  // namespace polylap

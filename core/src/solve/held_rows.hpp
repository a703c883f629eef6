#pragma once

#include <vector>

#include "polylap/base/types.hpp"

// Fixed vertices in systems that keep their size and pattern, so that one analysis serves with and without them.

namespace polylap {

/// Cuts rows off from all others: no entry in their rows and columns but `diagonal` on the diagonal. The pattern stays.
/// @param place n, -1: not held (see places_of)
void hold_rows(SparseMatrix& a, const std::vector<Index>& place, const Vector& diagonal);

/// factor · A_IB: what the other rows have in the columns of held ones.
std::vector<Eigen::Triplet<double, Index>> held_entries(const SparseMatrix& a, double factor,
                                                        const std::vector<Index>& place);

/// a += diag(d)
void add_diagonal(SparseMatrix& a, const Vector& d);

}  // namespace polylap

#include "solve/held_rows.hpp"

namespace polylap {

void hold_rows(SparseMatrix& a, const std::vector<Index>& place, const Vector& diagonal) {
    const auto held = [&](Index v) { return place[static_cast<std::size_t>(v)] >= 0; };
    for (Index k = 0; k < a.cols(); ++k) {
        for (SparseMatrix::InnerIterator it(a, k); it; ++it) {
            const auto row = static_cast<Index>(it.index());
            if (held(row) || held(k)) it.valueRef() = row == k ? diagonal[k] : 0;
        }
    }
}

std::vector<Eigen::Triplet<double, Index>> held_entries(const SparseMatrix& a, double factor,
                                                        const std::vector<Index>& place) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index k = 0; k < a.cols(); ++k) {
        if (place[static_cast<std::size_t>(k)] < 0) continue;
        for (SparseMatrix::InnerIterator it(a, k); it; ++it) {
            const auto row = static_cast<Index>(it.index());
            if (place[static_cast<std::size_t>(row)] < 0) entries.emplace_back(row, k, factor * it.value());
        }
    }
    return entries;
}

void add_diagonal(SparseMatrix& a, const Vector& d) {
    a += SparseMatrix(d.asDiagonal());
}

}  // namespace polylap

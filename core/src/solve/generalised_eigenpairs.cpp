#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "polylap/solve/eigenpairs.hpp"
#include "solve/sparse_loops.hpp"

namespace polylap {
namespace {

/// M^-½ of the rows that are in an equation, and which these are.
struct Scaling {
    std::vector<Index> rows;
    std::vector<Index> place;  ///< n, in `rows`; -1: in no equation.
    Vector inverse_root;

    /// M^-½ S M^-½
    SparseMatrix apply(const SparseMatrix& s) const {
        const auto n = static_cast<Index>(rows.size());
        SparseMatrix scaled(n, n);
        scaled.reserve(s.nonZeros());
        for (Index k = 0; k < n; ++k) {
            scaled.startVec(k);
            for (SparseMatrix::InnerIterator it(s, rows[static_cast<std::size_t>(k)]); it; ++it) {
                const Index row = place[static_cast<std::size_t>(it.index())];
                if (row < 0) continue;  // a zero
                scaled.insertBack(row, k) = it.value() * (inverse_root[row] * inverse_root[k]);
            }
        }
        scaled.finalize();
        return scaled;
    }
};

Result<Scaling> scaling_of(const SparseMatrix& s, const SparseMatrix& mass) {
    Scaling scaling;
    scaling.place.assign(static_cast<std::size_t>(s.rows()), -1);
    const Vector diagonal = mass.diagonal();
    for (Index v = 0; v < s.rows(); ++v) {
        for (SparseMatrix::InnerIterator it(mass, v); it; ++it) {
            if (it.index() != v && it.value() != 0) {
                return Error{ErrorCode::bad_argument,
                             "eigenpairs need a diagonal (lumped) mass, and column " + std::to_string(v) +
                                 " of this one has other entries",
                             v};
            }
        }
        if (!(diagonal[v] > 0 && std::isfinite(diagonal[v]))) {
            if (diagonal[v] == 0 && is_zero(s, v)) continue;
            return Error{ErrorCode::mass_not_positive, "the mass of vertex " + std::to_string(v) + " is not positive",
                         v};
        }
        scaling.place[static_cast<std::size_t>(v)] = static_cast<Index>(scaling.rows.size());
        scaling.rows.push_back(v);
    }
    scaling.inverse_root = diagonal(scaling.rows).cwiseSqrt().cwiseInverse();
    return scaling;
}

}  // namespace

Result<Eigenpairs> lowest_eigenpairs(const SparseMatrix& symmetric, const SparseMatrix& mass, Index count,
                                     Monitor monitor, const Points& positions) {
    const auto n = symmetric.rows();
    if (symmetric.cols() != n || mass.rows() != n || mass.cols() != n ||
        (positions.rows() != 0 && positions.rows() != n)) {
        return Error{ErrorCode::bad_argument, "stiffness, mass and positions must be of the same size"};
    }
    return guard_memory([&]() -> Result<Eigenpairs> {
        const auto scaling = scaling_of(symmetric, mass);
        if (!scaling) return scaling.error();
        const Points places = positions.rows() == 0 ? Points(0, 3) : Points(positions(scaling->rows, Eigen::all));
        auto pairs = lowest_eigenpairs(scaling->apply(symmetric), count, monitor, places);
        if (!pairs) return pairs;
        Matrix vectors = Matrix::Zero(n, pairs->vectors.cols());
        vectors(scaling->rows, Eigen::all) = scaling->inverse_root.asDiagonal() * pairs->vectors;
        pairs->vectors = std::move(vectors);
        return pairs;
    });
}

}  // namespace polylap

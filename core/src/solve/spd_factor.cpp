#include "polylap/solve/spd_factor.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <Eigen/SparseCholesky>

namespace polylap {

struct SpdFactor::Impl {
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>> ldlt;
    Index size = 0;
    bool factored = false;
    std::vector<Index> outer, inner;  ///< The analysed pattern.

    bool same_pattern(const SparseMatrix& a) const {
        return a.rows() == size && static_cast<std::size_t>(a.nonZeros()) == inner.size() &&
               std::equal(outer.begin(), outer.end(), a.outerIndexPtr()) &&
               std::equal(inner.begin(), inner.end(), a.innerIndexPtr());
    }
};

SpdFactor::SpdFactor() : impl_(std::make_unique<Impl>()) {}
SpdFactor::SpdFactor(SpdFactor&&) noexcept = default;
SpdFactor& SpdFactor::operator=(SpdFactor&&) noexcept = default;
SpdFactor::~SpdFactor() = default;

Status SpdFactor::analyse(const SparseMatrix& a) {
    if (a.rows() != a.cols()) {
        impl_->factored = false;
        return Error{ErrorCode::bad_argument, "a matrix of " + std::to_string(a.rows()) + "×" +
                                                  std::to_string(a.cols()) + " has no Cholesky factor"};
    }
    if (!a.isCompressed()) return Error{ErrorCode::bad_argument, "the matrix must be compressed"};
    return guard_memory([&]() -> Status {
        impl_->size = 0;  // nothing is analysed until all of it is
        impl_->factored = false;
        impl_->inner.clear();
        if (a.rows() > 0) impl_->ldlt.analyzePattern(a);
        impl_->outer.assign(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1);
        impl_->inner.assign(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros());
        impl_->size = static_cast<Index>(a.rows());
        return Done{};
    });
}

Status SpdFactor::factor(const SparseMatrix& a) {
    if (!a.isCompressed() || impl_->outer.empty() || !impl_->same_pattern(a)) {
        if (Status status = analyse(a); !status) return status;
    }
    impl_->factored = impl_->size == 0;
    if (impl_->factored) return Done{};
    return guard_memory([&]() -> Status {
        impl_->ldlt.factorize(a);
        const Vector pivots = impl_->ldlt.vectorD();
        const auto& original = impl_->ldlt.permutationPinv().indices();
        for (Index k = 0; k < impl_->size; ++k) {
            const Index row = original.size() > 0 ? original[k] : k;
            if (pivots[k] > pivot_tolerance * std::abs(a.coeff(row, row))) continue;
            return Error{ErrorCode::not_positive_definite,
                         "the matrix is not positive definite (pivot of row " + std::to_string(row) + ")", row};
        }
        impl_->factored = true;
        return Done{};
    });
}

Result<Matrix> SpdFactor::solve(const Eigen::Ref<const Matrix>& rhs) const {
    return guard_memory([&]() -> Result<Matrix> {
        if (!impl_->factored) return Error{ErrorCode::bad_argument, "no matrix has been factored"};
        if (rhs.rows() != impl_->size) {
            return Error{ErrorCode::bad_argument, "the factor has " + std::to_string(impl_->size) +
                                                      " rows, but the right-hand side has " +
                                                      std::to_string(rhs.rows())};
        }
        if (impl_->size == 0) return Matrix(0, rhs.cols());
        return Matrix(impl_->ldlt.solve(rhs));
    });
}

Index SpdFactor::size() const noexcept {
    return impl_->size;
}

}  // namespace polylap

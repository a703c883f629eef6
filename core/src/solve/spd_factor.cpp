#include "polylap/solve/spd_factor.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/SparseCholesky>

namespace polylap {

struct SpdAnalysis::Impl {
    Index size = 0;
    std::vector<Index> outer, inner;
    std::int64_t entries = 0;
    double flops = 0;
};

SpdAnalysis::SpdAnalysis(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {}
SpdAnalysis::~SpdAnalysis() = default;

Result<std::shared_ptr<const SpdAnalysis>> SpdAnalysis::create(const SparseMatrix& a, const Points& positions,
                                                               Monitor monitor) {
    if (a.rows() != a.cols()) {
        return Error{ErrorCode::bad_argument, "a matrix of " + std::to_string(a.rows()) + "×" +
                                                  std::to_string(a.cols()) + " has no Cholesky factor"};
    }
    if (!a.isCompressed()) return Error{ErrorCode::bad_argument, "the matrix must be compressed"};
    if (positions.rows() != 0 && positions.rows() != a.rows()) {
        return Error{ErrorCode::bad_argument, "the matrix has " + std::to_string(a.rows()) + " rows, but " +
                                                  std::to_string(positions.rows()) + " positions were given"};
    }
    if (!monitor.proceed(0)) return Error{ErrorCode::cancelled, "cancelled"};
    return guard_memory([&]() -> Result<std::shared_ptr<const SpdAnalysis>> {
        auto impl = std::make_unique<Impl>();
        impl->size = static_cast<Index>(a.rows());
        impl->outer.assign(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1);
        impl->inner.assign(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros());
        return std::shared_ptr<const SpdAnalysis>(new SpdAnalysis(std::move(impl)));
    });
}

bool SpdAnalysis::fits(const SparseMatrix& a) const {
    return a.isCompressed() && a.rows() == impl_->size &&
           static_cast<std::size_t>(a.nonZeros()) == impl_->inner.size() &&
           std::equal(impl_->outer.begin(), impl_->outer.end(), a.outerIndexPtr()) &&
           std::equal(impl_->inner.begin(), impl_->inner.end(), a.innerIndexPtr());
}

Index SpdAnalysis::size() const noexcept {
    return impl_->size;
}
std::int64_t SpdAnalysis::factor_entries() const noexcept {
    return impl_->entries;
}
double SpdAnalysis::factor_flops() const noexcept {
    return impl_->flops;
}

struct SpdFactor::Impl {
    std::shared_ptr<const SpdAnalysis> analysis;
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>> ldlt;
    bool factored = false;
};

SpdFactor::SpdFactor() : impl_(std::make_unique<Impl>()) {}
SpdFactor::SpdFactor(SpdFactor&&) noexcept = default;
SpdFactor& SpdFactor::operator=(SpdFactor&&) noexcept = default;
SpdFactor::~SpdFactor() = default;

Status SpdFactor::analyse(const SparseMatrix& a, const Points& positions, Monitor monitor) {
    impl_->factored = false;
    auto analysis = SpdAnalysis::create(a, positions, monitor);
    if (!analysis) return analysis.error();
    use(*std::move(analysis));
    return Done{};
}

void SpdFactor::use(std::shared_ptr<const SpdAnalysis> analysis) {
    impl_->factored = false;
    impl_->analysis = std::move(analysis);
}

const std::shared_ptr<const SpdAnalysis>& SpdFactor::analysis() const noexcept {
    return impl_->analysis;
}

Status SpdFactor::factor(const SparseMatrix& a, Monitor monitor) {
    if (impl_->analysis == nullptr || !impl_->analysis->fits(a)) {
        if (Status status = analyse(a, {}, monitor); !status) return status;
    }
    impl_->factored = size() == 0;
    if (impl_->factored) return Done{};
    return guard_memory([&]() -> Status {
        impl_->ldlt.compute(a);
        const Vector pivots = impl_->ldlt.vectorD();
        const auto& original = impl_->ldlt.permutationPinv().indices();
        for (Index k = 0; k < size(); ++k) {
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
        if (rhs.rows() != size()) {
            return Error{ErrorCode::bad_argument, "the factor has " + std::to_string(size()) +
                                                      " rows, but the right-hand side has " +
                                                      std::to_string(rhs.rows())};
        }
        if (size() == 0) return Matrix(0, rhs.cols());
        return Matrix(impl_->ldlt.solve(rhs));
    });
}

Index SpdFactor::size() const noexcept {
    return impl_->analysis == nullptr ? 0 : impl_->analysis->size();
}

}  // namespace polylap

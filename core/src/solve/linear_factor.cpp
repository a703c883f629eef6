#include "polylap/solve/linear_factor.hpp"

#include <string>
#include <utility>

#include "polylap/solve/spd_factor.hpp"
#include "solve/lu_factor.hpp"

namespace polylap {
struct LinearFactor::Impl {
    SpdFactor cholesky;
    LuFactor lu;
    enum class Solver : std::uint8_t { none, cholesky, lu } solver = Solver::none;
    Index size = 0;
};

LinearFactor::LinearFactor() : impl_(std::make_unique<Impl>()) {}
LinearFactor::LinearFactor(LinearFactor&&) noexcept = default;
LinearFactor& LinearFactor::operator=(LinearFactor&&) noexcept = default;
LinearFactor::~LinearFactor() = default;

void LinearFactor::use(std::shared_ptr<const SpdAnalysis> analysis) {
    impl_->solver = Impl::Solver::none;
    impl_->cholesky.use(std::move(analysis));
}

const std::shared_ptr<const SpdAnalysis>& LinearFactor::analysis() const noexcept {
    return impl_->cholesky.analysis();
}

bool LinearFactor::is_cholesky() const noexcept {
    return impl_->solver == Impl::Solver::cholesky;
}

Status LinearFactor::factor(const SparseMatrix& a, Structure structure, const Points& positions, Monitor monitor) {
    impl_->solver = Impl::Solver::none;
    if (a.rows() != a.cols()) {
        return Error{ErrorCode::bad_argument,
                     "a matrix of " + std::to_string(a.rows()) + "×" + std::to_string(a.cols()) + " has no factor"};
    }
    if (!a.isCompressed()) return Error{ErrorCode::bad_argument, "the matrix must be compressed"};
    impl_->size = static_cast<Index>(a.rows());
    if (structure != Structure::general || impl_->size == 0) {
        if (const auto& known = analysis(); known == nullptr || !known->fits(a)) {
            Stretch analysing{monitor, 0, 0.2};
            if (Status status = impl_->cholesky.analyse(a, positions, analysing.monitor()); !status) return status;
        }
        Stretch factoring{monitor, 0.2, 1};
        Status status = impl_->cholesky.factor(a, factoring.monitor());
        if (status) impl_->solver = Impl::Solver::cholesky;
        const bool indefinite = !status && status.error().code == ErrorCode::not_positive_definite;
        if (!indefinite || structure == Structure::positive_semidefinite) return status;
    }
    return guard_memory([&]() -> Status {
        if (Status status = impl_->lu.factor(a); !status) return status;
        impl_->solver = Impl::Solver::lu;
        return Done{};
    });
}

Result<Matrix> LinearFactor::solve(const Eigen::Ref<const Matrix>& rhs) const {
    return guard_memory([&]() -> Result<Matrix> {
        if (impl_->solver == Impl::Solver::none) return Error{ErrorCode::bad_argument, "no matrix has been factored"};
        if (impl_->solver == Impl::Solver::cholesky) return impl_->cholesky.solve(rhs);
        if (rhs.rows() != impl_->size) {
            return Error{ErrorCode::bad_argument, "the factor has " + std::to_string(impl_->size) +
                                                      " rows, but the right-hand side has " +
                                                      std::to_string(rhs.rows())};
        }
        return impl_->lu.solve(rhs);
    });
}

std::int64_t LinearFactor::bytes() const noexcept {
    return impl_->cholesky.bytes() + impl_->lu.bytes();
}

}  // namespace polylap

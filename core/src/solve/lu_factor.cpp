#include "solve/lu_factor.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/SparseLU>

#include "polylap/solve/linear_factor.hpp"

namespace polylap {

struct LuFactor::Impl {
    Status factor(const SparseMatrix& a) {
        const auto n = static_cast<Index>(a.rows());
        row_scale_ = Vector::Zero(n);
        for (Index k = 0; k < n; ++k) {
            for (SparseMatrix::InnerIterator it(a, k); it; ++it) {
                if (!std::isfinite(it.value())) {
                    return Error{ErrorCode::bad_argument,
                                 "the matrix is not finite in row " + std::to_string(it.index()), it.index()};
                }
                row_scale_[it.index()] = std::max(row_scale_[it.index()], std::abs(it.value()));
            }
        }
        for (Index row = 0; row < n; ++row) {
            if (row_scale_[row] == 0) return singular(row, "is empty");
            row_scale_[row] = 1 / row_scale_[row];
        }
        const SparseMatrix scaled = row_scale_.asDiagonal() * a;
        if (!lu_ || !same_pattern(a)) analyse(scaled);
        lu_->factorize(scaled);
        if (const std::string& why = lu_->lastErrorMessage(); !why.empty()) {
            const bool no_pivot = why.find("SINGULAR") != std::string::npos;
            lu_.reset();  // its message would stay
            if (!no_pivot) return Error{ErrorCode::out_of_memory, "out of memory"};
            return singular(-1, "");
        }
        if (const auto [condition, row] = estimate_condition(scaled); !(condition <= condition_limit)) {
            return singular(row, "is the most affected");
        }
        return Done{};
    }

    Matrix solve(const Eigen::Ref<const Matrix>& rhs) const { return lu_->solve(row_scale_.asDiagonal() * rhs); }

    std::int64_t bytes() const {
        return lu_ ? std::int64_t{lu_->nnzL() + lu_->nnzU()} * static_cast<std::int64_t>(sizeof(double)) : 0;
    }

    static Error singular(Index row, const char* what) {
        std::string where = row < 0 ? "" : ": row " + std::to_string(row) + " " + what;
        return {ErrorCode::not_positive_definite, "the matrix is singular to working precision" + where, row};
    }

private:
    void analyse(const SparseMatrix& a) {
        lu_.emplace();
        lu_->analyzePattern(a);
        outer_.assign(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1);
        inner_.assign(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros());
    }
    bool same_pattern(const SparseMatrix& a) const {
        return static_cast<std::size_t>(a.outerSize()) + 1 == outer_.size() &&
               static_cast<std::size_t>(a.nonZeros()) == inner_.size() &&
               std::equal(outer_.begin(), outer_.end(), a.outerIndexPtr()) &&
               std::equal(inner_.begin(), inner_.end(), a.innerIndexPtr());
    }

    /// |A|∞ |A⁻¹ x| / |x| in the maximum norm, for an x that three rounds of inverse iteration with AᵀA drive towards
    /// the least singular vector: a lower bound of the condition number, and the largest entry of A⁻¹ x.
    std::pair<double, Index> estimate_condition(const SparseMatrix& a) {
        Vector sums = Vector::Zero(a.rows());
        for (Index k = 0; k < a.outerSize(); ++k) {
            for (SparseMatrix::InnerIterator it(a, k); it; ++it) {
                sums[it.index()] += std::abs(it.value());
            }
        }
        const double norm = sums.maxCoeff();
        Vector x(a.rows());
        for (Index i = 0; i < x.size(); ++i) {
            x[i] = 1 + 0.5 * std::sin(1.0 + i);  // in no likely direction, and the same each time
        }
        double condition = 0;
        Eigen::Index row = -1;
        for (int round = 0; round < 3; ++round) {
            const double before = x.cwiseAbs().maxCoeff();
            x = Vector(lu_->solve(x));
            const double after = x.cwiseAbs().maxCoeff(&row);
            if (!std::isfinite(after)) return {after, -1};
            condition = std::max(condition, norm * after / before);
            x = Vector(lu_->transpose().solve(Vector(x / after)));
            x /= x.cwiseAbs().maxCoeff();
            if (!x.allFinite()) break;
        }
        return {condition, static_cast<Index>(row)};
    }

    using Lu = Eigen::SparseLU<SparseMatrix, Eigen::COLAMDOrdering<Index>>;
    std::optional<Lu> lu_;
    Vector row_scale_;
    std::vector<Index> outer_, inner_;  ///< The analysed pattern.
};

LuFactor::LuFactor() : impl_(std::make_unique<Impl>()) {}
LuFactor::LuFactor(LuFactor&&) noexcept = default;
LuFactor& LuFactor::operator=(LuFactor&&) noexcept = default;
LuFactor::~LuFactor() = default;

Status LuFactor::factor(const SparseMatrix& a) {
    return impl_->factor(a);
}

Matrix LuFactor::solve(const Eigen::Ref<const Matrix>& rhs) const {
    return impl_->solve(rhs);
}

std::int64_t LuFactor::bytes() const noexcept {
    return impl_->bytes();
}

}  // namespace polylap

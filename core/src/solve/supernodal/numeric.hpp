#pragma once

#include <memory>

#include "polylap/base/monitor.hpp"
#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"
#include "solve/dense/kernels.hpp"
#include "solve/supernodal/symbolic.hpp"

namespace polylap {

/// The numbers of L.
class Numeric {
public:
    explicit Numeric(const dense::Kernels& kernels = *dense::kernels().front()) : kernels_(&kernels) {}

    /// L of a matrix with the analysed pattern.
    /// @error not_positive_definite, bad_argument (not finite; both: element = row), out_of_memory, cancelled
    Status factor(const Symbolic& symbolic, const SparseMatrix& a, const Monitor& monitor);

    /// Solves with the factor in hand. @param rhs n×k   @return n×k
    Matrix solve(const Symbolic& symbolic, const Eigen::Ref<const Matrix>& rhs) const;

private:
    const dense::Kernels* kernels_;
    std::unique_ptr<double[]> values_;  ///< Trapezoids, see Panels; behind them the stack had its place.
    std::size_t capacity_ = 0;
};

}  // namespace polylap

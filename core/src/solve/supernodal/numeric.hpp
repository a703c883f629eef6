#pragma once

#include <cstdint>
#include <memory>
#include <numeric>
#include <vector>

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

    std::int64_t bytes() const noexcept {
        return static_cast<std::int64_t>(std::accumulate(sizes_.begin(), sizes_.end(), std::size_t{0}) *
                                         sizeof(double));
    }

private:
    void make_room(const Symbolic& symbolic);

    const dense::Kernels* kernels_;
    std::vector<std::unique_ptr<double[]>> pieces_;
    std::vector<std::size_t> sizes_;  ///< Of the pieces, in doubles.
    std::vector<double*> fronts_;     ///< Of each supernode, in one of the pieces; see Panels.
};

}  // namespace polylap

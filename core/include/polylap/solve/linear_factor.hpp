#pragma once

#include <cstdint>
#include <memory>

#include "polylap/solve/spd_factor.hpp"
#include "polylap/solve/structure.hpp"

namespace polylap {

/// A general matrix whose rows were scaled to a largest |entry| of 1 counts as singular when its condition number, by
/// inverse iteration, is beyond this. Measured: random walks on tori with a
/// fixed vertex have 2e3 (450 vertices) to 1.4e5 (20 000), about seven times the vertices; without one, beyond 1e17.
inline constexpr double condition_limit = 1e13;

/// Factor of a nonsingular sparse matrix by the solver that its structure allows: Cholesky where it is positive
/// semi-definite; Cholesky first and LU where that fails on a symmetric one; LU on others.
class LinearFactor {
public:
    LinearFactor();
    LinearFactor(LinearFactor&&) noexcept;
    LinearFactor& operator=(LinearFactor&&) noexcept;
    ~LinearFactor();

    /// Keeps ordering and symbolic analysis while the pattern stands.
    /// @param positions n×3, where the unknowns lie, for a better ordering; without rows, the graph alone decides
    /// @error not_positive_definite (element = row; also for a singular matrix of other structure, then -1 where no row
    /// can be named), bad_argument, out_of_memory, cancelled
    Status factor(const SparseMatrix& a, Structure structure, const Points& positions = {}, Monitor monitor = {});
    /// Makes Cholesky factors of that pattern need no analysis of their own.
    /// @param analysis not null
    void use(std::shared_ptr<const SpdAnalysis> analysis);
    /// That of the Cholesky factor; null before there was one.
    const std::shared_ptr<const SpdAnalysis>& analysis() const noexcept;

    /// Whether the last factor is a Cholesky factor, rather than LU.
    bool is_cholesky() const noexcept;

    /// @param rhs n×k   @return n×k
    /// @error bad_argument (nothing is factored, another number of rows), out_of_memory
    Result<Matrix> solve(const Eigen::Ref<const Matrix>& rhs) const;

    /// Of memory for the factors' numbers.
    std::int64_t bytes() const noexcept;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace polylap

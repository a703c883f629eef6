#pragma once

#include <cstdint>
#include <memory>

#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap {

/// LU of a sparse matrix with each row divided by its largest |entry|.
class LuFactor {
public:
    LuFactor();
    LuFactor(LuFactor&&) noexcept;
    LuFactor& operator=(LuFactor&&) noexcept;
    ~LuFactor();

    /// Keeps the symbolic analysis while the pattern stands.
    /// @param a square, compressed
    /// @error not_positive_definite (singular to working precision, see condition_limit; element = row, -1 where none
    /// can be named), bad_argument (not finite), out_of_memory
    Status factor(const SparseMatrix& a);
    /// @param rhs n×k, of the matrix factored last   @return n×k
    Matrix solve(const Eigen::Ref<const Matrix>& rhs) const;
    /// Of memory for the factors' numbers.
    std::int64_t bytes() const noexcept;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace polylap

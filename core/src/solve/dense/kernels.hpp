#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace polylap::dense {

/// Rows that loads may touch past the end of a matrix: every matrix handed to a kernel is followed by as many doubles
/// that may be read. They may hold anything: what is computed from them is not stored.
inline constexpr std::size_t slack = 8;

/// Columns of a front that are eliminated between two calls of `downdate`; its `depth` may not be larger.
inline constexpr std::ptrdiff_t block_columns = 256;

/// Right-hand sides that a solve takes at once.
inline constexpr std::ptrdiff_t rhs_block = 8;

/// The dense inner loops of the Cholesky factor, for one instruction set. Matrices are column-major; of a trapezoid
/// (rows ≥ columns) what lies above the diagonal is scratch.
struct Kernels {
    const char* name;

    /// Cholesky factor of a trapezoid in place: L₁₁ L₁₁ᵀ = A₁₁, L₂₁ = A₂₁ L₁₁⁻ᵀ.
    /// @param least   columns; a pivot that is not larger than its own is refused
    /// @param scratch `scratch_doubles`
    /// @return the column refused, or -1
    std::ptrdiff_t (*factor)(double* a, std::ptrdiff_t stride, std::ptrdiff_t rows, std::ptrdiff_t columns,
                             const double* least, double* scratch);

    /// C −= A A₁ᵀ on a trapezoid, A₁ being the first `columns` rows of A; with `overwrite`, C = −A A₁ᵀ.
    /// @param depth columns of A, at most block_columns
    void (*downdate)(double* c, std::ptrdiff_t c_stride, std::ptrdiff_t rows, std::ptrdiff_t columns, const double* a,
                     std::ptrdiff_t a_stride, std::ptrdiff_t depth, bool overwrite, double* scratch);

    /// x₁ = L₁₁⁻¹ x₁, x₂ −= L₂₁ x₁.
    /// @param x rows×width, row-major; width is 1, 4 or rhs_block
    void (*forward)(const double* l, std::ptrdiff_t stride, std::ptrdiff_t rows, std::ptrdiff_t columns, double* x,
                    std::ptrdiff_t width);
    /// x₁ = L₁₁⁻ᵀ (x₁ − L₂₁ᵀ x₂).
    void (*backward)(const double* l, std::ptrdiff_t stride, std::ptrdiff_t rows, std::ptrdiff_t columns, double* x,
                     std::ptrdiff_t width);

    std::size_t scratch_doubles;
};

/// What this machine can run, the fastest first; the last is what the whole library is compiled for. Results differ in
/// the last bits between them: only the wider ones have a fused multiply-add.
std::span<const Kernels* const> kernels() noexcept;

}  // namespace polylap::dense

#include "solve/dense/kernels.hpp"

#include <array>

namespace polylap::dense {

extern const Kernels kernels_baseline;

#ifdef POLYLAP_WIDE_KERNELS

extern const Kernels kernels_avx2;
extern const Kernels kernels_avx512;

std::span<const Kernels* const> kernels() noexcept {
    static constexpr std::array all{&kernels_avx512, &kernels_avx2, &kernels_baseline};
    const std::span<const Kernels* const> span(all);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("fma")) return span;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return span.subspan(1);
    return span.subspan(2);
}

#else

std::span<const Kernels* const> kernels() noexcept {
    static constexpr std::array all{&kernels_baseline};
    return all;
}

#endif

}  // namespace polylap::dense

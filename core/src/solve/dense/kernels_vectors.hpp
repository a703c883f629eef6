// Vectors of POLYLAP_LANES doubles for kernels_body.hpp: the compilers' own, or loops where they have none.

#pragma once

#include <cstddef>

namespace polylap::dense {
namespace {

using Long = std::ptrdiff_t;

constexpr Long lanes = POLYLAP_LANES;

#if defined(__GNUC__)
template <Long N>
struct Vectors {
    typedef double Type __attribute__((vector_size(N * sizeof(double))));
    typedef double Unaligned __attribute__((vector_size(N * sizeof(double)), aligned(sizeof(double)), may_alias));
};
template <Long N>
using Pack = typename Vectors<N>::Type;
/// N doubles at p, which need not be aligned.
template <Long N>
inline typename Vectors<N>::Unaligned& packed(double* p) {
    return *reinterpret_cast<typename Vectors<N>::Unaligned*>(p);
}
template <Long N>
inline const typename Vectors<N>::Unaligned& packed(const double* p) {
    return *reinterpret_cast<const typename Vectors<N>::Unaligned*>(p);
}
#else
template <Long N>
struct Pack {
    double at[N] = {};
    double& operator[](Long i) { return at[i]; }
    double operator[](Long i) const { return at[i]; }
    Pack& operator+=(const Pack& x) {
        for (Long i = 0; i < N; ++i)
            at[i] += x.at[i];
        return *this;
    }
    Pack& operator-=(const Pack& x) {
        for (Long i = 0; i < N; ++i)
            at[i] -= x.at[i];
        return *this;
    }
    friend Pack operator*(Pack x, double s) {
        for (Long i = 0; i < N; ++i)
            x.at[i] *= s;
        return x;
    }
    friend Pack operator*(Pack x, const Pack& y) {
        for (Long i = 0; i < N; ++i)
            x.at[i] *= y.at[i];
        return x;
    }
    friend Pack operator-(Pack x, const Pack& y) { return x -= y; }
    friend Pack operator-(const Pack& x) { return Pack{} -= x; }
};
template <Long N>
inline Pack<N>& packed(double* p) {
    return *reinterpret_cast<Pack<N>*>(p);
}
template <Long N>
inline const Pack<N>& packed(const double* p) {
    return *reinterpret_cast<const Pack<N>*>(p);
}
#endif

using Lanes = Pack<lanes>;

inline Long min(Long a, Long b) {
    return a < b ? a : b;
}

}  // namespace
}  // namespace polylap::dense

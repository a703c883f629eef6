#include "solve/lower_triangle.hpp"

#include <algorithm>

namespace polylap {

SparseMatrix lower_triangle(const SparseMatrix& a) {
    const auto n = static_cast<Index>(a.cols());
    SparseMatrix lower(a.rows(), a.cols());
    const Index* const outer = a.outerIndexPtr();
    const Index* const inner = a.innerIndexPtr();
    const auto first_of = [&](Index k) {
        return static_cast<Index>(std::lower_bound(inner + outer[k], inner + outer[k + 1], k) - inner);
    };
    Index* const start = lower.outerIndexPtr();
    for (Index k = 0; k < n; ++k)
        start[k + 1] = start[k] + outer[k + 1] - first_of(k);
    lower.resizeNonZeros(start[n]);
    for (Index k = 0; k < n; ++k) {
        const Index first = outer[k + 1] - (start[k + 1] - start[k]);
        std::copy(inner + first, inner + outer[k + 1], lower.innerIndexPtr() + start[k]);
        std::copy(a.valuePtr() + first, a.valuePtr() + outer[k + 1], lower.valuePtr() + start[k]);
    }
    return lower;
}

}  // namespace polylap

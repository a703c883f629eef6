#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace polylap {

/// A factor that is kept, if it has any bytes.
struct KeptFactor {
    std::int64_t bytes = 0;
    std::int64_t last_use = 0;
};

/// The factor used longest ago, if `factors` and a new one in the place of `mine` would take more than `most_bytes`.
/// All are of one mesh: the new one is taken to be as large as the largest.
/// @return nothing where it fits, or where there is nothing to drop
inline std::optional<std::size_t> factor_to_drop(std::span<const KeptFactor> factors, std::size_t mine,
                                                 std::int64_t most_bytes) {
    std::int64_t bytes = 0, largest = 0;
    std::optional<std::size_t> oldest;
    for (std::size_t k = 0; k < factors.size(); ++k) {
        largest = std::max(largest, factors[k].bytes);
        if (k == mine || factors[k].bytes == 0) continue;
        bytes += factors[k].bytes;
        if (!oldest || factors[k].last_use < factors[*oldest].last_use) oldest = k;
    }
    return bytes + largest <= most_bytes ? std::nullopt : oldest;
}

}  // namespace polylap

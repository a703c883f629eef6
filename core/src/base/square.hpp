#pragma once

#include <cstddef>
#include <limits>
#include <stdexcept>

namespace polylap {

/// n², the entries of a dense n×n table. On 32-bit targets that of a face with 65536 corners would wrap to 0.
/// @throws std::length_error, which guard_memory turns into out_of_memory
inline std::size_t square(std::size_t n) {
    if (n != 0 && n > std::numeric_limits<std::size_t>::max() / n) throw std::length_error("square");
    return n * n;
}

}  // namespace polylap

#pragma once

#include <cstdint>

namespace polylap {

/// What a solver may rely on.
enum class Structure : std::uint8_t {
    positive_semidefinite,  ///< Symmetric and positive semi-definite.
    symmetric,              ///< Symmetric, perhaps indefinite.
    general,                ///< Neither.
};

}  // namespace polylap

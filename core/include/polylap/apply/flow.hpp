#pragma once

#include <array>
#include <span>
#include <string_view>

#include "polylap/base/result.hpp"

namespace polylap {

/// Which equation a smoothing step from x to x' solves, with stiffness S and mass M.
enum class Flow : std::uint8_t {
    implicit_step,  ///< (M + tS) x' = M x (Desbrun, Meyer, Schröder & Barr 1999). Stable for all t.
    /// The same with S of the loaded mesh and M of the moved one (Kazhdan, Solomon & Ben-Chen 2012, "Can mean-curvature
    /// flow be modified to be non-singular?"): no neck pinches off. The flow alone shrinks to a point; so each step is
    /// followed by scaling to the area of the loaded mesh, which changes its pace only.
    conformalised,
    explicit_step,  ///< x' = x - t M⁻¹ S x. Stable for t below Stability::limit.
};

/// The names, in the order of Flow.
inline constexpr std::array flow_names{"implicit", "conformalised", "explicit"};

inline const char* flow_name(Flow flow) noexcept {
    return flow_names[static_cast<std::size_t>(flow)];
}
/// @error bad_argument (the message lists the names)
Result<Flow> find_flow(std::string_view name);

}  // namespace polylap

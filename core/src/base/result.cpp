#include "polylap/base/result.hpp"

namespace polylap {

std::string_view error_code_name(ErrorCode code) noexcept {
    switch (code) {
        case ErrorCode::bad_argument:
            return "bad-argument";
        case ErrorCode::parse_error:
            return "parse-error";
        case ErrorCode::bad_mesh:
            return "bad-mesh";
        case ErrorCode::non_manifold_edge:
            return "non-manifold-edge";
        case ErrorCode::open_mesh:
            return "open-mesh";
        case ErrorCode::degenerate_face:
            return "degenerate-face";
        case ErrorCode::unknown_operator:
            return "unknown-operator";
        case ErrorCode::parameter_out_of_range:
            return "parameter-out-of-range";
        case ErrorCode::mass_not_positive:
            return "mass-not-positive";
        case ErrorCode::not_positive_definite:
            return "not-positive-definite";
        case ErrorCode::unconstrained_component:
            return "unconstrained-component";
        case ErrorCode::not_converged:
            return "not-converged";
        case ErrorCode::cancelled:
            return "cancelled";
        case ErrorCode::out_of_memory:
            return "out-of-memory";
        case ErrorCode::not_included:
            return "not-included";
    }
    return "unknown";
}

}  // namespace polylap

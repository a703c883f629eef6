#include "solve/fixed_vertices.hpp"

#include <string>

namespace polylap {

Result<std::vector<Index>> places_of(std::span<const Index> fixed, Index vertex_count) {
    std::vector<Index> place(static_cast<std::size_t>(vertex_count), -1);
    for (std::size_t k = 0; k < fixed.size(); ++k) {
        const Index v = fixed[k];
        if (v < 0 || v >= vertex_count) {
            return Error{ErrorCode::bad_argument,
                         "vertex " + std::to_string(v) + " cannot be fixed: there are " + std::to_string(vertex_count) +
                             " vertices (counted from 0)",
                         v};
        }
        if (place[static_cast<std::size_t>(v)] >= 0) {
            return Error{ErrorCode::bad_argument, "vertex " + std::to_string(v) + " is fixed twice", v};
        }
        place[static_cast<std::size_t>(v)] = static_cast<Index>(k);
    }
    return place;
}

Status check_values(std::span<const Index> fixed, const Eigen::Ref<const Matrix>& values) {
    if (values.rows() != static_cast<Eigen::Index>(fixed.size())) {
        return Error{ErrorCode::bad_argument, std::to_string(fixed.size()) + " vertices are fixed, but " +
                                                  std::to_string(values.rows()) + " values were given"};
    }
    for (Eigen::Index k = 0; k < values.rows(); ++k) {
        if (values.row(k).allFinite()) continue;
        const Index v = fixed[static_cast<std::size_t>(k)];
        return Error{ErrorCode::bad_argument, "the value at vertex " + std::to_string(v) + " is not a finite number",
                     v};
    }
    return Done{};
}

Error values_too_far_apart() {
    return {ErrorCode::bad_argument, "the fixed values are too far apart for double precision"};
}

Error unconstrained_part(Index vertex) {
    return {ErrorCode::unconstrained_component,
            "the connected part with vertex " + std::to_string(vertex) + " has no fixed vertex", vertex};
}

}  // namespace polylap

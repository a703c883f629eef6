#include "operators/vertex_weights.hpp"

#include <cmath>
#include <string>

namespace polylap {

Status check_weights_finite(std::span<const double> weights) {
    for (std::size_t v = 0; v < weights.size(); ++v) {
        if (std::isfinite(weights[v])) continue;
        return Error{ErrorCode::bad_argument, "the weight of vertex " + std::to_string(v) + " is not finite",
                     static_cast<std::int64_t>(v)};
    }
    return Done{};
}

Status check_vertex_weights(const PolygonMesh& mesh, std::span<const double> weights) {
    if (!weights.empty() && weights.size() != static_cast<std::size_t>(mesh.vertex_count())) {
        return Error{ErrorCode::bad_argument, "there are " + std::to_string(mesh.vertex_count()) + " vertices, but " +
                                                  std::to_string(weights.size()) + " vertex weights were given"};
    }
    return check_weights_finite(weights);
}

}  // namespace polylap

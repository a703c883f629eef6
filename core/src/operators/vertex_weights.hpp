#pragma once

#include <span>

#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// @error bad_argument (element = vertex)
Status check_weights_finite(std::span<const double> weights);

/// Empty, or one finite number per vertex.
/// @error bad_argument (element = vertex for one that is not finite)
Status check_vertex_weights(const PolygonMesh& mesh, std::span<const double> weights);

}  // namespace polylap

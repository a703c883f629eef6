#pragma once

#include <cstdint>

#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// Moves each vertex along its normal (normalised sum of the vector areas at it) by `amplitude` · mean edge length · a
/// value drawn uniformly from [-1, 1). The same seed gives the same mesh on every platform. Unreferenced vertices stay.
/// @error bad_argument (amplitude not finite), bad_mesh (a position overflows; element = vertex), out_of_memory
Result<PolygonMesh> add_normal_noise(const PolygonMesh& mesh, double amplitude, std::uint32_t seed);

}  // namespace polylap

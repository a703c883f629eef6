#pragma once

#include "polylap/mesh/topology.hpp"

namespace polylap {

/// A volume counts as none below this multiple of area^(3/2): what rounding leaves of a surface folded flat.
inline constexpr double flat_volume_tolerance = 1e-12;

/// The surface scaled about the centroid of its area until it encloses the volume. The scale is positive: a surface
/// that has turned inside out stays so, and is refused.
/// @param volume length³, with the sign of the orientation
/// @error open_mesh, non_manifold_edge (see enclosed_volume), not_converged (the surface or the volume is flat, or of
///        the other sign), out_of_memory
Result<PolygonMesh> scaled_to_volume(const PolygonMesh& mesh, const Topology& topology, double volume);

/// The surface scaled about the centroid of its area until it has the area.
/// @param area Σ |a_f|, length², positive   @error degenerate_face (the surface has no area), out_of_memory
Result<PolygonMesh> scaled_to_area(const PolygonMesh& mesh, double area);

/// Σ |a_f|, length²
double surface_area(const PolygonMesh& mesh);

}  // namespace polylap

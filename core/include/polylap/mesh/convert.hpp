#pragma once

#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// The dual mesh: a vertex at the mean of each face's corners, a face around each inner vertex. Boundary vertices get
/// none.
/// @error non_manifold_edge (element = vertex whose faces form no single ring; the message names it), bad_mesh (nothing
/// is left: no inner vertex), out_of_memory
Result<PolygonMesh> dual_mesh(const PolygonMesh& mesh);

enum class SubdivisionRule : std::uint8_t { linear, catmull_clark };

/// Splits each n-gon into n quads: the topology of Catmull & Clark 1978. `linear` leaves the vertices and puts new ones
/// at the means of edges and faces; `catmull_clark` moves them all by that paper's rules, boundaries as cubic splines.
/// Vertices: the V old ones, the E edges' in topology order, the F faces'.
/// @error bad_mesh (too many vertices), non_manifold_edge (catmull_clark only), out_of_memory
Result<PolygonMesh> subdivide_into_quads(const PolygonMesh& mesh, SubdivisionRule rule = SubdivisionRule::linear);

/// Joins neighbouring triangles into quads, best-shaped pairs first; unmatched triangles and other faces stay as they
/// are.
/// @error out_of_memory
Result<PolygonMesh> pair_triangles(const PolygonMesh& mesh);

}  // namespace polylap

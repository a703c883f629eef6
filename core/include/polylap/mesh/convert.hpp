#pragma once

#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// The dual mesh: a vertex at the mean of each face's corners, a face around each inner vertex. Boundary vertices get
/// none, nor do inner ones with two faces, which only bend an edge; faces without any other corner are left out.
/// @error non_manifold_edge (element = vertex whose faces form no single ring; the message names it), bad_mesh (nothing
/// is left: no inner vertex), out_of_memory
Result<PolygonMesh> dual_mesh(const PolygonMesh& mesh);

enum class SubdivisionRule : std::uint8_t { linear, catmull_clark };

/// Splits each n-gon into n quads: the topology of Catmull & Clark 1978. `linear` leaves the vertices and puts new ones
/// at the means of edges and faces; `catmull_clark` moves all but the faces' by that paper's rules, boundaries as cubic
/// splines (a vertex with more than two boundary edges stays).
/// Vertices: the V old ones, the E edges' in topology order, the F faces'.
/// @error bad_mesh (too many vertices), non_manifold_edge (catmull_clark only), out_of_memory
Result<PolygonMesh> subdivide_into_quads(const PolygonMesh& mesh, SubdivisionRule rule = SubdivisionRule::linear);

/// Joins neighbouring triangles into convex quads; triangles left over and other faces stay as they are. Pairs are
/// taken greedily by quality, the least 2 n·(e × e') / (|e|² + |e'|²) over the four corners (e, e' the edges there, n
/// the unit vector area; 1 for a planar square, > 0 for a convex quad); then triangles left over trade partners with
/// their neighbours along short paths. Only across edges with two faces of like orientation.
/// @error out_of_memory
Result<PolygonMesh> pair_triangles(const PolygonMesh& mesh);

}  // namespace polylap

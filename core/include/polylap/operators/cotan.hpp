#pragma once

#include "polylap/face/triangulate.hpp"
#include "polylap/operators/mass.hpp"

namespace polylap {

extern const OperatorInfo cotan_info;

struct CotanOptions {
    TriangulationRule rule = TriangulationRule::delaunay;  ///< Finds the diagonals of a face on its maximal projection.
    MassRule mass = MassRule::lumped;
};

/// The cotan operator of Pinkall & Polthier 1993 [Herholz 2012, eq. 3.16] on the triangles that the faces are cut into:
/// w_ij = ½(cot γ_ij + cot γ_ji), angles of the triangles in space.
/// @param mesh faces may be non-planar or concave, not of zero vector area, not self-crossing in projection
/// @return S V×V symmetric PSD, unitless; M V×V symmetric, see MassRule
/// @error degenerate_face (element = face), out_of_memory, cancelled.   Cost: see triangulate_polygon
Result<OperatorMatrices> cotan_matrices(const PolygonMesh& mesh, CotanOptions options = {}, Monitor monitor = {});

}  // namespace polylap

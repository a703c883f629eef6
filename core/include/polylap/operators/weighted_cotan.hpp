#pragma once

#include "polylap/face/triangulate.hpp"
#include "polylap/operators/mass.hpp"

namespace polylap {

extern const OperatorInfo weighted_cotan_info;

struct WeightedCotanOptions {
    TriangulationRule rule = TriangulationRule::delaunay;  ///< Finds the diagonals of a face on its maximal projection.
    MassRule mass = MassRule::lumped;                      ///< Does not depend on the weights.
};

/// The cotan operator with weighted vertices (Glickenstein 2007) on the triangles that the faces are cut into:
/// d_ij = (|e|² + ω_i - ω_j) / (2|e|) and, per triangle, w_ij += (d_ik - d_ij cos γ_i) / (|e_ij| sin γ_i) [Herholz
/// 2012, eq. 3.24, 3.25]. ω = 0, or any constant, is the cotan operator.
/// @param mesh    faces may be non-planar or concave, not of zero vector area, not self-crossing in projection
/// @param weights ω, V finite values, length²; empty: all 0
/// @return S V×V symmetric, unitless, not PSD for all ω; M V×V symmetric, see MassRule
/// @error bad_argument (another number of weights, or one not finite: element = vertex), degenerate_face (element =
/// face), out_of_memory, cancelled.   Cost: see triangulate_polygon
Result<OperatorMatrices> weighted_cotan_matrices(const PolygonMesh& mesh, std::span<const double> weights,
                                                 WeightedCotanOptions options = {}, Monitor monitor = {});

}  // namespace polylap

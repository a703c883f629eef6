#pragma once

#include "polylap/operators/operator.hpp"

// Assembly as it is commonly written: every face has matrices of its own on the heap, its entries become triplets, and
// those are sorted. Written from the papers' formulas, to measure against.
namespace polylap::bench {

/// Alexa & Wardetzky 2011 with λ = 1 and the lumped mass; the kernel of the projected edges by a singular value
/// decomposition per face.
OperatorMatrices naive_edge_gradient(const PolygonMesh& mesh);

/// Herholz 2012, section 4.2.4, with the lumped mass: cotangents of the Delaunay triangles of each projected face.
/// @param mesh all projected faces convex
OperatorMatrices naive_projected_cotan(const PolygonMesh& mesh);

}  // namespace polylap::bench

#pragma once

#include "polylap/operators/dual_vertices.hpp"
#include "polylap/operators/operator.hpp"

namespace polylap {

extern const OperatorInfo orthogonal_dual_info;

/// Stiffness with the weights of the orthogonal dual: symmetric, linearly precise on planar meshes.
/// @error see orthogonal_dual
Result<SparseMatrix> orthogonal_dual_stiffness(const PolygonMesh& mesh, DualOptions options = {}, Monitor monitor = {});

}  // namespace polylap

#pragma once

#include "polylap/operators/operator.hpp"

namespace polylap {

extern const OperatorInfo normalized_graph_info;

/// The normalised graph Laplacian I - D^-½ A D^-½ of the mesh edges (Chung 1997; Herholz 2012, section 3.2). Its kernel
/// is D^½ 1, not the constants.
/// @param mesh any; faces may be degenerate
/// @return S V×V symmetric PSD, unitless
/// @error out_of_memory, cancelled.   Cost O(Σ n_f)
Result<SparseMatrix> normalized_graph_stiffness(const PolygonMesh& mesh, Monitor monitor = {});

}  // namespace polylap

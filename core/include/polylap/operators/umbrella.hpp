#pragma once

#include "polylap/operators/operator.hpp"

namespace polylap {

extern const OperatorInfo umbrella_info;

/// The graph Laplacian of the mesh edges, D - A [Herholz 2012, section 3.2]: weight 1 per edge, whatever its length and
/// however many faces it has.
/// @param mesh any; faces may be degenerate
/// @return S V×V symmetric PSD, unitless
/// @error out_of_memory, cancelled.   Cost O(Σ n_f)
Result<SparseMatrix> umbrella_stiffness(const PolygonMesh& mesh, Monitor monitor = {});

}  // namespace polylap

#pragma once

#include "polylap/operators/operator.hpp"

namespace polylap {

extern const OperatorInfo tutte_info;

/// The random-walk Laplacian D⁻¹(D - A) = I - D⁻¹A of the mesh edges [Herholz 2012, section 3.2]: (S u)ᵢ is what uᵢ
/// exceeds the mean of its neighbours by; the spectrum lies in [0, 2].
/// @param mesh any; faces may be degenerate
/// @return S V×V, not symmetric, unitless
/// @error out_of_memory, cancelled.   Cost O(Σ n_f)
Result<SparseMatrix> tutte_stiffness(const PolygonMesh& mesh, Monitor monitor = {});

}  // namespace polylap

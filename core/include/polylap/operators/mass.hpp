#pragma once

#include "polylap/operators/operator.hpp"

namespace polylap {

/// The lumped mass of a mesh: diagonal, M_ii = Σ |a_f| / n_f over the faces at i (Alexa & Wardetzky 2011), length².
/// Zero at unreferenced vertices.
/// @error out_of_memory
Result<SparseMatrix> lumped_mass(const PolygonMesh& mesh);

/// Joins a stiffness that was built, or failed to be, with the lumped mass.
Result<OperatorMatrices> with_lumped_mass(const PolygonMesh& mesh, Result<SparseMatrix> stiffness);

}  // namespace polylap

#pragma once

#include "polylap/operators/operator.hpp"

namespace polylap {

/// The mass matrix of a mesh: diagonal, M_ii = Σ |a_f| / n_f over the faces at i (Alexa & Wardetzky 2011), length².
/// Zero at unreferenced vertices.
/// @error out_of_memory
Result<SparseMatrix> mass_matrix(const PolygonMesh& mesh, Mass mass = Mass::lumped);

/// Joins a stiffness that was built, or failed to be, with the mass.
Result<OperatorMatrices> with_mass(const PolygonMesh& mesh, Result<SparseMatrix> stiffness, Mass mass);

}  // namespace polylap

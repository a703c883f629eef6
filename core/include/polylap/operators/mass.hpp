#pragma once

#include "polylap/operators/operator.hpp"

namespace polylap {

/// The mass matrix of a mesh: diagonal, M_ii = Σ |a_f| / n_f over the faces at i (Alexa & Wardetzky 2011), length². Zero at unreferenced vertices.
Result<SparseMatrix> mass_matrix(const PolygonMesh& mesh, Mass mass = Mass::lumped);

}  // namespace polylap

#pragma once

#include "mesh/face_pairs.hpp"
#include "polylap/base/types.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// Makes `matrix` V×V with an entry for each pair, all 0. Uses its memory again where that suffices.
void set_pattern(const FacePairs& pairs, SparseMatrix& matrix);

/// Makes `matrix` V×V with an entry for each vertex on the diagonal, all 0.
void set_diagonal(Index vertex_count, SparseMatrix& matrix);

/// lumped_mass into a matrix that may be there.
void assemble_lumped_mass(const PolygonMesh& mesh, SparseMatrix& matrix);

}  // namespace polylap

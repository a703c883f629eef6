#pragma once

#include "polylap/operators/operator.hpp"

namespace polylap {

/// D - A of the graph of mesh edges: each edge counts once, however many faces it has. The row of a vertex in no face
/// is empty; all others have a diagonal entry, the number of neighbours.
/// @error out_of_memory, cancelled
Status graph_laplacian(const PolygonMesh& mesh, SparseMatrix& out, Monitor monitor);

/// The same, each entry (i, j) divided by `divisor` of the numbers of neighbours of i and of j.
using EdgeDivisor = double (*)(double d_i, double d_j);
Status graph_laplacian_over(EdgeDivisor divisor, const PolygonMesh& mesh, SparseMatrix& out, Monitor monitor);

}  // namespace polylap

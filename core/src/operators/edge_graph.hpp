#pragma once

#include "polylap/base/monitor.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// D - A of the graph of mesh edges: each edge counts once, however many faces it has. The row of a vertex in no face
/// is empty; all others have a diagonal entry, the number of neighbours.
/// @error out_of_memory, cancelled
Result<SparseMatrix> graph_laplacian(const PolygonMesh& mesh, Monitor monitor);

/// The same, each entry (i, j) divided by `divisor` of the numbers of neighbours of i and of j.
Result<SparseMatrix> graph_laplacian_over(double (*divisor)(double d_i, double d_j), const PolygonMesh& mesh,
                                          Monitor monitor);

}  // namespace polylap

#include "operators/edge_graph.hpp"

#include "operators/assemble_faces.hpp"

namespace polylap {

Result<SparseMatrix> graph_laplacian(const PolygonMesh& mesh, Monitor monitor) {
    auto graph = assemble_faces(mesh, monitor, [](std::span<const Index> face, Corners, LocalMatrix& s) -> Status {
        const auto n = static_cast<Index>(face.size());
        for (Index i = 0; i < n; ++i) {
            const Index next = i + 1 == n ? 0 : i + 1;
            s(i, next) = s(next, i) = 1;
        }
        return Done{};
    });
    if (!graph) return graph;
    // The sum counts an edge once per face; the graph has it once.
    for (Index j = 0; j < graph->cols(); ++j) {
        double degree = -1;  // of the diagonal's own entry
        for (SparseMatrix::InnerIterator it(*graph, j); it; ++it) {
            ++degree;
            it.valueRef() = -1;
        }
        if (degree > 0) graph->coeffRef(j, j) = degree;
    }
    return graph;
}

Result<SparseMatrix> graph_laplacian_over(double (*divisor)(double d_i, double d_j), const PolygonMesh& mesh,
                                          Monitor monitor) {
    return guard_memory([&]() -> Result<SparseMatrix> {
        auto graph = graph_laplacian(mesh, monitor);
        if (!graph) return graph;
        const Vector degree = graph->diagonal();
        for (Index j = 0; j < graph->cols(); ++j) {
            for (SparseMatrix::InnerIterator it(*graph, j); it; ++it) {
                it.valueRef() /= divisor(degree[it.row()], degree[j]);
            }
        }
        return graph;
    });
}

}  // namespace polylap

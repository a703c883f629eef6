#include "operators/edge_graph.hpp"

#include <vector>

#include "mesh/face_pairs.hpp"
#include "operators/sparse_pattern.hpp"

namespace polylap {

Status graph_laplacian(const PolygonMesh& mesh, SparseMatrix& out, Monitor monitor) {
    return guard_memory([&]() -> Status {
        const Error cancelled{ErrorCode::cancelled, "cancelled"};
        if (!monitor.proceed(0)) return cancelled;
        // The sides of the faces, as faces of two corners.
        const auto& connectivity = *mesh.connectivity();
        std::vector<Index> offsets{0};
        std::vector<Index> corners;
        offsets.reserve(connectivity.corners.size() + 1);
        corners.reserve(2 * connectivity.corners.size());
        for (Index f = 0; f < connectivity.face_count(); ++f) {
            Index from = connectivity.face(f).back();
            for (const Index to : connectivity.face(f)) {
                corners.push_back(from);
                corners.push_back(to);
                offsets.push_back(static_cast<Index>(corners.size()));
                from = to;
            }
        }
        Stretch pairing{monitor, 0.2, 0.8};
        const auto pairs = pair_corners(mesh.vertex_count(), offsets, corners, pairing.monitor());
        if (!pairs) return pairs.error();
        if (!monitor.proceed(0.8)) return cancelled;
        set_pattern(**pairs, out);
        for (Index j = 0; j < out.cols(); ++j) {
            double degree = -1;  // but for the diagonal's own entry
            for (SparseMatrix::InnerIterator it(out, j); it; ++it) {
                ++degree;
            }
            for (SparseMatrix::InnerIterator it(out, j); it; ++it) {
                it.valueRef() = it.index() == j ? degree : -1;
            }
        }
        return Done{};
    });
}

Status graph_laplacian_over(EdgeDivisor divisor, const PolygonMesh& mesh, SparseMatrix& out, Monitor monitor) {
    return guard_memory([&]() -> Status {
        if (Status status = graph_laplacian(mesh, out, monitor); !status) return status;
        const Vector degree = out.diagonal();
        for (Index j = 0; j < out.cols(); ++j) {
            for (SparseMatrix::InnerIterator it(out, j); it; ++it) {
                it.valueRef() /= divisor(degree[it.row()], degree[j]);
            }
        }
        return Done{};
    });
}

}  // namespace polylap

#include "polylap/apply/diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "polylap/face/vector_area.hpp"

namespace polylap {

WeightSummary summarise_weights(const SparseMatrix& stiffness) {
    WeightSummary summary;
    const Vector diagonal = stiffness.diagonal();
    const double zero = diagonal.size() == 0 ? 0 : weight_tolerance * diagonal.cwiseAbs().maxCoeff();
    bool first = true;
    for (Index j = 0; j < stiffness.cols(); ++j) {
        for (SparseMatrix::InnerIterator it(stiffness, j); it; ++it) {
            const auto i = static_cast<Index>(it.row());
            const double w = -it.value();
            if (i == j || std::abs(w) <= zero) continue;
            summary.smallest = first ? w : std::min(summary.smallest, w);
            summary.largest = first ? w : std::max(summary.largest, w);
            first = false;
            ++summary.nonzero_ordered;
            if (w >= 0) continue;
            ++summary.negative_ordered;
            summary.negative.push_back({std::min(i, j), std::max(i, j), w});
        }
    }
    auto& negative = summary.negative;
    std::sort(negative.begin(), negative.end(), [](const Weight& a, const Weight& b) {
        return std::tie(a.i, a.j, a.value) < std::tie(b.i, b.j, b.value);
    });
    negative.erase(std::unique(negative.begin(), negative.end(),
                               [](const Weight& a, const Weight& b) { return a.i == b.i && a.j == b.j; }),
                   negative.end());
    return summary;
}

double non_planarity(std::span<const Vector3> corners) {
    const Vector3 a = vector_area(corners);
    if (corners.size() == 3 || has_zero_area(corners, a)) return 0;
    const double area = a.stableNorm();
    Vector3 centre = Vector3::Zero();
    for (const Vector3& x : corners) {
        centre += x - corners[0];
    }
    centre /= static_cast<double>(corners.size());
    double squares = 0;
    for (const Vector3& x : corners) {
        const double height = (a / area).dot(x - corners[0] - centre);
        squares += height * height;
    }
    return std::sqrt(squares / static_cast<double>(corners.size()) / area);
}

ShapeMeasures measure_shape(const PolygonMesh& mesh, const Topology& topology) {
    ShapeMeasures measures;
    std::vector<Vector3> corners;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        gather_corners(mesh, f, corners);
        measures.area += vector_area(corners).stableNorm();
        measures.mean_non_planarity += non_planarity(corners);
    }
    measures.mean_non_planarity /= mesh.face_count();
    for (const Edge& e : topology.edges) {
        measures.mean_squared_edge += (mesh.position(e.v1) - mesh.position(e.v0)).squaredNorm();
    }
    measures.mean_squared_edge /= static_cast<double>(topology.edges.size());
    return measures;
}

Result<double> enclosed_volume(const PolygonMesh& mesh, const Topology& topology) {
    return guard_memory([&]() -> Result<double> {
        for (std::size_t k = 0; k < topology.edges.size(); ++k) {
            const Edge& e = topology.edges[k];
            if (!e.boundary() && e.manifold() && e.oriented()) continue;
            const std::string edge = "edge " + std::to_string(e.v0) + "–" + std::to_string(e.v1);
            const auto element = static_cast<std::int64_t>(k);
            if (e.boundary()) return Error{ErrorCode::open_mesh, "the surface is open at " + edge, element};
            return Error{ErrorCode::non_manifold_edge,
                         "the faces at " + edge + " do not bound a volume (" + std::to_string(e.forward) +
                             " run along it, " + std::to_string(e.backward) + " against it)",
                         element};
        }
        const Vector3 origin = mesh.position(mesh.face(0)[0]);
        double volume = 0;
        std::vector<Vector3> corners;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            gather_corners(mesh, f, corners);
            Vector3 centre = Vector3::Zero();
            for (const Vector3& x : corners) {
                centre += x - origin;
            }
            volume += vector_area(corners).dot(centre) / (3 * static_cast<double>(corners.size()));
        }
        return volume;
    });
}

}  // namespace polylap

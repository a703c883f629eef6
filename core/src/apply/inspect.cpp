#include "polylap/apply/inspect.hpp"

#include <numeric>
#include <string>

#include "operators/vertex_weights.hpp"
#include "polylap/apply/diagnostics.hpp"
#include "polylap/face/vector_area.hpp"

namespace polylap {
namespace {

/// A face by itself, its corners numbered in order.
Result<PolygonMesh> only(const std::vector<Vector3>& corners) {
    const auto n = static_cast<Index>(corners.size());
    Points points(n, 3);
    for (Index k = 0; k < n; ++k)
        points.row(k) = corners[static_cast<std::size_t>(k)].transpose();
    std::vector<Index> order(corners.size());
    std::iota(order.begin(), order.end(), 0);
    return PolygonMesh::create(std::move(points), {0, n}, std::move(order));
}

/// What a face adds to a sum over faces is that sum of the face alone.
Status fill_stiffness(const OperatorSpec& spec, const OperatorInfo& info, const std::vector<Vector3>& corners,
                      FaceReport& report) {
    if (!info.sum_over_faces) {
        report.no_stiffness = "its matrix is no sum over faces";
        return Done{};
    }
    if (report.corners.size() > std::size_t{most_inspected_corners}) {
        report.no_stiffness = "it has more than " + std::to_string(most_inspected_corners) + " corners";
        return Done{};
    }
    OperatorSpec own = spec;
    if (!spec.vertex_weights.empty()) {
        own.vertex_weights.clear();
        for (const Index v : report.corners)
            own.vertex_weights.push_back(spec.vertex_weights[static_cast<std::size_t>(v)]);
    }
    const auto face = only(corners);
    if (!face) return face.error();
    const auto built = build_operator(*face, own);
    if (built) {
        report.stiffness = Matrix(built->stiffness);
    } else if (built.error().code == ErrorCode::degenerate_face) {
        // It says "face 0: …", of this one.
        const std::string& why = built.error().message;
        report.no_stiffness = why.substr(why.find(": ") == std::string::npos ? 0 : why.find(": ") + 2);
    } else {
        return built.error();
    }
    return Done{};
}

}  // namespace

MatrixRow row_of(const OperatorMatrices& matrices, Index vertex) {
    MatrixRow row;
    bool diagonal = false;
    const auto add = [&](Index j, double value) {
        row.columns.push_back(j);
        row.values.push_back(value);
        diagonal = diagonal || j == vertex;
    };
    for (SparseMatrix::InnerIterator it(matrices.stiffness, vertex); it; ++it) {
        const auto j = static_cast<Index>(it.row());
        if (!diagonal && j > vertex) add(vertex, 0);  // a vertex in no face
        const double value = matrices.stiffness.coeff(vertex, j);
        if (value != 0 || j == vertex) add(j, value);
    }
    if (!diagonal) add(vertex, 0);
    row.mass = matrices.mass.coeff(vertex, vertex);
    return row;
}

Result<FaceReport> inspect_face(const PolygonMesh& mesh, const OperatorSpec& spec, Index face) {
    return guard_memory([&]() -> Result<FaceReport> {
        if (face < 0 || face >= mesh.face_count()) {
            return Error{ErrorCode::bad_argument, "there is no face " + std::to_string(face) + ": the mesh has " +
                                                      std::to_string(mesh.face_count()) + " (counted from 0)"};
        }
        const auto complete = complete_spec(spec);
        if (!complete) return complete.error();
        if (Status status = check_vertex_weights(mesh, complete->vertex_weights); !status) return status.error();
        const OperatorInfo& info = **find_operator(complete->id);

        FaceReport report;
        const auto vertices = mesh.face(face);
        report.corners.assign(vertices.begin(), vertices.end());
        std::vector<Vector3> corners;
        gather_corners(mesh, face, corners);
        report.vector_area = vector_area(corners);
        report.non_planarity = non_planarity(corners);
        Projection projection;
        if (project_maximally(corners, projection)) {
            report.normal = projection.normal;
            report.projected = std::move(projection.points);
            // Where it cannot be cut, the matrix says why.
            if (info.rule && !triangulate_polygon(report.projected, info.rule(*complete), report.triangles))
                report.triangles.clear();
        }
        if (Status status = fill_stiffness(*complete, info, corners, report); !status) return status.error();
        return report;
    });
}

}  // namespace polylap

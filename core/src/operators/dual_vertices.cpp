#include "polylap/operators/dual_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/Geometry>

#include "polylap/face/vector_area.hpp"
#include "solve/kernel_projection.hpp"

namespace polylap {
namespace {

/// What the residual may be, relative to the largest squared edge.
constexpr double residual_tolerance = 1e-8;

Error cancelled() {
    return {ErrorCode::cancelled, "cancelled"};
}

std::string edge_text(const Edge& e) {
    return "edge " + std::to_string(e.v0) + "–" + std::to_string(e.v1);
}

/// What the dual needs of each face, relative to an origin near the mesh.
struct Faces {
    Vector3 origin;
    Points barycentres;         ///< F×3: means of the corners.
    Points normals;             ///< F×3: unit vector areas.
    std::vector<double> sizes;  ///< √|a|
};

Result<Faces> measure_faces(const PolygonMesh& mesh) {
    const Index count = mesh.face_count();
    Faces faces;
    faces.origin = mesh.position(mesh.face(0)[0]);
    faces.barycentres.resize(count, 3);
    faces.normals.resize(count, 3);
    faces.sizes.resize(static_cast<std::size_t>(count));
    std::vector<Vector3> corners;
    for (Index f = 0; f < count; ++f) {
        gather_corners(mesh, f, corners);
        const Vector3 area = vector_area(corners);
        if (has_zero_area(corners, area)) {
            return Error{ErrorCode::degenerate_face, "face " + std::to_string(f) + ": its vector area is zero", f};
        }
        Vector3 sum = Vector3::Zero();
        for (const Vector3& x : corners) {
            sum += x - faces.origin;
        }
        faces.barycentres.row(f) = sum / static_cast<double>(corners.size());
        faces.normals.row(f) = area.stableNormalized();
        faces.sizes[static_cast<std::size_t>(f)] = std::sqrt(area.stableNorm());
    }
    return faces;
}

/// The edges with the faces on both sides.
Result<std::vector<DualEdge>> pair_faces(const PolygonMesh& mesh, const Topology& topology) {
    std::vector<DualEdge> edges;
    edges.reserve(topology.edges.size());
    // The edges with lower vertex v are [first[v], first[v + 1]).
    std::vector<Index> first(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0);
    for (const Edge& e : topology.edges) {
        const auto k = static_cast<std::int64_t>(edges.size());
        if (!e.manifold()) {
            return Error{ErrorCode::non_manifold_edge, edge_text(e) + " has " + std::to_string(e.faces()) + " faces",
                         k};
        }
        if (!e.oriented()) {
            return Error{ErrorCode::non_manifold_edge,
                         "the two faces at " + edge_text(e) + " have opposite orientation", k};
        }
        if (mesh.positions().row(e.v0) == mesh.positions().row(e.v1)) {
            return Error{ErrorCode::degenerate_face,
                         "face " + std::to_string(e.first_face) + ": its " + edge_text(e) + " has no length",
                         e.first_face};
        }
        edges.push_back({.v0 = e.v0, .v1 = e.v1});
        ++first[static_cast<std::size_t>(e.v0) + 1];
    }
    for (std::size_t v = 1; v < first.size(); ++v) {
        first[v] += first[v - 1];
    }
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Index from = face[k];
            const Index to = face[k + 1 < face.size() ? k + 1 : 0];
            auto at = static_cast<std::size_t>(first[static_cast<std::size_t>(std::min(from, to))]);
            while (edges[at].v1 != std::max(from, to)) {
                ++at;
            }
            (from < to ? edges[at].face0 : edges[at].face1) = f;
        }
    }
    return edges;
}

bool inner(const DualEdge& e) {
    return e.face0 >= 0 && e.face1 >= 0;
}

Vector3 edge_vector(const PolygonMesh& mesh, const DualEdge& e) {
    return mesh.position(e.v1) - mesh.position(e.v0);
}

/// Moves the barycentres onto the constraints.
Result<KernelProjection> solve(const PolygonMesh& mesh, const Faces& faces, const std::vector<DualEdge>& edges,
                               Index constraints, double mu, Monitor monitor) {
    SparseMatrix transposed(3 * static_cast<Eigen::Index>(mesh.face_count()), constraints);
    // Eigen reads past the end of a matrix without columns that it has reserved room in.
    if (constraints > 0) transposed.reserve(Eigen::VectorXi::Constant(constraints, 6));
    Index row = 0;
    for (const DualEdge& e : edges) {
        if (!inner(e)) continue;
        const Vector3 unit = edge_vector(mesh, e).stableNormalized();
        for (const Index face : {std::min(e.face0, e.face1), std::max(e.face0, e.face1)}) {
            for (Index k = 0; k < 3; ++k) {
                transposed.insert(3 * face + k, row) = face == e.face0 ? unit[k] : -unit[k];
            }
        }
        ++row;
    }
    transposed.makeCompressed();
    const Eigen::Map<const Vector> b(faces.barycentres.data(), faces.barycentres.size());
    return project_onto_kernel(transposed, b, mu > 0 ? mu : std::numeric_limits<double>::infinity(), monitor);
}

/// Where and how long the dual edges are, and how far from orthogonal.
void measure_edges(const PolygonMesh& mesh, const Faces& faces, const Points& v, OrthogonalDual& dual) {
    double largest_edge = 0;
    for (DualEdge& edge : dual.edges) {
        const Vector3 e = edge_vector(mesh, edge);
        const double length = e.stableNorm();
        const Vector3 unit = e / length;
        const Vector3 start = mesh.position(edge.v0) - faces.origin;
        double along = 0;
        // The signed distance of a face's dual vertex from the edge, which the face runs along in the given direction.
        const auto distance = [&](Index face, double direction) {
            const Vector3 from_start = v.row(face).transpose() - start;
            const double s = from_start.dot(unit);
            along += s;
            const Vector3 across = from_start - s * unit;
            const Vector3 normal = faces.normals.row(face);
            return std::copysign(across.stableNorm(), direction * across.dot(normal.cross(unit)));
        };
        if (edge.face0 >= 0) edge.length0 = distance(edge.face0, 1);
        if (edge.face1 >= 0) edge.length1 = distance(edge.face1, -1);
        if (inner(edge)) along /= 2;
        edge.point = mesh.position(edge.v0) + along * unit;
        edge.weight = (edge.length0 + edge.length1) / length;
        largest_edge = std::max(largest_edge, length);
    }
    for (std::size_t k = 0; k < dual.edges.size(); ++k) {
        const DualEdge& edge = dual.edges[k];
        if (!inner(edge)) continue;
        const Vector3 difference = v.row(edge.face0) - v.row(edge.face1);
        const double residual = std::abs(difference.dot(edge_vector(mesh, edge) / largest_edge)) / largest_edge;
        if (dual.worst_edge < 0 || residual > dual.residual) {
            dual.residual = residual;
            dual.worst_edge = static_cast<Index>(k);
        }
    }
}

}  // namespace

Result<OrthogonalDual> orthogonal_dual(const PolygonMesh& mesh, DualOptions options, Monitor monitor) {
    if (!(options.mu >= 0) || !std::isfinite(options.mu)) {
        return Error{ErrorCode::parameter_out_of_range, "mu must be a finite number ≥ 0"};
    }
    return guard_memory([&]() -> Result<OrthogonalDual> {
        if (!monitor.proceed(0)) return cancelled();
        const auto faces = measure_faces(mesh);
        if (!faces) return faces.error();
        auto edges = pair_faces(mesh, build_topology(*mesh.connectivity()));
        if (!edges) return edges.error();

        OrthogonalDual dual;
        dual.edges = *std::move(edges);
        dual.constraints = static_cast<Index>(std::count_if(dual.edges.begin(), dual.edges.end(), inner));
        Stretch solving{monitor, 0.1, 0.95};
        const auto moved = solve(mesh, *faces, dual.edges, dual.constraints, options.mu, solving.monitor());
        if (!moved) return moved.error();
        if (!monitor.proceed(0.95)) return cancelled();
        dual.rank = moved->rank;
        dual.null_space = 3 * mesh.face_count() - dual.rank;

        const Eigen::Map<const Points> shift(moved->shift.data(), mesh.face_count(), 3);
        const Points v = faces->barycentres + shift;
        dual.vertices = v.rowwise() + faces->origin.transpose();
        for (Index f = 0; f < mesh.face_count(); ++f) {
            const double relative = shift.row(f).stableNorm() / faces->sizes[static_cast<std::size_t>(f)];
            if (dual.worst_face < 0 || relative > dual.largest_shift) {
                dual.largest_shift = relative;
                dual.worst_face = f;
            }
        }
        dual.usable = dual.largest_shift <= usable_shift;
        measure_edges(mesh, *faces, v, dual);
        if (options.mu == 0 && !(dual.residual <= residual_tolerance)) {
            const DualEdge& worst = dual.edges[static_cast<std::size_t>(dual.worst_edge)];
            return Error{ErrorCode::not_converged,
                         "the dual edge across edge " + std::to_string(worst.v0) + "–" + std::to_string(worst.v1) +
                             " could not be made orthogonal",
                         dual.worst_edge};
        }
        return dual;
    });
}

}  // namespace polylap

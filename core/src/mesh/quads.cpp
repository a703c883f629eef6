#include <algorithm>
#include <limits>
#include <string>

#include "polylap/mesh/convert.hpp"
#include "polylap/mesh/topology.hpp"

// E. Catmull, J. Clark: Recursively generated B-spline surfaces on arbitrary topological meshes. Computer-Aided Design
// 10(6), 1978.

namespace polylap {
namespace {

std::string edge_text(const Edge& e) {
    return std::to_string(e.v0) + "–" + std::to_string(e.v1);
}

/// Number of the edge between two neighbours; edges are sorted.
std::size_t find_edge(const std::vector<Edge>& edges, Index a, Index b) {
    const auto [low, high] = std::minmax(a, b);
    const auto at = std::lower_bound(edges.begin(), edges.end(), std::pair(low, high),
                                     [](const Edge& e, const auto& key) { return std::pair(e.v0, e.v1) < key; });
    return static_cast<std::size_t>(at - edges.begin());
}

/// Positions of the V + E + F vertices, the coarse ones and the middles of edges and faces.
Points linear_positions(const PolygonMesh& mesh, const std::vector<Edge>& edges) {
    const Index V = mesh.vertex_count();
    const auto E = static_cast<Index>(edges.size());
    Points positions(V + E + mesh.face_count(), 3);
    positions.topRows(V) = mesh.positions();
    for (Index e = 0; e < E; ++e) {
        const Edge& edge = edges[static_cast<std::size_t>(e)];
        positions.row(V + e) = (mesh.positions().row(edge.v0) + mesh.positions().row(edge.v1)) / 2;
    }
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        auto mean = positions.row(V + E + f);
        mean.setZero();
        for (const Index v : face) {
            mean += mesh.positions().row(v) / static_cast<double>(face.size());
        }
    }
    return positions;
}

/// Moves vertices and edge points by the paper's rules, boundaries as uniform cubic splines. A boundary vertex at which
/// not two but more boundary edges meet stays where it is.
void smooth_positions(const PolygonMesh& mesh, const std::vector<Edge>& edges, Points& positions) {
    const Index V = mesh.vertex_count();
    const auto E = static_cast<Index>(edges.size());
    Points face_sum = Points::Zero(V, 3);  // of the middles of the faces at a vertex
    Points edge_sum = Points::Zero(V, 3);  // of the middles of its edges, of boundary edges only at a boundary vertex
    Points side_sum = Points::Zero(E, 3);  // of the middles of the faces at an edge
    std::vector<Index> faces(static_cast<std::size_t>(V), 0);
    std::vector<Index> sides(static_cast<std::size_t>(V), 0);
    std::vector<Index> boundary_sides(static_cast<std::size_t>(V), 0);
    for (const Edge& e : edges) {
        if (!e.boundary()) continue;
        ++boundary_sides[static_cast<std::size_t>(e.v0)];
        ++boundary_sides[static_cast<std::size_t>(e.v1)];
    }
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Index next = face[k + 1 < face.size() ? k + 1 : 0];
            side_sum.row(static_cast<Index>(find_edge(edges, face[k], next))) += positions.row(V + E + f);
            face_sum.row(face[k]) += positions.row(V + E + f);
            ++faces[static_cast<std::size_t>(face[k])];
        }
    }
    for (Index e = 0; e < E; ++e) {
        const Edge& edge = edges[static_cast<std::size_t>(e)];
        for (const Index v : {edge.v0, edge.v1}) {
            if (boundary_sides[static_cast<std::size_t>(v)] > 0 && !edge.boundary()) continue;
            edge_sum.row(v) += positions.row(V + e);
            ++sides[static_cast<std::size_t>(v)];
        }
    }
    for (Index e = 0; e < E; ++e) {
        if (edges[static_cast<std::size_t>(e)].boundary()) continue;
        positions.row(V + e) = positions.row(V + e) / 2 + side_sum.row(e) / 4;
    }
    for (Index v = 0; v < V; ++v) {
        const auto k = static_cast<std::size_t>(v);
        if (faces[k] == 0) continue;
        if (boundary_sides[k] == 2) {
            // 1/8 of both neighbours and 3/4 of the vertex, by way of the middles.
            positions.row(v) = positions.row(v) / 2 + edge_sum.row(v) / 4;
        } else if (boundary_sides[k] == 0) {
            const double n = sides[k];
            positions.row(v) = (face_sum.row(v) / faces[k] + 2 * edge_sum.row(v) / n + (n - 3) * positions.row(v)) / n;
        }
    }
}

}  // namespace

Result<PolygonMesh> subdivide_into_quads(const PolygonMesh& mesh, SubdivisionRule rule) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        const Topology topology = build_topology(*mesh.connectivity());
        const std::vector<Edge>& edges = topology.edges;
        const std::vector<Index>& coarse = mesh.connectivity()->corners;
        const std::size_t vertices =
            static_cast<std::size_t>(mesh.vertex_count()) + edges.size() + static_cast<std::size_t>(mesh.face_count());
        constexpr auto most = static_cast<std::size_t>(std::numeric_limits<Index>::max());
        if (coarse.size() > most / 4 || vertices > most) {
            return Error{ErrorCode::bad_mesh, "the mesh would have more vertices or corners than can be numbered"};
        }
        Points positions = linear_positions(mesh, edges);
        if (rule == SubdivisionRule::catmull_clark) {
            for (std::size_t e = 0; e < edges.size(); ++e) {
                if (edges[e].manifold()) continue;
                return Error{ErrorCode::non_manifold_edge,
                             "edge " + edge_text(edges[e]) + " has " + std::to_string(edges[e].faces()) + " faces",
                             static_cast<std::int64_t>(e)};
            }
            smooth_positions(mesh, edges, positions);
        }
        const Index V = mesh.vertex_count();
        const auto E = static_cast<Index>(edges.size());
        std::vector<Index> corners;
        corners.reserve(4 * coarse.size());
        for (Index f = 0; f < mesh.face_count(); ++f) {
            const auto face = mesh.face(f);
            const auto side = [&](std::size_t k) {
                return V + static_cast<Index>(find_edge(edges, face[k], face[(k + 1) % face.size()]));
            };
            Index before = side(face.size() - 1);
            for (std::size_t k = 0; k < face.size(); ++k) {
                const Index after = side(k);
                corners.insert(corners.end(), {face[k], after, V + E + f, before});
                before = after;
            }
        }
        std::vector<Index> offsets(coarse.size() + 1);
        for (std::size_t f = 0; f < offsets.size(); ++f) {
            offsets[f] = static_cast<Index>(4 * f);
        }
        return PolygonMesh::create(std::move(positions), std::move(offsets), std::move(corners));
    });
}

}  // namespace polylap

#pragma once

#include <array>
#include <string>
#include <vector>

#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// An undirected edge v0 < v1 and how often faces run along it each way.
struct Edge {
    Index v0 = 0;
    Index v1 = 0;
    Index forward = 0;     ///< Faces that go v0 → v1.
    Index backward = 0;    ///< Faces that go v1 → v0.
    Index first_face = 0;  ///< The lowest face at this edge.

    Index faces() const noexcept { return forward + backward; }
    bool boundary() const noexcept { return faces() == 1; }
    bool manifold() const noexcept { return faces() <= 2; }
    bool oriented() const noexcept { return forward <= 1 && backward <= 1; }
};

/// Edges, boundary and components of a mesh, computed once per connectivity.
struct Topology {
    std::vector<Edge> edges;               ///< Sorted by (v0, v1).
    std::vector<Index> component;          ///< V: component of each vertex, from 0; -1 for an unreferenced vertex.
    Index component_count = 0;             ///< Components that have faces.
    std::vector<Index> boundary_vertices;  ///< Sorted: vertices on an edge with one face.
    std::vector<Index> unreferenced;       ///< Sorted: vertices in no face.
};

/// O(C log C) for C corners.
Topology build_topology(const Connectivity& connectivity);

/// Something unusual that polylap accepts and reports.
struct MeshIssue {
    enum class Kind : std::uint8_t { unreferenced_vertices, non_manifold_edges, opposite_orientation };
    Kind kind;
    Index count = 0;
    std::string message;  ///< For people; names the first place.
};
std::vector<MeshIssue> find_issues(const Topology& topology);

/// The name of a kind in kebab case, e.g. "non-manifold-edges".
std::string_view issue_name(MeshIssue::Kind kind) noexcept;

/// The closed loops of the boundary, each in the direction of its faces, starting at its lowest vertex.
/// @error non_manifold_edge (element = edge; the message names its two vertices) when an edge has more than two faces,
/// two
///        neighbouring faces disagree in orientation, or a vertex lies on the boundary more than once
Result<std::vector<std::vector<Index>>> boundary_loops(const Topology& topology);

}  // namespace polylap

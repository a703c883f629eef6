#include "polylap/mesh/topology.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

namespace polylap {
namespace {

/// One side of a face, as its lower vertex sees it.
struct HalfEdge {
    Index v1;    ///< The higher vertex.
    Index side;  ///< The face; ~face where it runs from v1 down.

    Index face() const { return side < 0 ? ~side : side; }
};

/// Buckets of half-edges by their lower vertex, each in the order of the faces, need little sorting.
std::vector<Edge> collect_edges(const Connectivity& connectivity) {
    const auto for_sides = [&connectivity](auto&& visit) {
        for (Index f = 0; f < connectivity.face_count(); ++f) {
            const auto face = connectivity.face(f);
            Index from = face.back();
            for (const Index to : face) {
                visit(f, from, to);
                from = to;
            }
        }
    };
    std::vector<Index> last(static_cast<std::size_t>(connectivity.vertex_count) + 1, 0);
    for_sides([&](Index, Index from, Index to) { ++last[static_cast<std::size_t>(std::min(from, to)) + 1]; });
    std::partial_sum(last.begin(), last.end(), last.begin());
    std::vector<HalfEdge> half_edges(connectivity.corners.size());
    for_sides([&](Index f, Index from, Index to) {  // leaves in last[v] where the bucket of v ends
        auto& place = last[static_cast<std::size_t>(std::min(from, to))];
        half_edges[static_cast<std::size_t>(place++)] = {std::max(from, to), from < to ? f : ~f};
    });

    std::vector<Edge> edges;
    edges.reserve(half_edges.size() / 2 + half_edges.size() / 16);
    auto bucket = half_edges.begin();
    for (Index v0 = 0; v0 < connectivity.vertex_count; ++v0) {
        const auto end = half_edges.begin() + last[static_cast<std::size_t>(v0)];
        std::sort(bucket, end, [](const HalfEdge& a, const HalfEdge& b) {
            return a.v1 != b.v1 ? a.v1 < b.v1 : a.face() < b.face();
        });
        for (Index before = -1; bucket != end; ++bucket) {
            if (std::exchange(before, bucket->v1) != bucket->v1)
                edges.push_back({v0, bucket->v1, 0, 0, bucket->face()});
            ++(bucket->side < 0 ? edges.back().backward : edges.back().forward);
        }
    }
    return edges;
}

/// Labels the vertices that are joined by edges; -1 where there is none.
Index label_components(const std::vector<Edge>& edges, std::vector<Index>& component) {
    std::vector<Index> parent(component.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&parent](Index v) {
        while (parent[static_cast<std::size_t>(v)] != v) {
            auto& up = parent[static_cast<std::size_t>(v)];
            up = parent[static_cast<std::size_t>(up)];
            v = up;
        }
        return v;
    };
    // The lower root wins, so that a component's root is its lowest vertex.
    for (const Edge& e : edges) {
        const auto [low, high] = std::minmax({root(e.v0), root(e.v1)});
        parent[static_cast<std::size_t>(high)] = low;
        component[static_cast<std::size_t>(e.v0)] = component[static_cast<std::size_t>(e.v1)] = 0;
    }
    Index count = 0;
    for (Index v = 0; v < static_cast<Index>(component.size()); ++v) {
        auto& label = component[static_cast<std::size_t>(v)];
        if (label < 0) continue;
        const Index r = root(v);
        label = r == v ? count++ : component[static_cast<std::size_t>(r)];
    }
    return count;
}

std::string edge_text(const Edge& e) {
    return std::to_string(e.v0) + "–" + std::to_string(e.v1);
}

std::string counted(Index count, const char* singular, const char* plural) {
    return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

}  // namespace

Topology build_topology(const Connectivity& connectivity) {
    Topology topology;
    topology.edges = collect_edges(connectivity);
    topology.component.assign(static_cast<std::size_t>(connectivity.vertex_count), -1);
    topology.component_count = label_components(topology.edges, topology.component);
    for (const Edge& e : topology.edges) {
        if (e.boundary()) topology.boundary_vertices.insert(topology.boundary_vertices.end(), {e.v0, e.v1});
    }
    auto& boundary = topology.boundary_vertices;
    std::sort(boundary.begin(), boundary.end());
    boundary.erase(std::unique(boundary.begin(), boundary.end()), boundary.end());
    for (Index v = 0; v < connectivity.vertex_count; ++v) {
        if (topology.component[static_cast<std::size_t>(v)] < 0) topology.unreferenced.push_back(v);
    }
    return topology;
}

std::string_view issue_name(MeshIssue::Kind kind) noexcept {
    switch (kind) {
        case MeshIssue::Kind::unreferenced_vertices:
            return "unreferenced-vertices";
        case MeshIssue::Kind::non_manifold_edges:
            return "non-manifold-edges";
        case MeshIssue::Kind::opposite_orientation:
            return "opposite-orientation";
    }
    return "unknown";
}

std::vector<MeshIssue> find_issues(const Topology& topology) {
    std::vector<MeshIssue> issues;
    if (const auto count = static_cast<Index>(topology.unreferenced.size()); count > 0) {
        issues.push_back({MeshIssue::Kind::unreferenced_vertices, count,
                          counted(count, "vertex is", "vertices are") + " in no face, first vertex " +
                              std::to_string(topology.unreferenced.front())});
    }
    Index crowded = 0;
    Index flipped = 0;
    const Edge* first_crowded = nullptr;
    const Edge* first_flipped = nullptr;
    for (const Edge& e : topology.edges) {
        if (!e.manifold()) {
            if (crowded++ == 0) first_crowded = &e;
        } else if (!e.oriented()) {
            if (flipped++ == 0) first_flipped = &e;
        }
    }
    if (crowded > 0) {
        issues.push_back({MeshIssue::Kind::non_manifold_edges, crowded,
                          counted(crowded, "edge has", "edges have") + " more than two faces, first edge " +
                              edge_text(*first_crowded)});
    }
    if (flipped > 0) {
        issues.push_back({MeshIssue::Kind::opposite_orientation, flipped,
                          counted(flipped, "edge has", "edges have") + " faces of opposite orientation, first edge " +
                              edge_text(*first_flipped)});
    }
    return issues;
}

Result<std::vector<std::vector<Index>>> boundary_loops(const Topology& topology) {
    return guard_memory([&]() -> Result<std::vector<std::vector<Index>>> {
        std::unordered_map<Index, Index> next;
        std::vector<Index> starts;
        for (std::size_t k = 0; k < topology.edges.size(); ++k) {
            const Edge& e = topology.edges[k];
            const auto element = static_cast<std::int64_t>(k);
            if (!e.manifold()) {
                return Error{ErrorCode::non_manifold_edge,
                             "edge " + edge_text(e) + " has " + std::to_string(e.faces()) + " faces", element};
            }
            if (!e.oriented()) {
                return Error{ErrorCode::non_manifold_edge,
                             "the two faces at edge " + edge_text(e) + " have opposite orientation", element};
            }
            if (!e.boundary()) continue;
            const auto [from, to] = e.forward == 1 ? std::pair(e.v0, e.v1) : std::pair(e.v1, e.v0);
            if (!next.emplace(from, to).second) {
                return Error{
                    ErrorCode::non_manifold_edge,
                    "the boundary passes vertex " + std::to_string(from) + " twice, first along edge " + edge_text(e),
                    element};
            }
            starts.push_back(from);
        }
        std::sort(starts.begin(), starts.end());
        std::vector<std::vector<Index>> loops;
        for (const Index start : starts) {
            if (!next.contains(start)) continue;
            std::vector<Index>& loop = loops.emplace_back();
            // In an oriented mesh each boundary vertex has as many ways in as out, so the walk closes.
            for (auto at = next.find(start); at != next.end(); at = next.find(loop.back())) {
                if (loop.empty()) loop.push_back(start);
                loop.push_back(at->second);
                next.erase(at);
            }
            loop.pop_back();
        }
        return loops;
    });
}

}  // namespace polylap

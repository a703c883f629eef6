#include <algorithm>
#include <string>

#include "polylap/mesh/convert.hpp"
#include "polylap/mesh/topology.hpp"

namespace polylap {
namespace {

/// A face at a vertex, and its vertices before and after.
struct FaceCorner {
    Index face, previous, next;
};

/// The corners at each vertex, sorted by `next`: those of v are [start[v], start[v + 1]).
struct VertexCorners {
    std::vector<std::size_t> start;
    std::vector<FaceCorner> corners;

    explicit VertexCorners(const PolygonMesh& mesh)
        : start(static_cast<std::size_t>(mesh.vertex_count()) + 1), corners(mesh.connectivity()->corners.size()) {
        for (const Index v : mesh.connectivity()->corners) {
            ++start[static_cast<std::size_t>(v) + 1];
        }
        for (std::size_t v = 0; v + 1 < start.size(); ++v) {
            start[v + 1] += start[v];
        }
        std::vector<std::size_t> end(start.begin(), start.end() - 1);
        for (Index f = 0; f < mesh.face_count(); ++f) {
            const auto face = mesh.face(f);
            for (std::size_t k = 0; k < face.size(); ++k) {
                const Index previous = face[k > 0 ? k - 1 : face.size() - 1];
                const Index next = face[k + 1 < face.size() ? k + 1 : 0];
                corners[end[static_cast<std::size_t>(face[k])]++] = {f, previous, next};
            }
        }
        for (std::size_t v = 0; v + 1 < start.size(); ++v) {
            std::sort(corners.begin() + static_cast<std::ptrdiff_t>(start[v]),
                      corners.begin() + static_cast<std::ptrdiff_t>(start[v + 1]),
                      [](const FaceCorner& a, const FaceCorner& b) { return a.next < b.next; });
        }
    }

    std::span<const FaceCorner> at(Index v) const {
        const auto k = static_cast<std::size_t>(v);
        return std::span(corners).subspan(start[k], start[k + 1] - start[k]);
    }
};

/// The faces at a vertex counter-clockwise; empty when they form no single ring.
/// @param corners sorted by `next`
void walk_ring(std::span<const FaceCorner> corners, std::vector<Index>& ring) {
    ring.clear();
    const FaceCorner* at = &corners.front();
    do {
        ring.push_back(at->face);
        const auto [first, last] =
            std::equal_range(corners.begin(), corners.end(), FaceCorner{0, 0, at->previous},
                             [](const FaceCorner& a, const FaceCorner& b) { return a.next < b.next; });
        at = last - first == 1 ? &*first : nullptr;
    } while (at != nullptr && at != &corners.front() && ring.size() < corners.size());
    if (at != &corners.front() || ring.size() != corners.size()) ring.clear();
}

}  // namespace

Result<PolygonMesh> dual_mesh(const PolygonMesh& mesh) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        std::vector<char> boundary(static_cast<std::size_t>(mesh.vertex_count()), 0);
        for (const Index v : build_topology(*mesh.connectivity()).boundary_vertices) {
            boundary[static_cast<std::size_t>(v)] = 1;
        }
        const VertexCorners vertex_corners(mesh);
        std::vector<Index> offsets{0};
        std::vector<Index> corners;
        std::vector<Index> ring;
        for (Index v = 0; v < mesh.vertex_count(); ++v) {
            const auto around = vertex_corners.at(v);
            if (around.empty() || boundary[static_cast<std::size_t>(v)] != 0) continue;
            walk_ring(around, ring);
            if (ring.empty()) {
                return Error{ErrorCode::non_manifold_edge,
                             "the faces at vertex " + std::to_string(v) + " form no single ring", v};
            }
            if (ring.size() < 3) continue;  // a corner on the way between two faces
            corners.insert(corners.end(), ring.begin(), ring.end());
            offsets.push_back(static_cast<Index>(corners.size()));
        }
        if (corners.empty()) {
            return Error{ErrorCode::bad_mesh, "the dual mesh has no faces, because no vertex lies inside the surface"};
        }
        // Only faces that touch an inner vertex are corners of the dual.
        std::vector<Index> number(static_cast<std::size_t>(mesh.face_count()), -1);
        for (const Index f : corners) {
            number[static_cast<std::size_t>(f)] = 0;
        }
        Points positions(mesh.face_count(), 3);
        Index count = 0;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            if (number[static_cast<std::size_t>(f)] < 0) continue;
            Vector3 mean = Vector3::Zero();
            for (const Index v : mesh.face(f)) {
                mean += mesh.position(v) / static_cast<double>(mesh.face(f).size());
            }
            positions.row(count) = mean.transpose();
            number[static_cast<std::size_t>(f)] = count++;
        }
        for (Index& f : corners) {
            f = number[static_cast<std::size_t>(f)];
        }
        positions.conservativeResize(count, 3);
        return PolygonMesh::create(std::move(positions), std::move(offsets), std::move(corners));
    });
}

}  // namespace polylap

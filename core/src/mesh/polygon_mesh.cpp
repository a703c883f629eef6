#include "polylap/mesh/polygon_mesh.hpp"

#include <string>
#include <utility>

namespace polylap {
namespace {

Error bad_mesh(std::string message, std::int64_t element = -1) {
    return {ErrorCode::bad_mesh, std::move(message), element};
}

Status check_finite(const Points& positions) {
    if (positions.allFinite()) return Done{};
    for (Index v = 0; v < positions.rows(); ++v) {
        if (positions.row(v).allFinite()) continue;
        return bad_mesh("vertex " + std::to_string(v) + " has a coordinate that is not a finite number", v);
    }
    return Done{};
}

Status check_offsets(const std::vector<Index>& offsets, std::size_t corner_count) {
    if (offsets.size() < 2) return bad_mesh("the mesh has no faces");
    if (offsets.front() != 0 || static_cast<std::size_t>(offsets.back()) != corner_count) {
        return bad_mesh("the face offsets must run from 0 to the number of corners");
    }
    for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
        if (std::int64_t{offsets[f + 1]} - offsets[f] >= 3) continue;
        return bad_mesh("face " + std::to_string(f) + " has fewer than three corners", static_cast<std::int64_t>(f));
    }
    return Done{};
}

Status check_corners(const Connectivity& connectivity) {
    std::vector<Index> last_face(static_cast<std::size_t>(connectivity.vertex_count), -1);
    for (Index f = 0; f < connectivity.face_count(); ++f) {
        for (const Index v : connectivity.face(f)) {
            if (v < 0 || v >= connectivity.vertex_count) {
                return bad_mesh("face " + std::to_string(f) + " refers to vertex " + std::to_string(v) +
                                    ", but there are " + std::to_string(connectivity.vertex_count) +
                                    " vertices (counted from 0)",
                                f);
            }
            if (std::exchange(last_face[static_cast<std::size_t>(v)], f) == f) {
                return bad_mesh("face " + std::to_string(f) + " has vertex " + std::to_string(v) + " twice", f);
            }
        }
    }
    return Done{};
}

}  // namespace

Result<PolygonMesh> PolygonMesh::create(Points positions, std::vector<Index> offsets, std::vector<Index> corners) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        if (auto status = check_finite(positions); !status) return status.error();
        if (auto status = check_offsets(offsets, corners.size()); !status) return status.error();
        auto connectivity = std::make_shared<Connectivity>();
        connectivity->vertex_count = static_cast<Index>(positions.rows());
        connectivity->offsets = std::move(offsets);
        connectivity->corners = std::move(corners);
        if (auto status = check_corners(*connectivity); !status) return status.error();
        return PolygonMesh(std::move(connectivity), std::move(positions));
    });
}

Result<PolygonMesh> PolygonMesh::with_positions(Points positions) const {
    return guard_memory([&]() -> Result<PolygonMesh> {
        if (positions.rows() != vertex_count()) {
            return Error{ErrorCode::bad_argument, "the mesh has " + std::to_string(vertex_count()) + " vertices, but " +
                                                      std::to_string(positions.rows()) + " positions were given"};
        }
        if (auto status = check_finite(positions); !status) return status.error();
        return PolygonMesh(connectivity_, std::move(positions));
    });
}

}  // namespace polylap

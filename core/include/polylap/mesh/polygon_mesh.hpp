#pragma once

#include <memory>
#include <span>
#include <vector>

#include "polylap/base/once.hpp"
#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap {

struct FacePairs;

/// Which vertices each face has. Immutable and shared by all meshes that differ only in positions.
struct Connectivity {
    Index vertex_count = 0;
    std::vector<Index> offsets;  ///< F+1: face f has corners [offsets[f], offsets[f+1]).
    std::vector<Index> corners;  ///< Vertex of each corner; faces counter-clockwise seen from outside.

    Index face_count() const noexcept { return static_cast<Index>(offsets.size()) - 1; }
    std::span<const Index> face(Index f) const {
        const auto first = static_cast<std::size_t>(offsets[static_cast<std::size_t>(f)]);
        const auto last = static_cast<std::size_t>(offsets[static_cast<std::size_t>(f) + 1]);
        return std::span(corners).subspan(first, last - first);
    }

    Once<FacePairs> face_pairs;  ///< What matrices on any positions share; the library's own.
};

/// A polygon mesh that passed validation: faces of any size ≥ 3, any number of components, with or without boundary.
///
/// Non-manifold edges, neighbours of opposite orientation and unreferenced vertices are allowed (see find_issues in
/// topology.hpp): a sum over faces does not mind them. Copies share their memory.
class PolygonMesh {
public:
    /// @param positions V×3, finite
    /// @param offsets   F+1, from 0 to corners.size(), rising by at least 3
    /// @param corners   vertex indices in [0, V); no vertex twice in a face
    /// @error bad_mesh (element = face, or vertex for a coordinate), out_of_memory
    static Result<PolygonMesh> create(Points positions, std::vector<Index> offsets, std::vector<Index> corners);

    /// The same faces on other positions.
    /// @param positions V×3, finite
    /// @error bad_mesh (element = vertex), bad_argument for another number of rows
    Result<PolygonMesh> with_positions(Points positions) const;

    Index vertex_count() const noexcept { return connectivity_->vertex_count; }
    Index face_count() const noexcept { return connectivity_->face_count(); }
    std::span<const Index> face(Index f) const { return connectivity_->face(f); }
    const Points& positions() const noexcept { return *positions_; }
    Vector3 position(Index v) const { return positions_->row(v).transpose(); }

    /// Never null. Two meshes with the same pointer have the same faces.
    const std::shared_ptr<const Connectivity>& connectivity() const noexcept { return connectivity_; }

private:
    PolygonMesh(std::shared_ptr<const Connectivity> connectivity, Points positions)
        : connectivity_(std::move(connectivity)), positions_(std::make_shared<const Points>(std::move(positions))) {}

    std::shared_ptr<const Connectivity> connectivity_;
    std::shared_ptr<const Points> positions_;
};

}  // namespace polylap

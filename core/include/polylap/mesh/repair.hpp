#pragma once

#include <string>
#include <vector>

#include "polylap/mesh/mesh_io.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// One kind of change that repair made, with where.
struct RepairChange {
    enum class Kind : std::uint8_t {
        merged_vertices,   ///< elements: vertices that became another one
        repeated_corners,  ///< elements: faces that lost a repeated corner
        degenerate_faces,  ///< elements: faces removed: fewer than three corners left, or no area
        duplicate_faces,   ///< elements: faces removed: the same corners as an earlier one
        turned_faces,      ///< elements: faces whose orientation was reversed
        dropped_vertices,  ///< elements: vertices that no face uses any more because of the above
    };
    Kind kind;
    std::vector<Index> elements;  ///< Sorted; numbers of the file, from 0.
    std::string message;          ///< One sentence for people, with the count and the first few.
};

struct Repaired {
    PolygonMesh mesh;
    std::vector<RepairChange> changes;     ///< Only kinds that happened.
    std::vector<Index> original_vertices;  ///< V: the vertex of the file that each vertex was.
    std::vector<Index> original_faces;     ///< F: the face of the file that each face was.
};

struct RepairOptions {
    /// Vertices closer than this multiple of the bounding box's diagonal become one; 0: only those exactly equal.
    double merge_distance = 0;
};

/// Repairs on request: merges coincident vertices, drops repeated corners, degenerate and duplicate faces, and orients
/// the faces of each manifold component alike (the way most of their area already is).
/// @error bad_mesh (nothing is left), bad_argument (options), out_of_memory
Result<Repaired> repair(const RawMesh& raw, RepairOptions options = {});

/// The name of a kind in kebab case, e.g. "merged-vertices".
std::string_view repair_name(RepairChange::Kind kind) noexcept;

}  // namespace polylap

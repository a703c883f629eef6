#pragma once

#include <string>
#include <vector>

#include "polylap/mesh/mesh_io.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// One kind of change that repair made, or could not make, with where.
struct RepairChange {
    enum class Kind : std::uint8_t {
        merged_vertices,     ///< elements: vertices that became another one
        repeated_corners,    ///< elements: faces that lost a repeated corner and were kept
        degenerate_faces,    ///< elements: faces removed: fewer than three corners left, or no area
        duplicate_faces,     ///< elements: faces removed: the same corners as an earlier one, either way around
        turned_faces,        ///< elements: faces whose orientation was reversed
        unorientable_faces,  ///< elements: faces of one-sided components (a Möbius strip), which were left as they are
        dropped_vertices,    ///< elements: vertices that no face uses any more because of the above
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
    /// Vertices no farther apart than this multiple of the bounding box's diagonal become one; 0: only those exactly
    /// equal. In [0, 1).
    double merge_distance = 0;
};

/// A face has no area if no corner is farther from one line than this multiple of the face's perimeter, or than
/// this multiple of its largest coordinate: such a distance is of rounding.
inline constexpr double collinear_ratio = 1e-14;

/// Repairs on request, in this order:
/// - merges vertices: each becomes the lowest-numbered one within the distance that did not itself become another;
/// - drops repeated corners: a corner equal to the one before it, then spikes (of a b a only a stays), and of a corner
///   that is still there twice all but the first;
/// - removes faces with fewer than three corners left or all corners on one line, and faces that have the same corners
///   as an earlier one in the same cyclic order, either way around;
/// - orients the faces of each component alike, the way most of its area already is (the way of its lowest face at a
///   tie). Edges with more than two faces connect nothing.
/// Vertices that no face of the file used stay.
/// @error bad_mesh (nothing is left; or `raw` is not as RawMesh says), bad_argument (options), out_of_memory, cancelled
Result<Repaired> repair(const RawMesh& raw, RepairOptions options = {}, Monitor monitor = {});

/// The name of a kind in kebab case, e.g. "merged-vertices".
std::string_view repair_name(RepairChange::Kind kind) noexcept;

}  // namespace polylap

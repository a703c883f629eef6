#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "polylap/apply/diagnostics.hpp"
#include "polylap/base/monitor.hpp"
#include "polylap/base/result.hpp"

namespace polylap {

/// Triangles that fill the faces, for drawing.
struct DisplayTriangles {
    std::vector<std::array<Index, 3>> triangles;  ///< Vertices; Σ (n_f - 2) of them, face after face.
    std::vector<std::uint8_t> edges;  ///< Per triangle: bit k is set if its side k → k+1 is an edge of the polygon.
    std::vector<Index> face;          ///< Per triangle: its face.
};

/// The Delaunay triangulation of each projected face, the planar operator's own. A face that has none (crossing itself,
/// no area) gets a plain fan.
/// @error out_of_memory, cancelled (asked between faces)
Result<DisplayTriangles> triangulate_for_display(const PolygonMesh& mesh, Monitor monitor = {});

/// Lines between vertex pairs, laid on the display triangles of a face that both vertices share, so that they neither
/// float nor sink.
struct SurfaceLines {
    std::vector<std::array<Vector3, 2>> segments;
    std::vector<double> start;  ///< Per segment: length along its line at which it starts, so that dashes run on.
    std::vector<Index> pair;    ///< Per segment: the pair it belongs to.
};

/// @param pairs         vertex pairs; one without a common face is drawn straight
/// @param most_segments where to stop: then the pairs that were drawn are spread evenly over all of them
/// @return lines in no particular order.   Cost O(n) for a pair in a face of n corners
SurfaceLines drape_pairs(const PolygonMesh& mesh, const DisplayTriangles& display, std::span<const Weight> pairs,
                         std::size_t most_segments = std::numeric_limits<std::size_t>::max());

}  // namespace polylap

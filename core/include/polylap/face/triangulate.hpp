#pragma once

#include <array>
#include <span>
#include <vector>

#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap {

/// How a planar polygon is cut into n-2 triangles by diagonals that lie inside it.
///
/// Often several cuts are equally good, all of a regular polygon's for delaunay. What differs by no more than rounding,
/// of a mesh up to a thousand times as large, counts as equal, and the corners' numbers decide: a regular polygon looks
/// the same from each corner, so nothing else could and outlast a turn in space. The cut is thus the same on every
/// machine and wherever the mesh is moved to; only a face that begins at another corner may be cut differently.
enum class TriangulationRule : std::uint8_t {
    delaunay,  ///< Constrained Delaunay: least Dirichlet energy (Rippa 1990), inner diagonals get weights ≥ 0, up to
               ///< rounding. Corners on a circle are cut from the lowest.
    min_max_angle,      ///< Smallest largest angle; ties by the next largest, and so on.
    shortest_diagonal,  ///< The shortest inside diagonal first, then the shortest that does not cross it, and so on.
    fan,                ///< All diagonals from the first corner from which all triangles lie inside and have area.
};

using Triangle = std::array<Index, 3>;

/// Cuts a simple polygon into triangles of positive area.
/// @param polygon n ≥ 3 points, counter-clockwise; concave corners and straight ones (180°) are fine
/// @param out     overwritten with n-2 triangles of local corner numbers, each counter-clockwise
/// @error degenerate_face (without element) when the polygon crosses or touches itself or has no area, or when the rule
///        is `fan` and no corner has one; out_of_memory
/// Cost O(n²) for delaunay and fan on convex polygons, O(n³) otherwise; min_max_angle resolves ties exactly up to 64
/// corners, in O(n⁴) at worst; beyond, the two largest angles decide.
Status triangulate_polygon(std::span<const Eigen::Vector2d> polygon, TriangulationRule rule,
                           std::vector<Triangle>& out);

}  // namespace polylap

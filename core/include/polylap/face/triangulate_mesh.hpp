#pragma once

#include "polylap/base/monitor.hpp"
#include "polylap/face/triangulate.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// The names of the rules, in the order of TriangulationRule.
inline constexpr std::array triangulation_rule_names{"delaunay", "min-max-angle", "shortest-diagonal", "fan"};

/// Cuts each face by diagonals, on its projection along the vector area. The vertices stay; the n-2 triangles of a face
/// keep its place in the order of faces, and its orientation.
/// @error degenerate_face (element = face): no vector area, or see triangulate_polygon; out_of_memory, cancelled
Result<PolygonMesh> triangulate_mesh(const PolygonMesh& mesh, TriangulationRule rule, Monitor monitor = {});

/// The face that a triangle of triangulate_mesh was cut from.
Index face_of_triangle(const PolygonMesh& mesh, Index triangle);

}  // namespace polylap

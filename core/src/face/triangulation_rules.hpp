#pragma once

#include <vector>

#include "face/plane_polygon.hpp"
#include "polylap/face/triangulate.hpp"

namespace polylap {

// One function per TriangulationRule. The polygon is simple and has area; errors are degenerate_face.

Status cut_delaunay(const PlanePolygon& polygon, std::vector<Triangle>& out);
Status cut_min_max_angle(const PlanePolygon& polygon, std::vector<Triangle>& out);
Status cut_shortest_diagonal(const PlanePolygon& polygon, std::vector<Triangle>& out);
Status cut_fan(const PlanePolygon& polygon, std::vector<Triangle>& out);

}  // namespace polylap

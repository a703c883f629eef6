#pragma once

#include <span>
#include <vector>

#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// The corners of one face, in order.
using Corners = std::span<const Vector3>;

/// Vector area a = ½ Σ xᵢ × xᵢ₊₁ (Alexa & Wardetzky 2011; Herholz 2012, eq. 4.8), length²; computed relative to the
/// first corner.
Vector3 vector_area(Corners corners);

/// A vector area below this multiple of the squared perimeter counts as zero.
inline constexpr double zero_area_ratio = 1e-14;

/// True if the face has no direction to project along: |a| ≤ zero_area_ratio · perimeter².
bool has_zero_area(Corners corners, const Vector3& area);

/// The maximal projection of a face: its corners in an orthonormal frame of the plane perpendicular to its vector area,
/// relative to the first corner and counter-clockwise.
struct Projection {
    Vector3 normal;   ///< Unit vector area.
    double area = 0;  ///< |a|, length².
    std::vector<Eigen::Vector2d> points;
};

/// Projects along the vector area. `out` is overwritten and may be reused from face to face.
/// @return false for a face of zero vector area
bool project_maximally(Corners corners, Projection& out);

/// Gathers the corners of face f. `out` is overwritten and may be reused.
void gather_corners(const PolygonMesh& mesh, Index f, std::vector<Vector3>& out);

}  // namespace polylap

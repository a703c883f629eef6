#pragma once

#include "polylap/face/triangulate.hpp"
#include "polylap/operators/operator.hpp"

namespace polylap {

extern const OperatorInfo planar_info;

struct PlanarOptions {
    TriangulationRule rule = TriangulationRule::delaunay;
};

/// Stiffness of the planar operator [Herholz 2012, section 4.2.4]: each face is projected along its vector area,
/// triangulated there, and the cotan matrices of the projected triangles are summed.
/// @param mesh faces may be non-planar or concave, not of zero vector area, not self-crossing in projection
/// @return S V×V symmetric PSD, unitless
/// @error degenerate_face (element = face), out_of_memory, cancelled.   Cost: see triangulate_polygon
Result<SparseMatrix> planar_stiffness(const PolygonMesh& mesh, PlanarOptions options = {}, Monitor monitor = {});

}  // namespace polylap

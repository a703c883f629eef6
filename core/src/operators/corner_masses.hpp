#pragma once

#include "polylap/face/triangulate.hpp"
#include "polylap/face/vector_area.hpp"
#include "polylap/operators/mass.hpp"

namespace polylap {

/// What a triangle, three of the corners x, adds to the mass of each of them.
/// @param rule barycentric, ring, circumcentric or mixed_voronoi
Vector3 corner_masses(Corners x, const Triangle& triangle, MassRule rule);

/// What it adds by MassRule::galerkin.
Eigen::Matrix3d galerkin_mass(Corners x, const Triangle& triangle);

}  // namespace polylap

#pragma once

#include "polylap/mesh/polygon_mesh.hpp"

// The meshes of the benchmarks, all of about n vertices.
namespace polylap::bench {

/// A quad torus, with noise along its normals, so that its faces are not planar.
PolygonMesh torus_of(Index n);
/// A square grid of the plane, with boundary.
PolygonMesh grid_of(Index n);
/// Hexagons and twelve pentagons on a sphere; of the sizes 20 · 4^level, the one nearest to n.
PolygonMesh hexagon_sphere_of(Index n);
/// A closed shell: two sheets half an edge apart, as noisy as they are thin, that a cut through space cannot tell
/// apart.
PolygonMesh thin_shell_of(Index n);
/// Eight tori beside each other.
PolygonMesh tori_of(Index n);

struct Shape {
    const char* name;
    PolygonMesh (*make)(Index n);
};
inline constexpr Shape factor_shapes[] = {
    {"torus", torus_of}, {"hexagon sphere", hexagon_sphere_of}, {"thin shell", thin_shell_of}, {"eight tori", tori_of}};

}  // namespace polylap::bench

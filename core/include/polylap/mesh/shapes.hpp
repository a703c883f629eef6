#pragma once

#include "polylap/base/parameter.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// nx × ny quads on the rectangle [0, width] × [0, height] of the plane z = 0; vertex (i, j) is j (nx + 1) + i.
/// @param nx,ny at least 1   @param width,height positive, length
/// @error bad_argument, bad_mesh (a coordinate overflows), out_of_memory
Result<PolygonMesh> make_grid(Index nx, Index ny, double width = 1, double height = 1);

/// The n × n grid on [-½, ½]² lifted to z = height · (x² - y²) · 2, so that |z| ≤ height / 2.
/// @error bad_argument, bad_mesh (a coordinate overflows), out_of_memory
Result<PolygonMesh> make_saddle(Index n, double height = 1);

/// A torus around the z axis, nu quads the long way and nv the short way; closed, vertex (i, j) is i · nv + j.
/// @param major,minor radii of the centre line and of the tube, major > minor > 0, length
/// @error bad_argument when nu or nv < 3 or the radii do not fit
Result<PolygonMesh> make_torus(Index nu, Index nv, double major = 1, double minor = 0.4);

/// One line of the shape table.
struct ShapeInfo {
    const char* id;  ///< Kebab case.
    const char* label;
    const char* summary;  ///< One sentence.
    std::span<const Parameter> parameters;
    /// @param values one per parameter, in range
    Result<PolygonMesh> (*make)(std::span<const double> values);
};

/// The shape table, in the order of menus: what the command line, JavaScript and the page can make.
std::span<const ShapeInfo* const> shapes() noexcept;

/// @error bad_argument (no such shape; the message lists the known ones)
Result<const ShapeInfo*> find_shape(std::string_view id);

/// @error bad_argument, parameter_out_of_range, out_of_memory
Result<PolygonMesh> make_shape(std::string_view id, Settings settings = {});

}  // namespace polylap

#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "polylap/base/monitor.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// Reads a Wavefront OBJ file from memory, faces of any size.
///
/// Understood: `v x y z [w | r g b]`, `f` with `v`, `v/vt`, `v//vn`, `v/vt/vn` in any mix, negative (relative) indices,
/// comments, groups, CRLF, tabs, a UTF-8 byte-order mark, `\` continuations. Texture coordinates, normals, materials
/// and groups are read past. Coordinates are rounded correctly to double.
/// @error parse_error (line): a coordinate that is missing or no finite number, an index that is no number, zero or out
/// of range, a face with fewer than
///        three or with repeated corners, a file that is empty, HTML or binary, or without faces. out_of_memory,
///        cancelled
Result<PolygonMesh> read_obj(std::span<const std::byte> bytes, Monitor monitor = {});

/// Writes `v` with 17 significant digits (reading them back gives the same doubles) and `f` lines.
std::string write_obj(const PolygonMesh& mesh);

}  // namespace polylap

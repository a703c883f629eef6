#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "polylap/base/monitor.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// Reads a Wavefront OBJ file from memory, faces of any size.
///
/// Understood: `v x y z`, whatever numbers follow (a weight, a colour) being read past; `f` with `v`, `v/vt`, `v//vn`,
/// `v/vt/vn` in any mix, with negative (relative) indices, or with vertices that come later in the file; comments, also
/// behind a statement; LF, CRLF and CR; a UTF-8 byte-order mark; `\` continuations of `v` and `f`. All other lines are
/// skipped. Coordinates are rounded correctly to double.
/// @error parse_error. With line (and element = vertex or face): a coordinate that is missing or no finite number, an
/// index that is no whole number, zero or
///        out of range, a face with fewer than three or with repeated corners, a zero byte. Without line: a file that
///        is empty, of another format, or without faces. out_of_memory, cancelled
Result<PolygonMesh> read_obj(std::span<const std::byte> bytes, Monitor monitor = {});

/// Writes `v` with 17 significant digits (reading them back gives the same doubles) and `f` lines.
/// @error out_of_memory
Result<std::string> write_obj(const PolygonMesh& mesh);

}  // namespace polylap

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polylap/base/monitor.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

enum class MeshFormat : std::uint8_t { obj, off, ply, stl };

/// The format that a file's name says by its ending (.obj, .off, .ply, .stl, in any case).
/// @error bad_argument (the message lists the endings)
Result<MeshFormat> format_of(std::string_view name);

/// What a file gave before anything was checked beyond its own syntax: faces may be too small, have repeated corners,
/// and vertices may coincide. What repair starts from.
struct RawMesh {
    Points positions;            ///< V×3, finite
    std::vector<Index> offsets;  ///< F+1
    std::vector<Index> corners;  ///< In [0, V).
    /// One clause for people on what reading did to the data, e.g. how many triangle corners of an STL were welded.
    std::vector<std::string> notes;
};

/// Reads the syntax of a file. A face with fewer than three or with repeated corners passes here.
/// @error parse_error (line, or byte from 0 in the message for binary files), out_of_memory, cancelled
Result<RawMesh> read_raw(std::span<const std::byte> bytes, MeshFormat format, Monitor monitor = {});

/// Reads a mesh file. As strict for each format as read_obj is for its own: every error names the line (or the byte),
/// the vertex or the face.
/// OFF: ASCII with or without a count of edges, colours, normals (NOFF, COFF, STOFF …), comments, each vertex and each
/// face on a line of its own; `OFF BINARY`, little-endian as pmp-library writes it or big-endian as Geomview does. PLY:
/// ascii, binary_little_endian, binary_big_endian; other properties and elements skipped. STL: ascii and binary; equal
/// positions are welded.
/// @error bad_mesh (line; element = face): a face with fewer than three or with repeated corners, which read_raw lets
/// pass and repair (repair.hpp) removes, unless a parse_error comes later in the file. parse_error: anything else,
/// which is no matter of repair. out_of_memory, cancelled
Result<PolygonMesh> read_mesh(std::span<const std::byte> bytes, MeshFormat format, Monitor monitor = {});

/// The same, with what RawMesh::notes says.
struct ReadMesh {
    PolygonMesh mesh;
    std::vector<std::string> notes;
};
Result<ReadMesh> read_mesh_with_notes(std::span<const std::byte> bytes, MeshFormat format, Monitor monitor = {});

/// Writes a mesh: OBJ, ASCII OFF and ASCII PLY with 17 significant digits; binary STL.
/// @error bad_argument (STL: face with more than three corners, element = face; coordinate beyond single precision,
/// element = vertex), out_of_memory
Result<std::string> write_mesh(const PolygonMesh& mesh, MeshFormat format);

/// Reads a Wavefront OBJ file from memory, faces of any size.
///
/// Understood: `v x y z`, whatever numbers follow (a weight, a colour) being read past; `f` with `v`, `v/vt`, `v//vn`,
/// `v/vt/vn` in any mix, with negative (relative) indices, or with vertices that come later in the file; comments, also
/// behind a statement; LF, CRLF and CR; a UTF-8 byte-order mark; `\` continuations of `v` and `f`. All other lines are
/// skipped. Coordinates are rounded correctly to double.
/// @error parse_error. With line (and element = vertex or face): a coordinate that is missing or no finite number, an
/// index that is no whole number, zero or
///        out of range, a zero byte. Without line: a file that is empty, of another format, or without faces.
///        bad_mesh (line; element = face): a face with fewer than three or with repeated corners. out_of_memory,
///        cancelled
Result<PolygonMesh> read_obj(std::span<const std::byte> bytes, Monitor monitor = {});

/// Writes `v` with 17 significant digits (reading them back gives the same doubles) and `f` lines.
/// @error out_of_memory
Result<std::string> write_obj(const PolygonMesh& mesh);

}  // namespace polylap

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#include <Eigen/Geometry>

#include "polylap/mesh/mesh_io.hpp"

namespace polylap {
namespace {

/// Appends as printf's %.17g does in the C locale: reading it back gives the same double, and a German locale writes no
/// comma.
void append_double(std::string& text, double value) {
    char digits[32];
#ifdef __cpp_lib_to_chars
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 17).ptr);
#else  // Emscripten 3.1.6, whose only locale is C
    text.append(digits, static_cast<std::size_t>(std::snprintf(digits, sizeof digits, "%.17g", value)));
#endif
}

void append_index(std::string& text, std::int64_t value) {
    char digits[24];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void reserve_text(std::string& text, const PolygonMesh& mesh) {
    constexpr std::size_t vertex_bytes = 64, corner_bytes = 8;  // usual lengths
    text.reserve(static_cast<std::size_t>(mesh.vertex_count()) * vertex_bytes +
                 mesh.connectivity()->corners.size() * corner_bytes);
}

void append_position(std::string& text, const PolygonMesh& mesh, Index v) {
    const auto xyz = mesh.positions().row(v);
    append_double(text, xyz[0]);
    text += ' ';
    append_double(text, xyz[1]);
    text += ' ';
    append_double(text, xyz[2]);
    text += '\n';
}

/// The positions, then the faces with their numbers of corners, as OFF and PLY have them.
void append_counted(std::string& text, const PolygonMesh& mesh) {
    for (Index v = 0; v < mesh.vertex_count(); ++v)
        append_position(text, mesh, v);
    for (Index f = 0; f < mesh.face_count(); ++f) {
        append_index(text, static_cast<std::int64_t>(mesh.face(f).size()));
        for (const Index vertex : mesh.face(f)) {
            text += ' ';
            append_index(text, vertex);
        }
        text += '\n';
    }
}

std::string write_off(const PolygonMesh& mesh) {
    std::string text;
    reserve_text(text, mesh);
    text += "OFF\n" + std::to_string(mesh.vertex_count()) + ' ' + std::to_string(mesh.face_count()) + " 0\n";
    append_counted(text, mesh);
    return text;
}

std::string write_ply(const PolygonMesh& mesh) {
    std::size_t most_corners = 0;
    for (Index f = 0; f < mesh.face_count(); ++f)
        most_corners = std::max(most_corners, mesh.face(f).size());
    std::string text;
    reserve_text(text, mesh);
    text +=
        "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.vertex_count()) +
        "\nproperty double x\nproperty double y\nproperty double z\nelement face " + std::to_string(mesh.face_count()) +
        // What everybody writes, wherever it can hold the counts.
        (most_corners > 255 ? "\nproperty list uint" : "\nproperty list uchar") + " int vertex_indices\nend_header\n";
    append_counted(text, mesh);
    return text;
}

void append_little_endian(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(static_cast<unsigned char>(value >> shift));
}

void append_floats(std::string& bytes, const Vector3& v) {
    for (const double coordinate : v) {
        const auto rounded = static_cast<float>(coordinate);
        std::uint32_t bits = 0;
        std::memcpy(&bits, &rounded, sizeof bits);
        append_little_endian(bytes, bits);
    }
}

Result<std::string> write_stl(const PolygonMesh& mesh) {
    constexpr double largest = std::numeric_limits<float>::max();
    constexpr std::size_t header_bytes = 80, facet_bytes = 50;
    for (Index v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.position(v).cwiseAbs().maxCoeff() > largest)
            return Error{ErrorCode::bad_argument,
                         "vertex " + std::to_string(v) + " has a coordinate beyond the single precision of an STL file",
                         v};
    std::string bytes = "binary STL written by polylap";  // not beginning with "solid", which means text
    bytes.reserve(header_bytes + 4 + facet_bytes * static_cast<std::size_t>(mesh.face_count()));
    bytes.resize(header_bytes, ' ');
    append_little_endian(bytes, static_cast<std::uint32_t>(mesh.face_count()));
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        if (face.size() != 3)
            return Error{ErrorCode::bad_argument,
                         "face " + std::to_string(f) + " has " + std::to_string(face.size()) +
                             " corners, and an STL file holds triangles only",
                         f};
        const Vector3 a = mesh.position(face[0]), b = mesh.position(face[1]), c = mesh.position(face[2]);
        // Dividing first keeps huge and tiny triangles from over- and underflowing; a degenerate one has the normal 0,
        // which readers take for "compute it".
        const double size = std::max((b - a).cwiseAbs().maxCoeff(), (c - a).cwiseAbs().maxCoeff());
        Vector3 normal = Vector3::Zero();
        if (size > 0) normal = ((b - a) / size).cross((c - a) / size).stableNormalized();
        append_floats(bytes, normal);
        append_floats(bytes, a);
        append_floats(bytes, b);
        append_floats(bytes, c);
        bytes.append(2, '\0');
    }
    return bytes;
}

}  // namespace

Result<std::string> write_obj(const PolygonMesh& mesh) {
    return guard_memory([&]() -> Result<std::string> {
        std::string text;
        reserve_text(text, mesh);
        for (Index v = 0; v < mesh.vertex_count(); ++v) {
            text += "v ";
            append_position(text, mesh, v);
        }
        for (Index f = 0; f < mesh.face_count(); ++f) {
            text += 'f';
            for (const Index vertex : mesh.face(f)) {
                text += ' ';
                append_index(text, std::int64_t{vertex} + 1);
            }
            text += '\n';
        }
        return text;
    });
}

Result<std::string> write_mesh(const PolygonMesh& mesh, MeshFormat format) {
    return guard_memory([&]() -> Result<std::string> {
        switch (format) {
            case MeshFormat::obj:
                return write_obj(mesh);
            case MeshFormat::off:
                return write_off(mesh);
            case MeshFormat::ply:
                return write_ply(mesh);
            case MeshFormat::stl:
                return write_stl(mesh);
        }
        return Error{ErrorCode::bad_argument, "there is no such format of meshes"};
    });
}

}  // namespace polylap

#include "polylap/mesh/mesh_io.hpp"

#include <charconv>
#include <cstdio>

#include "obj_check.hpp"
#include "obj_faces.hpp"

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

}  // namespace

Result<PolygonMesh> read_obj(std::span<const std::byte> bytes, Monitor monitor) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        // About the shares of the time that a large file takes.
        Stretch checking{monitor, 0, 0.6};
        Stretch parsing{monitor, 0.6, 1};
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        auto script = obj::check(text, checking.monitor());
        if (!script) return script.error();
        auto faces = obj::read_faces(*script, parsing.monitor());
        if (!faces) return faces.error();
        const auto rows = static_cast<Eigen::Index>(script->vertices());
        Points positions = Eigen::Map<const Points>(script->coordinates.data(), rows, 3);
        return PolygonMesh::create(std::move(positions), std::move(faces->offsets), std::move(faces->corners));
    });
}

Result<std::string> write_obj(const PolygonMesh& mesh) {
    return guard_memory([&]() -> Result<std::string> {
        constexpr std::size_t vertex_bytes = 64, corner_bytes = 8;  // usual lengths
        std::string text;
        text.reserve(static_cast<std::size_t>(mesh.vertex_count()) * vertex_bytes +
                     mesh.connectivity()->corners.size() * corner_bytes);
        for (Index v = 0; v < mesh.vertex_count(); ++v) {
            text += 'v';
            for (const double coordinate : mesh.positions().row(v)) {
                text += ' ';
                append_double(text, coordinate);
            }
            text += '\n';
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

}  // namespace polylap

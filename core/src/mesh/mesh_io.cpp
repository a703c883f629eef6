#include "polylap/mesh/mesh_io.hpp"

#include <utility>

#include "obj_check.hpp"
#include "obj_faces.hpp"
#include "raw_builder.hpp"
#include "text_lines.hpp"

namespace polylap {
namespace {

constexpr std::pair<std::string_view, MeshFormat> endings[] = {
    {".obj", MeshFormat::obj},
    {".off", MeshFormat::off},
    {".ply", MeshFormat::ply},
    {".stl", MeshFormat::stl},
};

Result<RawMesh> read(std::span<const std::byte> bytes, MeshFormat format, io::FaceRule rule, Monitor monitor) {
    return guard_memory([&]() -> Result<RawMesh> {
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        switch (format) {
            case MeshFormat::obj:
                return io::read_obj(text, rule, monitor);
            case MeshFormat::off:
                return io::read_off(text, rule, monitor);
            case MeshFormat::ply:
                return io::read_ply(text, rule, monitor);
            case MeshFormat::stl:
                return io::read_stl(text, rule, monitor);
        }
        return Error{ErrorCode::bad_argument, "there is no such format of meshes"};
    });
}

}  // namespace

Result<RawMesh> io::read_obj(std::string_view text, FaceRule rule, Monitor monitor) {
    // About the shares of the time that a large file takes.
    Stretch checking{monitor, 0, 0.6};
    Stretch parsing{monitor, 0.6, 1};
    auto script = obj::check(text, rule, checking.monitor());
    if (!script) return script.error();
    auto faces = obj::read_faces(*script, parsing.monitor());
    if (!faces) return faces.error();
    const auto rows = static_cast<Eigen::Index>(script->vertices());
    return RawMesh{Eigen::Map<const Points>(script->coordinates.data(), rows, 3),
                   std::move(faces->offsets),
                   std::move(faces->corners),
                   {}};
}

Result<MeshFormat> format_of(std::string_view name) {
    return guard_memory([&]() -> Result<MeshFormat> {
        for (const auto& [ending, format] : endings)
            if (name.size() > ending.size() && io::is_word(name.substr(name.size() - ending.size()), ending))
                return format;
        return Error{ErrorCode::bad_argument,
                     "'" + std::string(name) + "' is no mesh file: its name must end in .obj, .off, .ply or .stl"};
    });
}

Result<RawMesh> read_raw(std::span<const std::byte> bytes, MeshFormat format, Monitor monitor) {
    return read(bytes, format, io::FaceRule::any, monitor);
}

Result<ReadMesh> read_mesh_with_notes(std::span<const std::byte> bytes, MeshFormat format, Monitor monitor) {
    auto raw = read(bytes, format, io::FaceRule::sound, monitor);
    if (!raw) return raw.error();
    auto mesh = PolygonMesh::create(std::move(raw->positions), std::move(raw->offsets), std::move(raw->corners));
    if (!mesh) return mesh.error();
    return ReadMesh{*std::move(mesh), std::move(raw->notes)};
}

Result<PolygonMesh> read_mesh(std::span<const std::byte> bytes, MeshFormat format, Monitor monitor) {
    auto read = read_mesh_with_notes(bytes, format, monitor);
    if (!read) return read.error();
    return std::move(read->mesh);
}

Result<PolygonMesh> read_obj(std::span<const std::byte> bytes, Monitor monitor) {
    return read_mesh(bytes, MeshFormat::obj, monitor);
}

}  // namespace polylap

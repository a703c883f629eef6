// Meshes in and out.
#include "open_session.hpp"

#include <filesystem>

#include "polylap/mesh/mesh_io.hpp"
#include "tables.hpp"

namespace polylap::tool {

Error in_file(const std::string& path, Error error) {
    error.message = (path == "-" ? "standard input" : path) + ": " + error.message;
    return error;
}

Result<Session> open_session(const MeshChoice& mesh) {
    const auto bytes = read_file(mesh.path);
    if (!bytes) return bytes.error();
    const std::string name = mesh.path == "-" ? "stdin.obj" : std::filesystem::path(mesh.path).filename().string();
    auto session = Session::open(std::as_bytes(std::span(*bytes)), name,
                                 {.repair = mesh.repair, .repair_options = {.merge_distance = mesh.merge_distance}});
    if (session) return session;
    Error error = in_file(mesh.path, session.error());
    if (!mesh.repair && error.code == ErrorCode::bad_mesh) error.message += " (--repair drops or mends what it can)";
    return error;
}

Result<Session> open_with_operator(const MeshChoice& mesh, const OperatorChoice& choice) {
    auto spec = make_spec(choice.id, choice.settings);
    if (!spec) return spec.error();
    auto session = open_session(mesh);
    if (!session) return session;
    if (!choice.weights.empty()) {
        const auto text = read_file(choice.weights);
        if (!text) return text.error();
        const Index vertices = session->mesh().vertex_count();
        const auto rows = parse_vertex_values(*text, vertices, "weight");
        if (!rows) return in_file(choice.weights, rows.error());
        spec->vertex_weights.assign(static_cast<std::size_t>(vertices), 0.0);
        for (std::size_t k = 0; k < rows->vertices.size(); ++k)
            spec->vertex_weights[static_cast<std::size_t>(rows->vertices[k])] = rows->values[k];
    }
    if (auto status = session->set_operator(side, std::move(*spec)); !status) return status.error();
    return session;
}

std::string reading_text(const Session& session) {
    std::string text;
    for (const std::string& note : session.notes())
        text += "note                  " + note + '\n';
    for (const RepairChange& change : session.repairs().changes)
        text += "repaired              " + change.message + '\n';
    return text;
}

Result<Output> mesh_output(const PolygonMesh& mesh, const std::string& path) {
    auto format = MeshFormat::obj;
    if (path != "-" && std::filesystem::path(path).has_extension()) {
        const auto named = format_of(path);
        if (!named) return named.error();
        format = *named;
    }
    auto text = write_mesh(mesh, format);
    if (!text) return in_file(path, text.error());
    return Output{path, *std::move(text)};
}

}  // namespace polylap::tool

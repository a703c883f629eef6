// The commands that make meshes: `make` and `convert`.
#include <cmath>

#include "open_session.hpp"
#include "polylap/apply/conversions.hpp"
#include "polylap/apply/noise.hpp"
#include "polylap/mesh/shapes.hpp"

namespace polylap::tool {

Result<Outputs> make(const NamedChoice& shape, const NoiseChoice& noise, const std::string& path) {
    auto mesh = make_shape(shape.id, shape.settings);
    if (mesh && noise.amplitude != 0) {
        mesh = add_normal_noise(*mesh, noise.amplitude, static_cast<std::uint32_t>(noise.seed));
    }
    if (!mesh) return mesh.error();
    auto output = mesh_output(*mesh, path);
    if (!output) return output.error();
    return Outputs{*std::move(output)};
}

Result<Outputs> convert(const MeshChoice& mesh, const std::vector<NamedChoice>& conversions, const std::string& path,
                        const std::string& map_path) {
    const auto session = open_session(mesh);
    if (!session) return session.error();
    PolygonMesh surface = session->mesh();
    for (const NamedChoice& conversion : conversions) {
        auto converted = polylap::convert(surface, conversion.id, conversion.settings);
        if (!converted) return in_file(mesh.path, converted.error());
        surface = *std::move(converted);
    }
    auto output = mesh_output(surface, path);
    if (!output) return output.error();
    Outputs outputs{*std::move(output)};
    if (!map_path.empty()) {
        const auto& original = session->repairs().original_vertices;
        std::string rows = "vertex,original\n";
        for (Index v = 0; v < session->mesh().vertex_count(); ++v) {
            const Index from = original.empty() ? v : original[static_cast<std::size_t>(v)];
            rows += std::to_string(v) + ',' + std::to_string(from) + '\n';
        }
        outputs.push_back({map_path, std::move(rows)});
    }
    // What reading has changed must not pass unseen, unless standard output is taken.
    if (path != "-" && map_path != "-") outputs.push_back({"-", reading_text(*session)});
    return outputs;
}

}  // namespace polylap::tool

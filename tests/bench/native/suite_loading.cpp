#include "meshes.hpp"
#include "polylap/mesh/mesh_io.hpp"
#include "polylap/mesh/topology.hpp"
#include "suites.hpp"

namespace polylap::bench {

void run_loading(Bench& bench) {
    if (!bench.wants("loading")) return;
    for (const Index n : bench.sizes({25'000, 250'000})) {
        const PolygonMesh mesh = torus_of(n);
        const std::string text = opened(write_mesh(mesh, MeshFormat::obj));
        bench.measure("loading", "torus", mesh.vertex_count(),
                      {{"OBJ",
                        [&](Record& record) {
                            record.add("file", "MB", static_cast<double>(text.size()) / 1e6);
                            const PolygonMesh read = record.time("read and validate", [&] {
                                return opened(read_mesh(std::as_bytes(std::span(text)), MeshFormat::obj));
                            });
                            const Topology topology =
                                record.time("topology", [&] { return build_topology(*read.connectivity()); });
                            require(read.face_count() == mesh.face_count() && topology.component_count == 1,
                                    "another mesh was read than was written");
                        },
                        7}});
    }
}

}  // namespace polylap::bench

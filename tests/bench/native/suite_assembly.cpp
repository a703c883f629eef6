#include "meshes.hpp"
#include "naive_assembly.hpp"
#include "suites.hpp"
#include "systems.hpp"

namespace polylap::bench {
namespace {

/// The same faces, moved a little.
PolygonMesh moved(const PolygonMesh& mesh, int times) {
    const Eigen::Index rows = mesh.vertex_count();
    Points points = mesh.positions();
    points.col(2) += 0.01 * times * Vector::LinSpaced(rows, 0, 1);
    return opened(mesh.with_positions(std::move(points)));
}

/// With a connectivity of its own, of which nothing is known yet.
PolygonMesh fresh(const PolygonMesh& mesh) {
    return opened(PolygonMesh::create(mesh.positions(), mesh.connectivity()->offsets, mesh.connectivity()->corners));
}

void require_same(const OperatorMatrices& a, const OperatorMatrices& b) {
    require((a.stiffness - b.stiffness).norm() <= 1e-9 * b.stiffness.norm() &&
                (a.mass - b.mass).norm() <= 1e-9 * b.mass.norm(),
            "two assemblies of the same matrices differ");
}

}  // namespace

void run_assembly(Bench& bench) {
    if (!bench.wants("assembly")) return;
    for (const Index n : bench.sizes({25'000, 250'000})) {
        const PolygonMesh mesh = torus_of(n);
        const auto ours = [&](const char* id, OperatorMatrices (*naive)(const PolygonMesh&)) {
            require_same(build(mesh, id), naive(mesh));
            return [&mesh, id](Record& record) {
                const PolygonMesh unknown = fresh(mesh);
                OperatorMatrices matrices = record.time("first", [&] { return build(unknown, id); });
                const std::vector<PolygonMesh> others{moved(unknown, 1), moved(unknown, 2), moved(unknown, 3)};
                record.quickest("repeated", others, [&](const PolygonMesh& each) {
                    opened(rebuild_operator(each, {.id = id, .values = {}}, matrices));
                });
                const OperatorMatrices expected = build(fresh(others.back()), id);
                require_same(matrices, expected);
            };
        };
        const auto theirs = [&](OperatorMatrices (*naive)(const PolygonMesh&)) {
            return [&mesh, naive](Record& record) { record.time("first", [&] { return naive(mesh); }); };
        };
        bench.measure("assembly", "torus", mesh.vertex_count(),
                      {{full_operator, ours(full_operator, naive_edge_gradient), 5},
                       {cotan_operator, ours(cotan_operator, naive_projected_cotan), 5},
                       {"SVD per face, triplets", theirs(naive_edge_gradient), 5},
                       {"cotangents, triplets", theirs(naive_projected_cotan), 5}});
    }
}

}  // namespace polylap::bench

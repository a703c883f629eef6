#include "meshes.hpp"
#include "naive_assembly.hpp"
#include "suites.hpp"
#include "systems.hpp"

namespace polylap::bench {
namespace {

/// The same faces, moved a little; the same ones for the same round.
PolygonMesh moved(const PolygonMesh& mesh, int round) {
    const Eigen::Index rows = mesh.vertex_count();
    Points points = mesh.positions();
    points.col(2) += 0.01 * (round + 1) * Vector::LinSpaced(rows, 0, 1);
    return opened(mesh.with_positions(std::move(points)));
}

/// With a connectivity of its own, of which nothing is known yet.
PolygonMesh fresh(const PolygonMesh& mesh) {
    return opened(PolygonMesh::create(mesh.positions(), mesh.connectivity()->offsets, mesh.connectivity()->corners));
}

void require_same(const SparseMatrix& a, const SparseMatrix& b) {
    require((a - b).norm() <= 1e-9 * b.norm(), "two assemblies of the same matrix differ");
}

}  // namespace

void run_assembly(Bench& bench) {
    if (!bench.wants("assembly")) return;
    for (const Index n : bench.sizes({25'000, 250'000})) {
        const PolygonMesh mesh = torus_of(n);
        const int passes = 3;
        const auto ours = [&](const char* id, OperatorMatrices (*naive)(const PolygonMesh&)) {
            return [&mesh, id, naive](Record& record) {
                double best = 0;
                for (int pass = 0; pass < passes; ++pass) {
                    const PolygonMesh unknown = fresh(mesh);
                    const double start = Record::cpu_ms();
                    const OperatorMatrices matrices = build(unknown, id);
                    const double spent = Record::cpu_ms() - start;
                    best = pass == 0 ? spent : std::min(best, spent);
                }
                record.add("first", "ms", best);
                OperatorMatrices last = build(mesh, id);
                for (int pass = 0; pass < passes; ++pass) {
                    const PolygonMesh other = moved(mesh, pass);
                    const double start = Record::cpu_ms();
                    last = build(other, id);
                    const double spent = Record::cpu_ms() - start;
                    best = pass == 0 ? spent : std::min(best, spent);
                }
                record.add("repeated", "ms", best);
                const OperatorMatrices expected = naive(moved(mesh, passes - 1));
                require_same(last.stiffness, expected.stiffness);
                require_same(last.mass, expected.mass);
            };
        };
        const auto theirs = [&](OperatorMatrices (*naive)(const PolygonMesh&)) {
            return [&mesh, naive](Record& record) { record.quickest("first", 2, [&] { return naive(mesh); }); };
        };
        bench.measure("assembly", "torus", mesh.vertex_count(),
                      {{full_operator, ours(full_operator, naive_edge_gradient)},
                       {cotan_operator, ours(cotan_operator, naive_projected_cotan)},
                       {"SVD per face, triplets", theirs(naive_edge_gradient)},
                       {"cotangents, triplets", theirs(naive_projected_cotan)}});
    }
}

}  // namespace polylap::bench

#include "meshes.hpp"
#include "polylap/solve/dirichlet.hpp"
#include "polylap/solve/pinned_problem.hpp"
#include "suites.hpp"
#include "systems.hpp"

namespace polylap::bench {
namespace {

/// Ten pins all over the mesh, and one more.
std::vector<Index> pins_of(const PolygonMesh& mesh) {
    std::vector<Index> pins(11);
    for (std::size_t k = 0; k < pins.size(); ++k)
        pins[k] = static_cast<Index>(k * 7919 * static_cast<std::size_t>(mesh.vertex_count()) / 100'003);
    return pins;
}

Vector heights(const PolygonMesh& mesh, std::span<const Index> pins, double factor) {
    Vector values(static_cast<Eigen::Index>(pins.size()));
    for (std::size_t k = 0; k < pins.size(); ++k)
        values[static_cast<Eigen::Index>(k)] = factor * mesh.position(pins[k]).z();
    return values;
}

/// The first ten pins, one more, and other values at all of them.
void pin(const PolygonMesh& mesh, const SparseMatrix& stiffness, Record& record) {
    const std::vector<Index> pins = pins_of(mesh);
    const auto ten = std::span(pins).first(10);
    auto problem =
        opened(record.time("first ten pins", [&] { return PinnedProblem::create(stiffness, mesh.positions()); }));
    opened(record.time("first ten pins", [&] { return problem.solve(ten, heights(mesh, ten, 1)); }));
    opened(record.time("new pin", [&] { return problem.solve(pins, heights(mesh, pins, 1)); }));
    const Vector u = opened(record.time("drag", [&] { return problem.solve(pins, heights(mesh, pins, 2)); }));
    const auto eliminated = opened(DirichletProblem::create(stiffness, pins));
    const Vector expected = opened(eliminated.solve(heights(mesh, pins, 2)));
    require((u - expected).norm() <= 1e-9 * expected.norm(), "pins and elimination find different functions");
}

void eliminate(const PolygonMesh& mesh, const SparseMatrix& stiffness, Record& record) {
    const std::vector<Index> pins = pins_of(mesh);
    const auto ten = std::span(pins).first(10);
    const auto solve = [&](const char* metric, std::span<const Index> fixed) {
        return record.time(metric, [&] {
            auto problem =
                opened(DirichletProblem::create(stiffness, fixed, Structure::positive_semidefinite, mesh.positions()));
            opened(problem.solve(heights(mesh, fixed, 1)));
            return problem;
        });
    };
    solve("first ten pins", ten);
    const auto problem = solve("new pin", pins);
    opened(record.time("drag", [&] { return problem.solve(heights(mesh, pins, 2)); }));
}

}  // namespace

void run_pins(Bench& bench) {
    if (!bench.wants("pins")) return;
    for (const Index n : bench.sizes({10'000, 100'000, 250'000})) {
        const PolygonMesh mesh = torus_of(n);
        const SparseMatrix stiffness = build(mesh).stiffness;
        bench.measure("pins", "torus", mesh.vertex_count(),
                      {{"polylap", [&](Record& record) { pin(mesh, stiffness, record); }},
                       {"elimination", [&](Record& record) { eliminate(mesh, stiffness, record); }}});
    }
}

}  // namespace polylap::bench

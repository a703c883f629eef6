#include "meshes.hpp"
#include "polylap/apply/smoothing.hpp"
#include "polylap/solve/spd_factor.hpp"
#include "solve/lower_triangle.hpp"
#include "suites.hpp"
#include "systems.hpp"

namespace polylap::bench {
namespace {

using Choice = SmootherOptions::Choice;

int iterations(const ImplicitSmoother& smoother) {
    const SmoothingSolve solve = smoother.last_solve();
    return solve.solver == SmoothingSolver::conjugate_gradients ? solve.iterations : 0;
}

/// A first step, when nothing is known, and the next one on the moved surface with its own S and M, as when they are
/// rebuilt before each step; there the analysis of the factor is known.
void smooth(const PolygonMesh& mesh, double time, Choice choice, Record& record) {
    const OperatorMatrices matrices = build(mesh);
    const SmootherOptions options{.choice = choice, .positions = &mesh.positions()};
    auto smoother =
        record.time("first step", [&] { return opened(ImplicitSmoother::create(matrices, time, options)); });
    const Points moved = record.time("first step", [&] { return opened(smoother.step(mesh.positions())); });
    record.add("first iterations", "", iterations(smoother));
    std::shared_ptr<const SpdAnalysis> known = smoother.analysis();
    if (known == nullptr) {
        const SparseMatrix system = matrices.mass + time * matrices.stiffness;
        known = opened(SpdAnalysis::create(lower_triangle(system), mesh.positions()));
    }
    const SmootherOptions later{.choice = choice, .positions = &mesh.positions(), .known = {&known, 1}};
    const OperatorMatrices next = build(opened(mesh.with_positions(moved)));
    opened(record.time("next step", [&] { return smoother.update(next, time, later); }));
    const Points twice = record.time("next step", [&] { return opened(smoother.step(moved)); });
    record.add("iterations", "", iterations(smoother));
    require_solves(next.mass + time * next.stiffness, twice, next.mass * moved);
}

}  // namespace

void run_iterative(Bench& bench) {
    if (!bench.wants("iterative")) return;
    for (const Index n : bench.sizes({10'000, 100'000, 250'000})) {
        const PolygonMesh mesh = torus_of(n);
        const double edge = squared_edge(mesh);
        for (const auto& [name, factor] : {std::pair{"t = 0.001 h²", 0.001},
                                           {"t = 0.01 h²", 0.01},
                                           {"t = 0.1 h²", 0.1},
                                           {"t = h²", 1.0},
                                           {"t = 10 h²", 10.0},
                                           {"t = 100 h²", 100.0}}) {
            const auto by = [&, t = factor * edge](Choice choice) {
                return [&mesh, t, choice](Record& record) { smooth(mesh, t, choice, record); };
            };
            const std::string item = name;
            bench.measure("iterative", "torus", mesh.vertex_count(),
                          {{item + ", factor", by(Choice::direct), 2},
                           {item + ", conjugate gradients", by(Choice::iterative), 2},
                           {item + ", automatic", by(Choice::automatic), 2}});
        }
    }
}

}  // namespace polylap::bench

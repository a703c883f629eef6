#include "meshes.hpp"
#include "naive_assembly.hpp"
#include "polylap/apply/smoothing.hpp"
#include "polylap/mesh/topology.hpp"
#include "polylap/solve/dirichlet.hpp"
#include "polylap/solve/eigenpairs.hpp"
#include "polylap/solve/spd_factor.hpp"
#include "suites.hpp"
#include "systems.hpp"

#include <Eigen/SparseCholesky>

namespace polylap::bench {
namespace {

int rounds_at(Index n) {
    return n > 500'000 ? 2 : 3;
}

/// Assemble, analyse, factor, solve for three coordinates, by the parts of the library.
void smooth_by_parts(const PolygonMesh& mesh, double time, Record& record) {
    const OperatorMatrices matrices = record.time("assemble", [&] { return build(mesh); });
    const SparseMatrix a = record.time("sum", [&] { return SparseMatrix(matrices.mass + time * matrices.stiffness); });
    SpdFactor factor;
    opened(record.time("analyse", [&] { return factor.analyse(a, mesh.positions()); }));
    opened(record.time("numeric", [&] { return factor.factor(a); }));
    const Matrix b = matrices.mass * mesh.positions();
    const Matrix x = record.time("solve 3", [&] { return opened(factor.solve(b)); });
    require_solves(a, x, b);
}

void smooth(const PolygonMesh& mesh, double time, Record& record) {
    const Points moved = record.time("total", [&] {
        const OperatorMatrices matrices = build(mesh);
        ImplicitSmoother smoother = opened(ImplicitSmoother::create(matrices, time, {.positions = &mesh.positions()}));
        return opened(smoother.step(mesh.positions()));
    });
    require(moved.allFinite(), "smoothing gave no positions");
}

/// What it takes with assembly and solver as they are commonly put together.
void smooth_commonly(const PolygonMesh& mesh, double time, Record& record) {
    const Matrix moved = record.time("total", [&] {
        const OperatorMatrices matrices = naive_edge_gradient(mesh);
        const Eigen::SimplicialLDLT<SparseMatrix> ldlt(matrices.mass + time * matrices.stiffness);
        return Matrix(ldlt.solve(Matrix(matrices.mass * mesh.positions())));
    });
    require(moved.allFinite(), "smoothing gave no positions");
}

void run_smoothing(Bench& bench) {
    if (!bench.wants("smoothing")) return;
    for (const Index n : bench.sizes({10'000, 100'000, 250'000, 1'000'000})) {
        const PolygonMesh mesh = torus_of(n);
        const double time = squared_edge(mesh);
        const int rounds = rounds_at(n);
        std::vector<Contender> contenders{
            {"polylap", [&](Record& record) { smooth(mesh, time, record); }, rounds},
            {"polylap, by parts", [&](Record& record) { smooth_by_parts(mesh, time, record); }, rounds}};
        if (n <= 250'000) {
            contenders.push_back({"SVD per face, triplets, Eigen LDLT, AMD",
                                  [&](Record& record) { smooth_commonly(mesh, time, record); }, 2});
        }
        bench.measure("smoothing", "torus", mesh.vertex_count(), contenders);
    }
}

/// Assemble, factor what is free, solve.
void harmonic(const PolygonMesh& mesh, const std::vector<Index>& fixed, Record& record) {
    Matrix values(static_cast<Eigen::Index>(fixed.size()), 1);
    for (std::size_t i = 0; i < fixed.size(); ++i)
        values(static_cast<Eigen::Index>(i), 0) = mesh.position(fixed[i]).x();
    const double start = Record::cpu_ms();
    const OperatorMatrices matrices = record.time("assemble", [&] { return build(mesh); });
    const auto problem = record.time("factor", [&] {
        return opened(DirichletProblem::create(matrices.stiffness, fixed, matrices.structure, mesh.positions()));
    });
    const Matrix u = record.time("solve 1", [&] { return opened(problem.solve(values)); });
    record.add("total", "ms", Record::cpu_ms() - start);
    Vector free = Vector::Ones(mesh.vertex_count());
    for (const Index v : fixed)
        free[v] = 0;
    const Vector residual = free.asDiagonal() * Vector(matrices.stiffness * u.col(0));
    require(residual.norm() <= 1e-9 * matrices.stiffness.norm() * u.norm(), "the function is not harmonic");
}

void run_harmonic(Bench& bench) {
    if (!bench.wants("harmonic")) return;
    for (const Index n : bench.sizes({10'000, 100'000, 250'000, 1'000'000})) {
        const int rounds = rounds_at(n);
        const PolygonMesh torus = torus_of(n);
        bench.measure("harmonic", "torus", torus.vertex_count(),
                      {{"two pins", [&](Record& record) {
                            harmonic(torus, {0, torus.vertex_count() / 2}, record);
                        }}});
        const PolygonMesh grid = grid_of(n);
        const std::vector<Index> boundary = build_topology(*grid.connectivity()).boundary_vertices;
        bench.measure("harmonic", "grid", grid.vertex_count(),
                      {{"boundary", [&](Record& record) { harmonic(grid, boundary, record); }, rounds}});
    }
}

void run_spectrum(Bench& bench) {
    if (!bench.wants("eigenpairs")) return;
    for (const Index n : bench.sizes({1000, 5000, 20'000})) {
        const PolygonMesh mesh = torus_of(n);
        const SparseMatrix stiffness = build(mesh).stiffness;
        bench.measure(
            "eigenpairs", "torus", mesh.vertex_count(),
            {{"polylap", [&](Record& record) {
                  const Eigenpairs pairs =
                      record.time("30 pairs", [&] { return opened(lowest_eigenpairs(stiffness, 30)); });
                  const Matrix residual = stiffness * pairs.vectors - pairs.vectors * pairs.values.asDiagonal();
                  require(residual.colwise().norm().maxCoeff() <= 1e-8 * stiffness.norm(), "the eigenpairs are none");
              }}});
    }
}

}  // namespace

void run_steps(Bench& bench) {
    run_smoothing(bench);
    run_harmonic(bench);
    run_spectrum(bench);
}

}  // namespace polylap::bench

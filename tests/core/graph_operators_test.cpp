// The three operators that see edges but no lengths.

#include <cmath>

#include <Eigen/Eigenvalues>

#include "operator_cases.hpp"
#include "polylap/operators/normalized_graph.hpp"
#include "polylap/operators/tutte.hpp"
#include "polylap/operators/umbrella.hpp"

namespace polylap::test {
namespace {

/// The degrees and the adjacency of the edges, once each.
std::pair<Vector, Matrix> graph(const PolygonMesh& mesh) {
    Matrix adjacency = Matrix::Zero(mesh.vertex_count(), mesh.vertex_count());
    for (const Edge& e : build_topology(*mesh.connectivity()).edges) {
        adjacency(e.v0, e.v1) = adjacency(e.v1, e.v0) = 1;
    }
    return {adjacency.rowwise().sum(), adjacency};
}

TEST(GraphOperators, EqualTheirDefinitions) {
    for (const auto& [name, mesh] : zoo()) {
        const auto [degree, adjacency] = graph(mesh);
        const Matrix d = degree.asDiagonal();
        Vector inverse = Vector::Zero(degree.size());
        for (Eigen::Index v = 0; v < degree.size(); ++v) {
            if (degree[v] > 0) inverse[v] = 1 / degree[v];
        }
        const Vector root = inverse.cwiseSqrt();
        const Matrix laplacian = d - adjacency;
        EXPECT_EQ((Matrix(get(umbrella_stiffness(mesh))) - laplacian).cwiseAbs().maxCoeff(), 0) << name;
        EXPECT_LE((Matrix(get(tutte_stiffness(mesh))) - inverse.asDiagonal() * laplacian).cwiseAbs().maxCoeff(), 1e-15)
            << name;
        EXPECT_LE((Matrix(get(normalized_graph_stiffness(mesh))) - root.asDiagonal() * laplacian * root.asDiagonal())
                      .cwiseAbs()
                      .maxCoeff(),
                  1e-15)
            << name;
    }
}

// Three faces share edge 0–1, which has weight 1 like any other.
TEST(GraphOperators, AnEdgeOfManyFacesCountsOnce) {
    const Matrix s(get(umbrella_stiffness(specimen("three-quads-on-an-edge"))));
    EXPECT_EQ(s(0, 1), -1);
    EXPECT_EQ(s(0, 0), 4);
}

// On a path of corners of degrees 2 and 3 (two triangles with a common edge) by hand.
TEST(GraphOperators, TwoTriangles) {
    const auto mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
    Matrix tutte(4, 4);
    tutte << 3, -1, -1, -1, -1.5, 3, -1.5, 0, -1, -1, 3, -1, -1.5, 0, -1.5, 3;
    EXPECT_LE((Matrix(get(tutte_stiffness(mesh))) - tutte / 3).cwiseAbs().maxCoeff(), 1e-15);
    const double w = 1 / std::sqrt(6.0);
    Matrix normalised(4, 4);
    normalised << 1, -w, -1.0 / 3, -w, -w, 1, -w, 0, -1.0 / 3, -w, 1, -w, -w, 0, -w, 1;
    EXPECT_LE((Matrix(get(normalized_graph_stiffness(mesh))) - normalised).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(GraphOperators, SpectraLieBetweenZeroAndTwo) {
    for (const auto& [name, mesh] : zoo()) {
        if (mesh.vertex_count() > 120) continue;
        const Matrix s(get(normalized_graph_stiffness(mesh)));
        const Eigen::SelfAdjointEigenSolver<Matrix> solver(s);
        EXPECT_GE(solver.eigenvalues()[0], -1e-14) << name;
        EXPECT_LE(solver.eigenvalues().maxCoeff(), 2 + 1e-14) << name;
        EXPECT_LE((s * graph(mesh).first.cwiseSqrt()).norm(), 1e-13) << "D^½ 1 is in the kernel of " << name;
        // Similar matrices: D^½ (I - D⁻¹A) D^-½ = I - D^-½ A D^-½.
        const Eigen::VectorXcd tutte = Matrix(get(tutte_stiffness(mesh))).eigenvalues();
        EXPECT_LE(tutte.imag().cwiseAbs().maxCoeff(), 1e-6) << name;
        EXPECT_NEAR(tutte.real().sum(), solver.eigenvalues().sum(), 1e-10) << name;
    }
}

// A face without area is no obstacle: only the mass looks at areas.
TEST(GraphOperators, TakeDegenerateFaces) {
    const auto line = make_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
    EXPECT_EQ(get(build_operator(line, {"umbrella", {}})).mass.sum(), 0);
    EXPECT_EQ(get(umbrella_stiffness(line)).coeff(0, 2), -1);
}

TEST(GraphOperators, AreCancelled) {
    const auto& mesh = specimen("grid-2x2");
    const auto cancelled = [](const Result<SparseMatrix>& r) { return !r && r.error().code == ErrorCode::cancelled; };
    Ticks ticks;
    ticks.stop_at = 1;
    EXPECT_TRUE(cancelled(umbrella_stiffness(mesh, ticks.monitor())));
    EXPECT_TRUE(cancelled(tutte_stiffness(mesh, ticks.monitor())));
    EXPECT_TRUE(cancelled(normalized_graph_stiffness(mesh, ticks.monitor())));
}

}  // namespace
}  // namespace polylap::test

// The measured properties: figures by hand, plain dense computations over the zoo, and the claims of the table.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "polylap/apply/properties.hpp"
#include "polylap/mesh/shapes.hpp"
#include "polylap/solve/dirichlet.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using Verdict = Measurement::Verdict;

const Measurement& find(const PropertyReport& report, PropertyClaim PropertyClaims::*claim) {
    for (const Measurement& m : report.measurements) {
        if (m.property->claim == claim) return m;
    }
    throw std::runtime_error("not measured at all");
}

PropertyReport check(const PolygonMesh& mesh, const OperatorMatrices& matrices) {
    return get(check_properties(mesh, build_topology(*mesh.connectivity()), matrices));
}
PropertyReport check(const PolygonMesh& mesh, const OperatorSpec& spec) {
    return check(mesh, get(build_operator(mesh, spec)));
}

OperatorSpec stabilised(double lambda) {
    return {"alexa-wardetzky", {lambda}};
}

// --- by hand ---

// At the centre each square adds λ to two edges and ½ - λ to a diagonal: S_cc = 6 for λ = 1, and a corner of the grid
// has the weight -½.
TEST(Properties, OfTwoByTwoSquares) {
    const PolygonMesh grid = get(make_grid(2, 2));
    const PropertyReport report = check(grid, stabilised(1));
    EXPECT_EQ(report.negative_ordered, 16);
    EXPECT_EQ(report.negative_pairs, 8);
    const Measurement& positive = find(report, &PropertyClaims::positive_weights);
    EXPECT_EQ(positive.verdict, Verdict::fails);
    EXPECT_NEAR(positive.value, 0.5, 1e-14);
    EXPECT_NE(positive.text.find("16 of 40 ordered pairs (8 unordered pairs)"), std::string::npos) << positive.text;
    const Measurement& maximum = find(report, &PropertyClaims::maximum_principle);
    EXPECT_EQ(maximum.verdict, Verdict::fails);
    EXPECT_NEAR(maximum.value, 1.0 / 12, 1e-14);
    ASSERT_EQ(maximum.vertices.size(), 2u);
    EXPECT_EQ(maximum.vertices[0], 4);
    EXPECT_EQ((std::set<Index>{0, 2, 6, 8}.count(maximum.vertices[1])), 1u);
    const Measurement& linear = find(report, &PropertyClaims::linear_precision);
    EXPECT_EQ(linear.verdict, Verdict::holds);
    EXPECT_NE(linear.text.find("1 flat inner vertex"), std::string::npos) << linear.text;
    EXPECT_EQ(report.components, 1);
    EXPECT_EQ(report.kernel_dimension, 1);
    EXPECT_TRUE(report.kernel_complete);
    EXPECT_LE((report.kernel_modes - Matrix::Constant(9, 1, 1.0 / 3)).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_NEAR(report.smallest_mass, 1.0 / 16, 1e-15);
    EXPECT_EQ((std::set<Index>{0, 2, 6, 8}.count(report.smallest_mass_vertex)), 1u);
    for (const auto claim : {&PropertyClaims::symmetric, &PropertyClaims::local, &PropertyClaims::positive_semidefinite,
                             &PropertyClaims::constants_in_kernel}) {
        EXPECT_EQ(find(report, claim).verdict, Verdict::holds);
        EXPECT_TRUE(find(report, claim).vertices.empty());
    }
}

// Herholz 2012: with 1 at one corner and 0 along the rest of the boundary, λ = 1 falls to -0.1147.
TEST(Properties, MaximumPrincipleOfEightByEightSquares) {
    const PolygonMesh grid = get(make_grid(8, 8));
    const OperatorMatrices matrices = get(build_operator(grid, stabilised(1)));
    const Topology topology = build_topology(*grid.connectivity());
    const Measurement worst = find(check(grid, matrices), &PropertyClaims::maximum_principle);
    EXPECT_EQ(worst.verdict, Verdict::fails);
    EXPECT_GE(worst.value, 0.1147 - 5e-5);
    ASSERT_EQ(worst.vertices.size(), 2u);
    const DirichletProblem problem = get(DirichletProblem::create(matrices.stiffness, topology.boundary_vertices));
    const auto fixed = static_cast<Eigen::Index>(topology.boundary_vertices.size());
    const Matrix u = get(problem.solve(Matrix::Identity(fixed, fixed)));
    EXPECT_NEAR(u.col(0).minCoeff(), -0.1147, 5e-5);
    EXPECT_NEAR(worst.value, std::max(-u.minCoeff(), u.maxCoeff() - 1), 1e-12);
    const auto source =
        std::find(topology.boundary_vertices.begin(), topology.boundary_vertices.end(), worst.vertices[1]) -
        topology.boundary_vertices.begin();
    const double there = u(worst.vertices[0], source);
    EXPECT_NEAR(worst.value, std::max(-there, there - 1), 1e-12);

    for (const OperatorSpec& spec : {stabilised(0.5), get(make_spec("planar", {}))}) {
        EXPECT_EQ(find(check(grid, spec), &PropertyClaims::maximum_principle).verdict, Verdict::holds) << spec.id;
    }
    const Measurement close = find(check(grid, stabilised(0.51)), &PropertyClaims::maximum_principle);
    EXPECT_EQ(close.verdict, Verdict::fails);
    EXPECT_GE(close.value, 0.003 - 5e-5);
}

// Each square adds λ to its edges and ½ - λ to its diagonals, hence with λ = 1 an edge of the cube has the weight 2, a
// diagonal -½ and a vertex S_ii = 3 · 2 - 3 · ½. Between opposite corners, the only ones spread over so few vertices,
// values stay in range: the other neighbours of a corner with 1 get 6/9.5.
TEST(Properties, MaximumPrincipleAroundOneVertexOfACube) {
    const PolygonMesh cube =
        make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                  {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
    const Measurement fails = find(check(cube, stabilised(1)), &PropertyClaims::maximum_principle);
    EXPECT_EQ(fails.verdict, Verdict::fails);
    EXPECT_NEAR(fails.value, 1.0 / 9, 1e-14);
    ASSERT_EQ(fails.vertices.size(), 2u);
    const Vector3 apart = cube.position(fails.vertices[0]) - cube.position(fails.vertices[1]);
    EXPECT_NEAR(apart.norm(), std::sqrt(2.0), 1e-14);
    EXPECT_EQ(fails.text, "pinned to 1 at vertex " + std::to_string(fails.vertices[1]) +
                              " and to 0 at the other neighbours of vertex " + std::to_string(fails.vertices[0]) +
                              ", a harmonic function is -0.111 there, the lowest of 48 pinned like this");
    // λ = ½ leaves the edges: 8 · 3 functions.
    const Measurement holds = find(check(cube, stabilised(0.5)), &PropertyClaims::maximum_principle);
    EXPECT_EQ(holds.verdict, Verdict::holds);
    EXPECT_NE(holds.text.find("none of 24 "), std::string::npos) << holds.text;
}

// Sixteen vertices spread over the torus see nothing of its 2048 negative weights, but each of them does harm.
TEST(Properties, MaximumPrincipleAroundOneVertexOfATorus) {
    const PolygonMesh torus = specimen("quad-torus-32x16-noisy");
    const OperatorMatrices matrices = get(build_operator(torus, stabilised(1)));
    const Measurement fails = find(check(torus, matrices), &PropertyClaims::maximum_principle);
    EXPECT_EQ(fails.verdict, Verdict::fails);
    ASSERT_EQ(fails.vertices.size(), 2u);
    const Index i = fails.vertices[0];
    const Index j = fails.vertices[1];
    const SparseMatrix& s = matrices.stiffness;
    EXPECT_NEAR(fails.value, s.coeff(i, j) / s.coeff(i, i), 1e-15);
    std::vector<Index> fixed;
    Vector values = Vector::Zero(torus.vertex_count() - 1);
    for (Index v = 0; v < torus.vertex_count(); ++v) {
        if (v == j) values[static_cast<Eigen::Index>(fixed.size())] = 1;
        if (v != i) fixed.push_back(v);
    }
    const Matrix u = get(get(DirichletProblem::create(s, fixed)).solve(values));
    EXPECT_NEAR(u(i, 0), -fails.value, 1e-14);
    EXPECT_LT(u(i, 0), -0.07);
}

TEST(Properties, KernelsWithoutStabilisation) {
    const auto kernel = [](const PolygonMesh& mesh) { return check(mesh, stabilised(0)).kernel_dimension; };
    EXPECT_EQ(kernel(get(make_grid(8, 8))), 2);
    EXPECT_EQ(kernel(get(make_torus(16, 8))), 2);
    EXPECT_EQ(kernel(get(make_torus(15, 9))), 1);
    EXPECT_EQ(kernel(get(make_torus(48, 32))), 2) << "beyond what is solved densely";
    // A planar face sees the two components of a gradient.
    for (const int n : {3, 4, 7, 12}) {
        EXPECT_EQ(kernel(make_face(regular_polygon(n))), n - 2);
    }
}

TEST(Properties, KernelModesBeginWithTheConstants) {
    const PropertyReport squares = check(get(make_grid(8, 8)), stabilised(0));
    ASSERT_EQ(squares.kernel_modes.cols(), 2);
    EXPECT_LE((squares.kernel_modes.col(0) - Vector::Constant(81, 1.0 / 9)).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LE((squares.kernel_modes.transpose() * squares.kernel_modes - Matrix::Identity(2, 2)).norm(), 1e-9);
    // The other one is the checkerboard without its mean.
    Vector board(81);
    for (Index v = 0; v < 81; ++v) {
        board[v] = v % 2 == 0 ? 1 : -1;
    }
    board.array() -= board.mean();
    EXPECT_NEAR(std::abs(squares.kernel_modes.col(1).dot(board.normalized())), 1, 1e-9);

    const PropertyReport two = check(specimen("two-components"), stabilised(1));
    EXPECT_EQ(two.components, 2);
    ASSERT_EQ(two.kernel_dimension, 2);
    for (Index k = 0; k < 2; ++k) {
        EXPECT_NEAR(two.kernel_modes.col(k).cwiseAbs().maxCoeff() * two.kernel_modes.col(k).sum(), 1, 1e-9);
    }
}

TEST(Properties, VerticesInNoFaceHaveNoPartInTheKernel) {
    const PropertyReport report = check(specimen("unreferenced-vertices"), stabilised(1));
    EXPECT_EQ(report.components, 1);
    EXPECT_EQ(report.kernel_dimension, 1);
    EXPECT_EQ(report.kernel_modes(0, 0), 0);
    EXPECT_EQ(report.kernel_modes(4, 0), 0);
    EXPECT_NEAR(report.kernel_modes(1, 0), 0.5, 1e-9);
    EXPECT_GT(report.smallest_mass, 0);
}

TEST(Properties, AKernelBeyondTheLimitIsSaidToBeIncomplete) {
    for (const int n : {66, 100, 400}) {
        const PropertyReport report = check(make_face(regular_polygon(n)), stabilised(0));
        EXPECT_EQ(report.kernel_dimension, kernel_limit) << n;
        EXPECT_EQ(report.kernel_complete, n == 66) << n;
        EXPECT_EQ(report.kernel_modes.cols(), kernel_limit) << n;
        EXPECT_EQ(std::isinf(report.condition), n != 66) << n;
    }
}

/// Two squares side by side and a stiffness of one's own.
struct TwoSquares {
    PolygonMesh mesh = get(make_grid(2, 1, 2, 1));
    OperatorMatrices matrices = get(build_operator(mesh, stabilised(0.5)));

    PropertyReport with(Index i, Index j, double change) {
        OperatorMatrices changed = matrices;
        changed.stiffness.coeffRef(i, j) += change;
        changed.stiffness.makeCompressed();
        changed.structure = Structure::general;
        return check(mesh, changed);
    }
};

TEST(Properties, NameTheOffendingPlace) {
    TwoSquares squares;
    const PropertyReport skew = squares.with(0, 1, 0.25);
    const Measurement& symmetric = find(skew, &PropertyClaims::symmetric);
    EXPECT_EQ(symmetric.verdict, Verdict::fails);
    EXPECT_EQ((std::set<Index>(symmetric.vertices.begin(), symmetric.vertices.end())), (std::set<Index>{0, 1}));
    const Measurement& constants = find(skew, &PropertyClaims::constants_in_kernel);
    EXPECT_EQ(constants.verdict, Verdict::fails);
    EXPECT_EQ(constants.vertices, std::vector<Index>{0});
    EXPECT_NEAR(constants.value, 0.25 / squares.matrices.stiffness.diagonal().maxCoeff(), 1e-14);

    const PropertyReport far = squares.with(0, 5, -0.25);  // opposite corners of the whole
    const Measurement& local = find(far, &PropertyClaims::local);
    EXPECT_EQ(local.verdict, Verdict::fails);
    EXPECT_EQ((std::set<Index>(local.vertices.begin(), local.vertices.end())), (std::set<Index>{0, 5}));
    EXPECT_NE(local.text.find("1 of 15 ordered pairs"), std::string::npos) << local.text;

    const PropertyReport low = squares.with(3, 3, -10);
    const Measurement& semidefinite = find(low, &PropertyClaims::positive_semidefinite);
    EXPECT_EQ(semidefinite.verdict, Verdict::fails);
    EXPECT_EQ(semidefinite.vertices, std::vector<Index>{3});
    EXPECT_LT(low.smallest_eigenvalue, -5);
    EXPECT_EQ(low.kernel_dimension, 0) << "the kernel of an indefinite S is that of S, not all below zero";

    const PropertyReport bent = [] {
        const PolygonMesh grid = get(make_grid(4, 4));
        OperatorMatrices m = get(build_operator(grid, stabilised(1)));
        m.stiffness.coeffRef(12, 12) += 1;
        m.stiffness.coeffRef(12, 13) -= 1;
        m.structure = Structure::general;
        return check(grid, m);
    }();
    EXPECT_EQ(find(bent, &PropertyClaims::linear_precision).verdict, Verdict::fails);
    EXPECT_EQ(find(bent, &PropertyClaims::linear_precision).vertices, std::vector<Index>{12});
}

TEST(Properties, SayWhyTheyAreNotMeasured) {
    const PropertyReport face = check(make_face(regular_polygon(5)), stabilised(1));
    const Measurement& maximum = find(face, &PropertyClaims::maximum_principle);
    EXPECT_EQ(maximum.verdict, Verdict::not_measured);
    EXPECT_EQ(maximum.text, "every vertex lies on the boundary");
    EXPECT_EQ(find(face, &PropertyClaims::linear_precision).verdict, Verdict::not_measured);
    const PropertyReport sphere = check(specimen("hexagon-sphere-2"), stabilised(1));
    EXPECT_EQ(find(sphere, &PropertyClaims::linear_precision).text, "no inner vertex has surroundings in one plane");
}

TEST(Properties, RefuseWhatDoesNotFit) {
    const PolygonMesh grid = get(make_grid(2, 2));
    const auto other = get(build_operator(get(make_grid(3, 2)), stabilised(1)));
    const auto result = check_properties(grid, build_topology(*grid.connectivity()), other);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::bad_argument);
}

TEST(Properties, TellProgressAndStopWhenTold) {
    const PolygonMesh torus = get(make_torus(40, 30));
    const Topology topology = build_topology(*torus.connectivity());
    const OperatorMatrices matrices = get(build_operator(torus, stabilised(1)));
    Ticks all;
    ASSERT_TRUE(check_properties(torus, topology, matrices, all.monitor()));
    EXPECT_TRUE(all.rise());
    EXPECT_EQ(all.fractions.back(), 1);
    ASSERT_GE(all.fractions.size(), 10u);
    for (std::size_t stop = 1; stop <= all.fractions.size(); stop += 3) {
        Ticks some;
        some.stop_at = stop;
        const auto stopped = check_properties(torus, topology, matrices, some.monitor());
        ASSERT_FALSE(stopped) << stop;
        EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
        EXPECT_EQ(some.fractions.size(), stop);
    }
}

// Too many functions to solve for: the sample says so, and still finds what is wrong.
TEST(Properties, SampleTheMaximumPrincipleOfLargeMeshes) {
    const PolygonMesh grid = get(make_grid(90, 90));
    const Measurement fails = find(check(grid, stabilised(1)), &PropertyClaims::maximum_principle);
    EXPECT_EQ(fails.verdict, Verdict::fails);
    EXPECT_NE(fails.text.find("(a sample)"), std::string::npos) << fails.text;
    EXPECT_GE(fails.value, 0.1);
    const Measurement holds = find(check(grid, stabilised(0.5)), &PropertyClaims::maximum_principle);
    EXPECT_EQ(holds.verdict, Verdict::holds) << holds.text;
}

TEST(Properties, AgreeWithTheReferenceFile) {
    const auto bytes = read_bytes("operators.json");
    const auto* text = reinterpret_cast<const char*>(bytes.data());
    int compared = 0;
    for (const auto& entry : nlohmann::json::parse(text, text + bytes.size())) {
        const PolygonMesh mesh = load_mesh(entry["mesh"]);
        const std::pair<const char*, OperatorSpec> settings[] = {
            {"alexa-wardetzky", stabilised(1)},
            {"alexa-wardetzky-unstabilised", stabilised(0)},
            {"planar", get(make_spec("planar", {}))},
        };
        for (const auto& [name, spec] : settings) {
            const PropertyReport report = check(mesh, spec);
            const auto& figures = entry["operators"][name];
            EXPECT_EQ(report.negative_ordered, figures["negative"].get<Index>()) << entry["mesh"] << name;
            EXPECT_EQ(report.kernel_dimension, figures["kernel_dimension"].get<Index>()) << entry["mesh"] << name;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 24);
}

}  // namespace
}  // namespace polylap::test

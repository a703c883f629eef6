#include "polylap/solve/dirichlet.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/LU>

#include "polylap/mesh/shapes.hpp"
#include "polylap/operators/operator.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

SparseMatrix stiffness(const PolygonMesh& mesh, const char* id, std::vector<double> values = {}) {
    return get(build_operator(mesh, {id, std::move(values)})).stiffness;
}

/// By elimination of a dense matrix: rows of fixed vertices say u = value. Nothing where u is not unique.
std::optional<Matrix> eliminate(const SparseMatrix& s, const std::vector<Index>& fixed, const Matrix& values) {
    Matrix a(s);
    Matrix b = Matrix::Zero(s.rows(), values.cols());
    for (std::size_t k = 0; k < fixed.size(); ++k) {
        a.row(fixed[k]).setZero();
        a(fixed[k], fixed[k]) = 1;
        b.row(fixed[k]) = values.row(static_cast<Eigen::Index>(k));
    }
    const Eigen::FullPivLU<Matrix> lu(a);
    if (!lu.isInvertible()) return std::nullopt;
    return Matrix(lu.solve(b));
}

TEST(Dirichlet, EqualsDenseElimination) {
    for (const auto& [name, mesh] : zoo()) {
        if (mesh.vertex_count() > 90 || name == "unreferenced-vertices") continue;
        for (const OperatorInfo* info : operators()) {
            const auto built = build_operator(mesh, {info->id, {}});
            if (!built) continue;  // not for this mesh
            const SparseMatrix& s = built->stiffness;
            std::vector<Index> fixed{mesh.vertex_count() - 1, 0};  // in no order
            for (Index v = 4; v + 1 < mesh.vertex_count(); v += 7) {
                fixed.push_back(v);
            }
            Matrix values(static_cast<Eigen::Index>(fixed.size()), 2);
            for (Eigen::Index k = 0; k < values.rows(); ++k) {
                values.row(k) << std::sin(2.0 * static_cast<double>(k)), static_cast<double>(k);
            }
            const auto expected = eliminate(s, fixed, values);
            if (!expected) continue;
            const Matrix u = get(get(DirichletProblem::create(s, fixed, built->structure)).solve(values));
            EXPECT_LE((u - *expected).cwiseAbs().maxCoeff(), 1e-9 * values.cwiseAbs().maxCoeff())
                << name << ", " << info->id;
            for (std::size_t k = 0; k < fixed.size(); ++k) {
                EXPECT_EQ(u.row(fixed[k]), values.row(static_cast<Eigen::Index>(k)));
            }
        }
    }
}

TEST(Dirichlet, FactorsOnceForManyValues) {
    const SparseMatrix s = stiffness(specimen("grid-5x3"), operators().front()->id);
    const std::vector<Index> fixed{0, 5, 20};
    const auto problem = get(DirichletProblem::create(s, fixed));
    const Matrix a = Vector::LinSpaced(3, 1, 2);
    const Matrix b = Vector::LinSpaced(3, -4, 0);
    const Matrix sum = get(problem.solve(a + 2 * b));
    EXPECT_LE((sum - get(problem.solve(a)) - 2 * get(problem.solve(b))).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LE((get(problem.solve(Matrix::Constant(3, 1, 5))).array() - 5).abs().maxCoeff(), 1e-12);
}

// Edge midpoints of the 2×2 grid fixed to 1, corners to 0. S at the centre sums four squares: diagonal 4 (½ + λ), to
// each midpoint -2λ, to each corner λ - ½, so u = 4 · 2λ / (2 + 4λ) = 4λ/(1 + 2λ). Planar, cut by any diagonal: the
// five-point star, u = 1.
TEST(Dirichlet, TheCentreOfTwoByTwoSquares) {
    const auto grid = get(make_grid(2, 2, 2, 2));
    const std::vector<Index> fixed{0, 1, 2, 3, 5, 6, 7, 8};
    Vector values(8);
    values << 0, 1, 0, 1, 1, 0, 1, 0;
    for (const double lambda : {0.25, 0.5, 1.0, 2.0, 10.0}) {
        const auto problem = get(DirichletProblem::create(stiffness(grid, "alexa-wardetzky", {lambda}), fixed));
        EXPECT_NEAR(get(problem.solve(values))(4, 0), 4 * lambda / (1 + 2 * lambda), 1e-14) << lambda;
    }
    for (const double rule : {0.0, 1.0, 2.0, 3.0}) {
        const auto problem = get(DirichletProblem::create(stiffness(grid, "planar", {rule}), fixed));
        EXPECT_NEAR(get(problem.solve(values))(4, 0), 1, 1e-14) << rule;
    }
}

// One corner of the 8×8 unit grid has 1, the rest of the boundary 0: weights < 0 give values below 0 inside.
TEST(Dirichlet, TheMaximumPrincipleFailsWithNegativeWeights) {
    const auto grid = get(make_grid(8, 8));
    const auto fixed = build_topology(*grid.connectivity()).boundary_vertices;
    Vector values = Vector::Zero(static_cast<Eigen::Index>(fixed.size()));
    ASSERT_EQ(fixed[0], 0);
    values[0] = 1;
    const auto least = [&](const char* id, std::vector<double> parameters) {
        return get(get(DirichletProblem::create(stiffness(grid, id, std::move(parameters)), fixed)).solve(values))
            .minCoeff();
    };
    EXPECT_NEAR(least("alexa-wardetzky", {1}), -0.1147, 5e-5);
    EXPECT_NEAR(least("alexa-wardetzky", {0.51}), -0.0030, 5e-5);
    EXPECT_NEAR(least("alexa-wardetzky", {0.5}), 0, 1e-15);
    EXPECT_NEAR(least("planar", {}), 0, 1e-15);
}

TEST(Dirichlet, EachComponentNeedsAFixedVertex) {
    const auto& mesh = specimen("two-components");  // vertices 0–11 and 12–16
    const SparseMatrix s = stiffness(mesh, operators().front()->id);
    const auto both = get(DirichletProblem::create(s, std::vector<Index>{3, 14}));
    const Matrix u = get(both.solve(Eigen::Vector2d(7, -2)));
    EXPECT_LE((u.topRows(12).array() - 7).abs().maxCoeff(), 1e-12);
    EXPECT_LE((u.bottomRows(5).array() + 2).abs().maxCoeff(), 1e-12);

    const auto expect_unconstrained = [&](std::vector<Index> fixed, Index element) {
        const auto problem = DirichletProblem::create(s, fixed);
        ASSERT_FALSE(problem.ok());
        EXPECT_EQ(problem.error().code, ErrorCode::unconstrained_component);
        EXPECT_EQ(problem.error().element, element);
        EXPECT_NE(problem.error().message.find(std::to_string(element)), std::string::npos) << problem.error().message;
    };
    expect_unconstrained({3}, 12);
    expect_unconstrained({16, 13}, 0);
    expect_unconstrained({}, 0);
}

TEST(Dirichlet, UnreferencedVerticesAreNobodys) {
    const auto& mesh = specimen("unreferenced-vertices");  // 0 and 4 in no face
    for (const OperatorInfo* info : operators()) {
        const auto matrices = get(build_operator(mesh, {info->id, {}}));
        const auto problem =
            get(DirichletProblem::create(matrices.stiffness, std::vector<Index>{1, 4}, matrices.structure));
        const Matrix u = get(problem.solve(Eigen::Vector2d(3, 8)));
        EXPECT_TRUE(std::isnan(u(0, 0)));
        EXPECT_EQ(u(4, 0), 8);
        if (info->claims.constants_in_kernel.where != Claim::yes) continue;
        for (const Index v : {1, 2, 3, 5}) {
            EXPECT_NEAR(u(v, 0), 3, 1e-13);
        }
    }
}

TEST(Dirichlet, EverythingFixed) {
    const SparseMatrix s = stiffness(specimen("regular-4"), operators().front()->id);
    const Matrix u =
        get(get(DirichletProblem::create(s, std::vector<Index>{2, 0, 3, 1})).solve(Eigen::Vector4d(1, 2, 3, 4)));
    EXPECT_EQ(u.col(0), Eigen::Vector4d(2, 4, 1, 3));
}

TEST(Dirichlet, RefusesBadVerticesAndValues) {
    const SparseMatrix s = stiffness(specimen("grid-2x2"), operators().front()->id);
    const auto expect_refused = [&](std::vector<Index> fixed, const char* word) {
        const auto problem = DirichletProblem::create(s, fixed);
        ASSERT_FALSE(problem.ok());
        EXPECT_EQ(problem.error().code, ErrorCode::bad_argument);
        EXPECT_NE(problem.error().message.find(word), std::string::npos) << problem.error().message;
    };
    expect_refused({0, 9}, "9");
    expect_refused({-1}, "-1");
    expect_refused({2, 5, 2}, "2");
    expect_refused({std::numeric_limits<Index>::max()}, "2147483647");

    const auto problem = get(DirichletProblem::create(s, std::vector<Index>{0, 8}));
    for (const Matrix& values : {Matrix(Eigen::Vector3d(1, 2, 3)), Matrix(Matrix::Zero(1, 1)),
                                 Matrix(Eigen::Vector2d(0, nan)), Matrix(Eigen::Vector2d(infinity, 0))}) {
        const auto u = problem.solve(values);
        ASSERT_FALSE(u.ok());
        EXPECT_EQ(u.error().code, ErrorCode::bad_argument);
    }
}

// λ = 0 leaves the checkerboard of a grid in the kernel: with one vertex fixed there is no unique answer.
TEST(Dirichlet, SingularSystemsAreRefused) {
    const auto grid = get(make_grid(8, 8));
    const auto problem = DirichletProblem::create(stiffness(grid, "alexa-wardetzky", {0}), std::vector<Index>{0});
    ASSERT_FALSE(problem.ok());
    // Corners join only along diagonals there, so the graph falls into the two colours of the board.
    EXPECT_TRUE(problem.error().code == ErrorCode::not_positive_definite ||
                problem.error().code == ErrorCode::unconstrained_component);
    EXPECT_GE(problem.error().element, 0);
    EXPECT_LT(problem.error().element, grid.vertex_count());

    const auto noisy =
        specimen("quad-torus-32x16-noisy");  // here the graph is connected, and the kernel has dimension 2
    const auto singular = DirichletProblem::create(stiffness(noisy, "alexa-wardetzky", {0}), std::vector<Index>{0});
    ASSERT_FALSE(singular.ok());
    EXPECT_EQ(singular.error().code, ErrorCode::not_positive_definite);
    EXPECT_GE(singular.error().element, 0);
    EXPECT_LT(singular.error().element, noisy.vertex_count());
}

TEST(DirichletProblem, RefusesWhatDoesNotFit) {
    const auto rectangular = DirichletProblem::create(SparseMatrix(5, 3), std::vector<Index>{0});
    ASSERT_FALSE(rectangular.ok());
    EXPECT_EQ(rectangular.error().code, ErrorCode::bad_argument);

    // Finite values whose difference is none have no solution in double precision.
    const auto problem =
        get(DirichletProblem::create(stiffness(specimen("grid-2x2"), "planar"), std::vector<Index>{0, 8}));
    const auto overflow = problem.solve(Vector{{-1.7e308, 1.7e308}});
    if (overflow.ok()) {
        EXPECT_TRUE(overflow->allFinite());
    } else {
        EXPECT_EQ(overflow.error().code, ErrorCode::bad_argument);
    }
}

// A walker on a path who goes right with probability p, left otherwise: u_i = p u_{i+1} + (1 - p) u_{i-1}. For p = ½
// the solution is linear, else (gambler's ruin) u_i = (1 - r^i) / (1 - r^n) with r = (1 - p) / p.
TEST(DirichletProblem, OfARandomWalkOnAPath) {
    constexpr Index n = 12;
    for (const double p : {0.5, 0.6, 0.25}) {
        SparseMatrix walk(n + 1, n + 1);
        for (Index i = 0; i <= n; ++i) {  // reflected at the ends: rows of fixed vertices must not matter
            walk.insert(i, i) = 1;
            if (i > 0) walk.insert(i, i - 1) = i < n ? p - 1 : -1;
            if (i < n) walk.insert(i, i + 1) = i > 0 ? -p : -1;
        }
        walk.makeCompressed();
        const auto problem = get(DirichletProblem::create(walk, std::vector<Index>{n, 0}, Structure::general));
        const Matrix u = get(problem.solve(Eigen::Vector2d(1, 0)));
        const double r = (1 - p) / p;
        for (Index i = 0; i <= n; ++i) {
            const double expected = p == 0.5 ? i / 12.0 : (1 - std::pow(r, i)) / (1 - std::pow(r, n));
            EXPECT_NEAR(u(i, 0), expected, 1e-13) << p << ", " << i;
        }
    }
}

// 0 → 1 → 2 ← 3: an arrow is an entry of the row it leaves.
TEST(DirichletProblem, FollowsRowsNotColumns) {
    Matrix s = Matrix::Identity(5, 5);
    s(0, 1) = s(1, 2) = s(3, 2) = -1;
    s(4, 4) = 0;  // in no equation
    const auto problem = get(DirichletProblem::create(s.sparseView(), std::vector<Index>{2}, Structure::general));
    const Matrix u = get(problem.solve(Vector::Constant(1, 6)));
    for (const Index v : {0, 1, 2, 3}) {
        EXPECT_NEAR(u(v, 0), 6, 1e-15);
    }
    EXPECT_TRUE(std::isnan(u(4, 0)));

    const auto expect_open = [&](std::vector<Index> fixed, Index vertex) {
        const auto open = DirichletProblem::create(s.sparseView(), fixed, Structure::general);
        ASSERT_FALSE(open.ok());
        EXPECT_EQ(open.error().code, ErrorCode::unconstrained_component);
        EXPECT_EQ(open.error().element, vertex);
        EXPECT_NE(open.error().message.find("vertex " + std::to_string(vertex)), std::string::npos);
    };
    expect_open({0}, 1);     // 1 depends on 2 only, which depends on nothing
    expect_open({0, 1}, 2);  // so does 3
    s(4, 4) = 0;
    s(3, 4) = -1;  // 4 occurs in an equation, but has none of its own
    expect_open({2}, 4);
}

TEST(DirichletProblem, NamesAVertexThatItsEquationsLeaveOpen) {
    Matrix s = Matrix::Identity(6, 6);
    s(1, 0) = -1;  // decides 1
    s(2, 0) = s(5, 0) = -1;
    s(2, 5) = s(5, 2) = 1;  // decides only the sum of 2 and 5
    s(3, 0) = s(4, 0) = -1;
    const auto problem = DirichletProblem::create(s.sparseView(), std::vector<Index>{0}, Structure::general);
    ASSERT_FALSE(problem.ok());
    EXPECT_EQ(problem.error().code, ErrorCode::not_positive_definite);
    if (problem.error().element >= 0) {
        EXPECT_TRUE(problem.error().element == 2 || problem.error().element == 5) << problem.error().message;
        EXPECT_NE(problem.error().message.find("vertex " + std::to_string(problem.error().element)), std::string::npos);
    }
}

}  // namespace
}  // namespace polylap::test

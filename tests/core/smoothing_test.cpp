#include "polylap/apply/smoothing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include <Eigen/LU>

#include "polylap/apply/noise.hpp"
#include "polylap/mesh/shapes.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

OperatorMatrices build(const PolygonMesh& mesh, const OperatorInfo* info) {
    return get(build_operator(mesh, {info->id, {}}));
}

TEST(ImplicitSmoother, EqualsADenseSolve) {
    for (const auto& [name, mesh] : zoo()) {
        if (mesh.vertex_count() > 90 || name == "unreferenced-vertices") continue;
        for (const OperatorInfo* info : operators()) {
            const auto built = build_operator(mesh, {info->id, {}});
            if (!built) continue;  // not for this mesh
            const auto& m = *built;
            if (m.mass.diagonal().minCoeff() <= 0) continue;
            for (const double factor : {1e-3, 0.1, 10.0}) {
                const double time = factor * m.mass.sum();
                const Points moved = get(get(ImplicitSmoother::create(m, time)).step(mesh.positions()));
                const Matrix a = Matrix(m.mass) + time * Matrix(m.stiffness);
                const Matrix expected = a.fullPivLu().solve(m.mass * Matrix(mesh.positions()));
                EXPECT_LE((moved - expected).cwiseAbs().maxCoeff(), 1e-10 * bounding_size(mesh))
                    << name << ", " << info->id;
            }
        }
    }
}

TEST(ImplicitSmoother, KeepsTheCentreAndLowersTheEnergy) {
    const auto& mesh = specimen("torus-10x7-noisy");
    for (const OperatorInfo* info : operators()) {
        const PropertyClaims& claims = info->claims;
        if (claims.positive_semidefinite.where != Claim::yes || claims.constants_in_kernel.where != Claim::yes)
            continue;
        const auto m = build(mesh, info);
        if (m.structure != Structure::positive_semidefinite) continue;
        auto smoother = get(ImplicitSmoother::create(m, 0.01));
        const auto energy = [&](const Points& x) { return (x.transpose() * (m.stiffness * x)).trace(); };
        Points x = mesh.positions();
        const Eigen::RowVector3d centre = Eigen::RowVectorXd::Ones(x.rows()) * (m.mass * x);
        for (int k = 0; k < 5; ++k) {
            const Points next = get(smoother.step(x));
            EXPECT_LT(energy(next), energy(x));
            EXPECT_LE((Eigen::RowVectorXd::Ones(x.rows()) * (m.mass * next) - centre).norm(), 1e-12 * m.mass.sum());
            x = next;
        }
    }
}

TEST(ImplicitSmoother, VerticesInNoFaceStay) {
    const auto& mesh = specimen("unreferenced-vertices");
    for (const OperatorInfo* info : operators()) {
        for (const double scale : {1e-6, 1.0, 1e6}) {
            const auto scaled = get(mesh.with_positions(scale * mesh.positions()));
            const Points moved =
                get(get(ImplicitSmoother::create(build(scaled, info), 0.3 * scale * scale)).step(scaled.positions()));
            for (const Index v : {0, 4}) {
                EXPECT_LE((moved.row(v) - scaled.positions().row(v)).norm(), 1e-15 * scaled.positions().norm());
            }
            EXPECT_GT((moved.row(3) - scaled.positions().row(3)).norm(), 0.01 * scale);
        }
    }
}

TEST(ImplicitSmoother, UpdateIsTheSameAsCreate) {
    const auto torus = get(make_torus(8, 6));
    const auto grid = get(make_grid(4, 5));
    ImplicitSmoother smoother = get(ImplicitSmoother::create(build(torus, operators().front()), 0.1));
    const auto expect_equal = [&](const PolygonMesh& mesh, const OperatorInfo* info, double time) {
        check(smoother.update(build(mesh, info), time));
        const Points expected = get(get(ImplicitSmoother::create(build(mesh, info), time)).step(mesh.positions()));
        EXPECT_LE((get(smoother.step(mesh.positions())) - expected).cwiseAbs().maxCoeff(), 1e-14);
    };
    expect_equal(torus, operators().front(), 0.5);                                 // other time
    expect_equal(get(add_normal_noise(torus, 0.2, 1)), operators().front(), 0.5);  // other values
    expect_equal(torus, operators().back(), 0.5);                                  // other pattern
    expect_equal(grid, operators().back(), 0.01);                                  // other size
}

using Choice = SmootherOptions::Choice;

// What both leave is far below what anybody could see, for steps from nothing to nearly flat.
TEST(ImplicitSmoother, SolversAgree) {
    for (const auto& [name, mesh] : zoo()) {
        for (const OperatorInfo* info : operators()) {
            const auto built = build_operator(mesh, {info->id, {}});
            if (!built || built->mass.diagonal().minCoeff() < 0) continue;
            for (const double time_h2 : {1e-6, 1e-3, 0.1, 1.0, 30.0, 1e3}) {
                const double time = time_h2 * built->mass.sum() / mesh.vertex_count();
                auto direct = ImplicitSmoother::create(*built, time, {.choice = Choice::direct});
                auto iterative = ImplicitSmoother::create(*built, time, {.choice = Choice::iterative});
                ASSERT_EQ(direct.ok(), iterative.ok()) << name << ", " << info->id;
                if (!direct) continue;  // mass of 0
                const Points expected = get(direct->step(mesh.positions()));
                const Points moved = get(iterative->step(mesh.positions()));
                EXPECT_LE((moved - expected).cwiseAbs().maxCoeff(), 1e-9 * bounding_size(mesh))
                    << name << ", " << info->id << ", " << time_h2;
                const bool definite = built->structure == Structure::positive_semidefinite;
                EXPECT_EQ(direct->last_solve().solver == SmoothingSolver::cholesky || !definite, true);
                if (definite && time_h2 <= 1) {
                    EXPECT_EQ(iterative->last_solve().solver, SmoothingSolver::conjugate_gradients)
                        << name << ", " << info->id << ", " << time_h2;
                }
                if (!definite) {
                    EXPECT_NE(iterative->last_solve().solver, SmoothingSolver::conjugate_gradients);
                }
            }
        }
    }
}

PolygonMesh large_torus() {
    return get(add_normal_noise(get(make_torus(70, 60)), 0.3, 5));
}
double squared_edge(const OperatorMatrices& m) {
    return m.mass.sum() / static_cast<double>(m.mass.rows());
}

TEST(ImplicitSmoother, ChoosesTheCheaperSolver) {
    const PolygonMesh mesh = large_torus();
    const auto m = build(mesh, operators().front());
    const auto solve_with = [&](double time_h2, SmootherOptions options) {
        auto smoother = get(ImplicitSmoother::create(m, time_h2 * squared_edge(m), options));
        get(smoother.step(mesh.positions()));
        return smoother.last_solve();
    };
    const auto small = solve_with(0.01, {});
    EXPECT_EQ(small.solver, SmoothingSolver::conjugate_gradients);
    EXPECT_GT(small.iterations, 0);
    EXPECT_LT(small.iterations, 20);
    const auto large = solve_with(1e4, {});
    EXPECT_EQ(large.solver, SmoothingSolver::cholesky);
    EXPECT_EQ(large.iterations, 0);
    EXPECT_EQ(solve_with(1, {}).solver, SmoothingSolver::conjugate_gradients);
    EXPECT_EQ(solve_with(1, {.steps = 1000}).solver, SmoothingSolver::cholesky) << "the factor serves all steps";
    EXPECT_EQ(solve_with(0.01, {.choice = Choice::direct}).solver, SmoothingSolver::cholesky);
    EXPECT_EQ(solve_with(30, {.choice = Choice::iterative}).solver, SmoothingSolver::conjugate_gradients);
    EXPECT_EQ(solver_name(small.solver), "conjugate-gradients");
    EXPECT_EQ(solver_name(large.solver), "cholesky");
    EXPECT_EQ(solver_name(SmoothingSolver::lu), "lu");
}

TEST(ImplicitSmoother, FactorsOnceEnoughStepsWereIterated) {
    const PolygonMesh mesh = large_torus();
    const auto m = build(mesh, operators().front());
    const double time = 0.01 * squared_edge(m);
    auto smoother = get(ImplicitSmoother::create(m, time));
    auto direct = get(ImplicitSmoother::create(m, time, {.choice = Choice::direct}));
    Points x = mesh.positions();
    Points expected = x;
    int steps = 0;
    while (steps < 200) {
        x = get(smoother.step(x));
        expected = get(direct.step(expected));
        ++steps;
        if (smoother.last_solve().solver == SmoothingSolver::cholesky) break;
    }
    EXPECT_GT(steps, 1);
    EXPECT_LT(steps, 200) << "never worth a factor";
    EXPECT_LE((x - expected).cwiseAbs().maxCoeff(), 1e-9);
    get(smoother.step(x));
    EXPECT_EQ(smoother.last_solve().solver, SmoothingSolver::cholesky);
    check(smoother.update(m, time));  // another system, as far as the smoother knows; the analysis is no cost any more
    ASSERT_NE(smoother.analysis(), nullptr);
    EXPECT_TRUE(smoother.analysis()->fits(SparseMatrix(m.stiffness.triangularView<Eigen::Lower>())));
}

TEST(ImplicitSmoother, LeavesTheFactorToTheFirstStep) {
    const PolygonMesh mesh = large_torus();
    ImplicitSmoother smoother;
    {
        auto m = build(mesh, operators().front());
        check(smoother.update_later(m, 1e4 * squared_edge(m)));
        m.stiffness.coeffs().setZero();  // nobody reads it any more
    }
    EXPECT_TRUE(smoother.needs_factor());
    EXPECT_EQ(smoother.bytes(), 0);
    const auto m = build(mesh, operators().front());
    ImplicitSmoother direct = get(ImplicitSmoother::create(m, 1e4 * squared_edge(m)));
    EXPECT_FALSE(direct.needs_factor());
    EXPECT_EQ(get(smoother.step(mesh.positions())), get(direct.step(mesh.positions())));
    EXPECT_FALSE(smoother.needs_factor());
    EXPECT_GE(smoother.bytes(), 8 * smoother.analysis()->factor_entries());

    const std::array known{std::shared_ptr<const SpdAnalysis>(), smoother.analysis()};
    ImplicitSmoother sharing;
    check(sharing.update_later(m, 2e4 * squared_edge(m), {.known = known}));
    EXPECT_EQ(sharing.analysis(), smoother.analysis());
    check(sharing.update_later(m, 0.1 * squared_edge(m), {.known = known}));
    EXPECT_FALSE(sharing.needs_factor()) << "conjugate gradients serve";
}

// A new system each step: the first ones are iterated, until an analysis would have paid for itself.
TEST(ImplicitSmoother, AnalysesOnceEnoughSystemsWereIterated) {
    const PolygonMesh mesh = large_torus();
    const auto m = build(mesh, operators().front());
    ImplicitSmoother smoother;
    std::vector<SmoothingSolver> solvers;
    for (int k = 0; k < 60; ++k) {
        check(smoother.update(m, 12 * squared_edge(m)));
        get(smoother.step(mesh.positions()));
        solvers.push_back(smoother.last_solve().solver);
    }
    EXPECT_EQ(solvers.front(), SmoothingSolver::conjugate_gradients);
    EXPECT_EQ(solvers.back(), SmoothingSolver::cholesky);
    EXPECT_TRUE(std::is_sorted(solvers.rbegin(), solvers.rend())) << "never back";
}

// Conjugate gradients find out only while they run; the factor names the vertex.
TEST(ImplicitSmoother, FallsBackToAFactor) {
    const PolygonMesh mesh = large_torus();
    auto m = build(mesh, operators().front());
    const double time = squared_edge(m);
    const Index v = 1234;
    SparseMatrix::InnerIterator it(m.stiffness, v);
    while (it.row() == v)
        ++it;
    const auto other = static_cast<Index>(it.row());
    m.stiffness.coeffRef(other, v) = m.stiffness.coeffRef(v, other) = 50;  // the diagonal stays positive
    for (const auto choice : {Choice::automatic, Choice::iterative}) {
        auto smoother = get(ImplicitSmoother::create(m, time, {.choice = choice}));
        const auto step = smoother.step(mesh.positions());
        ASSERT_FALSE(step.ok());
        EXPECT_EQ(step.error().code, ErrorCode::not_positive_definite);
        EXPECT_TRUE(step.error().element == v || step.error().element == other) << step.error().element;
        EXPECT_NE(step.error().message.find("vertex " + std::to_string(step.error().element)), std::string::npos);
    }
}

TEST(ImplicitSmoother, FarFromTheOriginIsTheSame) {
    const PolygonMesh mesh = large_torus();
    const auto m = build(mesh, operators().front());
    const Eigen::RowVector3d far(1e7, -2e7, 3e7);
    const Points there = mesh.positions().rowwise() + far;
    for (const auto choice : {Choice::direct, Choice::iterative}) {
        auto smoother = get(ImplicitSmoother::create(m, squared_edge(m), {.choice = choice}));
        const Points here = get(smoother.step(mesh.positions()));
        const Points moved = get(smoother.step(there)).rowwise() - far;
        EXPECT_LE((moved - here).cwiseAbs().maxCoeff(), 1e-7);  // the digits that coordinates have there
        EXPECT_GT((here - mesh.positions()).cwiseAbs().maxCoeff(), 1e-3);
    }
}

TEST(ImplicitSmoother, TicksRiseAndStop) {
    const PolygonMesh mesh = large_torus();
    const auto m = build(mesh, operators().front());
    const double time = 30 * squared_edge(m);
    for (const auto choice : {Choice::direct, Choice::iterative}) {
        const SmootherOptions options{.choice = choice};
        Ticks creating, stepping;
        auto smoother = get(ImplicitSmoother::create(m, time, options, creating.monitor()));
        get(smoother.step(mesh.positions(), stepping.monitor()));
        EXPECT_TRUE(creating.rise());
        creating.stop_at = 1;
        const auto not_created = ImplicitSmoother::create(m, time, options, creating.monitor());
        ASSERT_FALSE(not_created.ok());
        EXPECT_EQ(not_created.error().code, ErrorCode::cancelled);
        if (choice == Choice::direct) continue;
        EXPECT_TRUE(stepping.rise());
        Ticks ticks;
        ticks.stop_at = stepping.fractions.size();
        const auto stopped = smoother.step(mesh.positions(), ticks.monitor());
        ASSERT_FALSE(stopped.ok());
        EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
        EXPECT_TRUE(smoother.step(mesh.positions()).ok()) << "a stopped step can be made again";
    }
}

TEST(ImplicitSmoother, HasNothingToSolveBeforeAnUpdate) {
    ImplicitSmoother smoother;
    const auto m = build(specimen("grid-2x2"), operators().front());
    const auto refused = [&] {
        const auto step = smoother.step(specimen("grid-2x2").positions());
        return !step && step.error().code == ErrorCode::bad_argument;
    };
    EXPECT_TRUE(refused());
    check(smoother.update(m, 1));
    EXPECT_FALSE(refused());
    EXPECT_FALSE(smoother.update(m, -1).ok());
    EXPECT_TRUE(refused());
}

TEST(ImplicitSmoother, RefusesBadTimes) {
    const auto m = build(specimen("grid-2x2"), operators().front());
    for (const double time : {0.0, -1.0, nan, infinity, -infinity}) {
        const auto smoother = ImplicitSmoother::create(m, time);
        ASSERT_FALSE(smoother.ok()) << time;
        EXPECT_EQ(smoother.error().code, ErrorCode::bad_argument);
        EXPECT_NE(smoother.error().message.find("time"), std::string::npos) << smoother.error().message;
    }
}

TEST(ImplicitSmoother, RefusesMassesAndMatricesThatDoNotFit) {
    auto m = build(specimen("grid-2x2"), operators().front());
    for (const double bad : {0.0, -0.1, nan}) {
        OperatorMatrices broken = m;
        broken.mass.coeffRef(5, 5) = bad;
        const auto smoother = ImplicitSmoother::create(broken, 1);
        ASSERT_FALSE(smoother.ok()) << bad;
        EXPECT_EQ(smoother.error().code, ErrorCode::mass_not_positive);
        EXPECT_EQ(smoother.error().element, 5);
        EXPECT_NE(smoother.error().message.find("vertex 5"), std::string::npos) << smoother.error().message;
    }
    OperatorMatrices indefinite = m;
    indefinite.stiffness.coeffRef(4, 4) = -100;
    const auto smoother = ImplicitSmoother::create(indefinite, 1);
    ASSERT_FALSE(smoother.ok());
    EXPECT_EQ(smoother.error().code, ErrorCode::not_positive_definite);
    EXPECT_GE(smoother.error().element, 0);
    EXPECT_LT(smoother.error().element, 9);

    auto good = get(ImplicitSmoother::create(m, 1));
    const auto step = good.step(Points::Zero(8, 3));
    ASSERT_FALSE(step.ok());
    EXPECT_EQ(step.error().code, ErrorCode::bad_argument);
    EXPECT_NE(step.error().message.find('8'), std::string::npos) << step.error().message;
}

TEST(ImplicitSmoother, GoesOnAfterARefusedUpdate) {
    const auto m = build(specimen("grid-2x2"), operators().front());
    ImplicitSmoother smoother = get(ImplicitSmoother::create(m, 0.2));
    EXPECT_FALSE(smoother.update(m, -1).ok());
    check(smoother.update(m, 0.2));
    EXPECT_EQ(get(smoother.step(specimen("grid-2x2").positions())),
              get(get(ImplicitSmoother::create(m, 0.2)).step(specimen("grid-2x2").positions())));
}

TEST(ImplicitSmoother, RefusesMatricesThatDoNotFitEachOther) {
    const auto m = build(specimen("grid-2x2"), operators().front());
    for (const auto& misfit : {OperatorMatrices{m.stiffness, SparseMatrix(8, 8)}, OperatorMatrices{m.stiffness, {}},
                               OperatorMatrices{SparseMatrix(9, 8), m.mass}}) {
        const auto smoother = ImplicitSmoother::create(misfit, 1);
        ASSERT_FALSE(smoother.ok());
        EXPECT_EQ(smoother.error().code, ErrorCode::bad_argument);
    }
    Points points = specimen("grid-2x2").positions();
    points(3, 1) = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(get(ImplicitSmoother::create(m, 1)).step(points).ok());
}

// Two vertices: x0' = x0 + t (x1' - x0'), and x1' = x1, which depends on nothing. With t = 3: x0' = (x0 + 3 x1) / 4.
TEST(ImplicitSmoother, OfAnOperatorThatIsNotSymmetric) {
    Matrix s(2, 2);
    s << 1, -1, 0, 0;
    const OperatorMatrices matrices{s.sparseView(), Matrix::Identity(2, 2).sparseView(), Structure::general};
    Points points(2, 3);
    points << 1, 2, 3, 5, -2, 7;
    const Points moved = get(get(ImplicitSmoother::create(matrices, 3)).step(points));
    EXPECT_LE((moved.row(0) - (points.row(0) + 3 * points.row(1)) / 4).norm(), 1e-15);
    EXPECT_LE((moved.row(1) - points.row(1)).norm(), 1e-15);

    s << -1, 1, 0, 0;  // 1 + t · (-1) = 0 for t = 1
    const OperatorMatrices backward{s.sparseView(), matrices.mass, Structure::general};
    const auto singular = ImplicitSmoother::create(backward, 1);
    ASSERT_FALSE(singular.ok());
    EXPECT_EQ(singular.error().code, ErrorCode::not_positive_definite);
    EXPECT_NE(singular.error().message.find("singular"), std::string::npos) << singular.error().message;
}

// Galerkin masses of a path: the constants stay, and the rest equals a dense solve; vertex 3 is in no face.
TEST(ImplicitSmoother, TakesSparseMasses) {
    Matrix s = Matrix::Zero(4, 4);
    s.topLeftCorner(3, 3) << 1, -1, 0, -1, 2, -1, 0, -1, 1;
    Matrix m = Matrix::Zero(4, 4);
    m.topLeftCorner(3, 3) << 2, 1, 0, 1, 4, 1, 0, 1, 2;
    Points points(4, 3);
    points << 0, 1, 2, 3, 1, 4, 5, 1, 9, 7, 7, 7;
    for (const auto structure : {Structure::positive_semidefinite, Structure::symmetric, Structure::general}) {
        const OperatorMatrices matrices{s.sparseView(), m.sparseView(), structure};
        const Points moved = get(get(ImplicitSmoother::create(matrices, 0.7)).step(points));
        Matrix a = m + 0.7 * s;
        Matrix b = m * Matrix(points);
        a(3, 3) = 1;
        b.row(3) = points.row(3);
        EXPECT_LE((moved - Matrix(a.fullPivLu().solve(b))).norm(), 1e-14);
        EXPECT_LE((moved.col(1).head(3).array() - 1).abs().maxCoeff(), 1e-15);
        EXPECT_EQ(moved.row(3), points.row(3));

        OperatorMatrices hollow = matrices;
        hollow.mass.coeffRef(1, 1) = -4;
        const auto refused = ImplicitSmoother::create(hollow, 0.7);
        ASSERT_FALSE(refused.ok());
        EXPECT_EQ(refused.error().code, ErrorCode::mass_not_positive);
        EXPECT_EQ(refused.error().element, 1);
    }
}

}  // namespace
}  // namespace polylap::test

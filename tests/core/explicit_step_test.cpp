#include "polylap/apply/explicit_step.hpp"

#include <gtest/gtest.h>

#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "zoo.hpp"

namespace polylap::test {
namespace {

Points in_x(const Vector& values) {
    Points points = Points::Zero(values.size(), 3);
    points.col(0) = values;
    return points;
}

TEST(ExplicitStability, EqualsADenseSolve) {
    int tried = 0;
    for (const auto& [name, mesh] : zoo()) {
        if (mesh.vertex_count() > 150 || name == "unreferenced-vertices") continue;
        for (const OperatorSpec& spec : all_specs()) {
            const auto m = build_operator(mesh, spec);
            if (!m) continue;
            const auto bound = explicit_stability(*m);
            if (!bound) {
                EXPECT_EQ(bound.error().code, ErrorCode::mass_not_positive) << name << ", " << spec_name(spec);
                continue;
            }
            const Matrix mass(m->mass);
            if (!(mass.diagonal().minCoeff() > 0)) continue;
            const Eigen::EigenSolver<Matrix> dense(mass.fullPivLu().solve(Matrix(m->stiffness)), false);
            const Vector values = dense.eigenvalues().real();
            ++tried;
            EXPECT_NEAR(bound->largest, values.maxCoeff(), 1e-5 * values.maxCoeff()) << name << ", " << spec_name(spec);
            EXPECT_LE(bound->largest, (1 + 1e-10) * values.maxCoeff());
            if (m->structure == Structure::positive_semidefinite) {
                EXPECT_EQ(bound->smallest, 0);
            } else if (values.minCoeff() < -1e-2 * values.maxCoeff()) {
                EXPECT_NEAR(bound->smallest, values.minCoeff(), 2e-3 * values.maxCoeff());
                EXPECT_EQ(bound->limit(), 0);
            }
        }
    }
    EXPECT_GT(tried, 200);
}

TEST(ExplicitStability, IsByWhatTheRoughestModeGrows) {
    for (const char* const name : {"torus-10x7-noisy", "grid-2x2"}) {
        const auto& mesh = specimen(name);
        for (const OperatorInfo* info : operators()) {
            const auto m = build_operator(mesh, {info->id, {}});
            if (!m || m->structure != Structure::positive_semidefinite) continue;
            const auto bound = get(explicit_stability(*m));
            const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> dense{Matrix(m->stiffness), Matrix(m->mass)};
            const Vector mode = dense.eigenvectors().rightCols(1);
            for (const double share : {0.1, 0.9, 1.1, 4.0}) {
                const double time = share * bound.limit();
                const Points moved = get(explicit_step(*m, time, in_x(mode))).points;
                EXPECT_LE((moved - bound.growth(time) * in_x(mode)).norm(), 1e-5 * share * mode.norm())
                    << name << ", " << info->id;
            }
        }
    }
}

TEST(ExplicitStep, StaysBoundedBelowTheLimitAndGrowsAboveIt) {
    const auto& mesh = specimen("torus-10x7-noisy");
    for (const OperatorInfo* info : operators()) {
        const auto m = build_operator(mesh, {info->id, {}});
        if (!m || m->structure == Structure::symmetric) continue;
        const auto bound = get(explicit_stability(*m));
        const auto after = [&](double share) {
            Points x = mesh.positions();
            for (int k = 0; k < 500; ++k)
                x = get(explicit_step(*m, share * bound.limit(), x)).points;
            return x.norm() / mesh.positions().norm();
        };
        EXPECT_LT(after(0.995), 1.1) << info->id;
        EXPECT_GT(after(1.05), 1e6) << info->id;
    }
}

TEST(ExplicitStep, SaysHowItWasSolved) {
    const PolygonMesh mesh = load_mesh("triangle-sphere-2");
    const auto lumped = get(build_operator(mesh, get(make_spec("cotan", {}))));
    EXPECT_EQ(get(explicit_step(lumped, 1e-3, mesh.positions())).solve.solver, SmoothingSolver::diagonal);
    EXPECT_EQ(solver_name(SmoothingSolver::diagonal), "diagonal");
    const std::vector<std::pair<std::string, std::string>> galerkin{{"mass", "galerkin"}};
    const auto sparse = get(build_operator(mesh, get(make_spec("cotan", galerkin))));
    const auto step = get(explicit_step(sparse, 1e-3, mesh.positions()));
    EXPECT_EQ(step.solve.solver, SmoothingSolver::conjugate_gradients);
    EXPECT_GT(step.solve.iterations, 0);
    const Matrix expected = Matrix(mesh.positions()) -
                            1e-3 * Matrix(sparse.mass).fullPivLu().solve(Matrix(sparse.stiffness * mesh.positions()));
    EXPECT_LE((step.points - expected).norm(), 1e-10);
}

TEST(ExplicitStep, RefusesWhatDoesNotFit) {
    const auto& mesh = specimen("grid-2x2");
    auto m = get(build_operator(mesh, {"planar", {}}));
    const auto code = [&](double time, const Points& points, std::vector<Index> fixed = {}) {
        const auto step = explicit_step(m, time, points, fixed);
        return step ? ErrorCode::cancelled : step.error().code;
    };
    Points broken = mesh.positions();
    broken(3, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(code(0, mesh.positions()), ErrorCode::bad_argument);
    EXPECT_EQ(code(-1, mesh.positions()), ErrorCode::bad_argument);
    EXPECT_EQ(code(std::numeric_limits<double>::infinity(), mesh.positions()), ErrorCode::bad_argument);
    EXPECT_EQ(code(1, broken), ErrorCode::bad_argument);
    EXPECT_EQ(code(1, Points::Zero(4, 3)), ErrorCode::bad_argument);
    EXPECT_EQ(code(1, mesh.positions(), {0, 9}), ErrorCode::bad_argument);
    EXPECT_EQ(code(1, mesh.positions(), {2, 2}), ErrorCode::bad_argument);
    EXPECT_EQ(explicit_stability(m, std::vector<Index>{-1}).error().code, ErrorCode::bad_argument);
    m.mass.coeffRef(5, 5) = -1;
    const auto step = explicit_step(m, 1, mesh.positions());
    ASSERT_FALSE(step.ok());
    EXPECT_EQ(step.error().code, ErrorCode::mass_not_positive);
    EXPECT_EQ(step.error().element, 5);
    EXPECT_EQ(explicit_stability(m).error().element, 5);
    EXPECT_TRUE(explicit_step(m, 1, mesh.positions(), std::vector<Index>{5}).ok()) << "its row is not asked for";
}

TEST(ExplicitStep, VerticesInNoFaceStay) {
    const auto& mesh = specimen("unreferenced-vertices");
    for (const OperatorInfo* info : operators()) {
        const auto m = get(build_operator(mesh, {info->id, {}}));
        const auto bound = get(explicit_stability(m));
        const Points moved = get(explicit_step(m, 0.5 * bound.limit(), mesh.positions())).points;
        for (const Index v : {0, 4})
            EXPECT_EQ(moved.row(v), mesh.positions().row(v));
        EXPECT_GT((moved.row(3) - mesh.positions().row(3)).norm(), 1e-3);
    }
}

}  // namespace
}  // namespace polylap::test

#include "polylap/solve/conjugate_gradients.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "polylap/mesh/shapes.hpp"
#include "polylap/solve/spd_factor.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

SparseMatrix sparse(const Matrix& dense) {
    SparseMatrix a = dense.sparseView();
    a.makeCompressed();
    return a;
}

Points points(std::initializer_list<double> values) {
    Points p(static_cast<Eigen::Index>(values.size() / 3), 3);
    std::copy(values.begin(), values.end(), p.data());
    return p;
}

/// Largest |b - Ax| / |b| of a column, with |b| = 0 only for exact solutions.
double residual(const SparseMatrix& a, const Points& b, const Points& x) {
    double worst = 0;
    for (int k = 0; k < 3; ++k) {
        const double left = (b.col(k) - a * x.col(k)).stableNorm();
        if (left > 0) worst = std::max(worst, left / b.col(k).stableNorm());
    }
    return worst;
}

/// M + tS of an operator on a torus, and M x of its points.
struct Problem {
    SparseMatrix a;
    Points b, start;
};
Problem smoothing_problem(double time_h2) {
    const auto mesh = get(make_torus(24, 14));
    const auto m = get(build_operator(mesh, {operators().front()->id, {}}));
    const double time = time_h2 * m.mass.sum() / mesh.vertex_count();
    SparseMatrix a = time * m.stiffness;
    a += m.mass;
    return {a, m.mass * mesh.positions(), mesh.positions()};
}

// 4 x + y = b0, x + 3 y = b1: for (1, 2) that is (1/11, 7/11), for (4, 1) it is (1, 0), for (0, 11) it is (-1, 4).
TEST(ConjugateGradients, SolvesByHand) {
    const SparseMatrix a = sparse((Matrix(2, 2) << 4, 1, 1, 3).finished());
    const auto solution = get(conjugate_gradients(a, points({1, 4, 0, 2, 1, 11}), Points::Zero(2, 3)));
    EXPECT_LE((solution.x - points({1.0 / 11, 1, -1, 7.0 / 11, 0, 4})).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_GE(solution.iterations, 1);
    EXPECT_LE(solution.iterations, 4);  // exact arithmetic takes 2
}

TEST(ConjugateGradients, NeedsNoIterationWhereTheGuessIsRight) {
    const SparseMatrix a = sparse((Matrix(2, 2) << 4, 1, 1, 3).finished());
    const Points x = points({1, 2, 3, 4, 5, 6});
    const auto solution = get(conjugate_gradients(a, a * x, x));
    EXPECT_EQ(solution.iterations, 0);
    EXPECT_EQ(solution.x, x);
}

TEST(ConjugateGradients, OfNothingIsNothing) {
    const auto solution = get(conjugate_gradients(SparseMatrix(0, 0), Points(0, 3), Points(0, 3)));
    EXPECT_EQ(solution.x.rows(), 0);
    EXPECT_EQ(solution.iterations, 0);
}

TEST(ConjugateGradients, ZerosHaveTheSolutionZero) {
    const auto [a, b, start] = smoothing_problem(1);
    Points flat = b;
    flat.col(1).setZero();
    const auto solution = get(conjugate_gradients(a, flat, start));
    EXPECT_TRUE((solution.x.col(1).array() == 0).all());
    EXPECT_LE(residual(a, flat, solution.x), residual_tolerance);
    const auto none = get(conjugate_gradients(a, Points::Zero(b.rows(), 3), start));
    EXPECT_TRUE((none.x.array() == 0).all());
    EXPECT_EQ(none.iterations, 0);
}

TEST(ConjugateGradients, EqualsCholesky) {
    int before = 0;
    for (const double time_h2 : {1e-4, 1e-2, 1.0, 100.0, 1e4}) {
        const auto [a, b, start] = smoothing_problem(time_h2);
        const auto solution = get(conjugate_gradients(a, b, start));
        SpdFactor factor;
        check(factor.factor(a));
        EXPECT_LE((solution.x - get(factor.solve(b))).cwiseAbs().maxCoeff(), 1e-11) << time_h2;
        EXPECT_LE(residual(a, b, solution.x), residual_tolerance) << time_h2;
        EXPECT_GT(solution.iterations, before) << "the condition grows with t";
        before = solution.iterations;
    }
}

// The slowest column decides how long it takes, and what the others have by then does not change.
TEST(ConjugateGradients, ColumnsDoNotDisturbEachOther) {
    const auto [a, b, start] = smoothing_problem(30);
    const auto all = get(conjugate_gradients(a, b, start));
    int most = 0;
    for (int k = 0; k < 3; ++k) {
        Points one = Points::Zero(b.rows(), 3);
        Points guess = one;
        one.col(k) = b.col(k);
        guess.col(k) = start.col(k);
        const auto alone = get(conjugate_gradients(a, one, guess));
        EXPECT_LE((alone.x.col(k) - all.x.col(k)).cwiseAbs().maxCoeff(), 1e-15) << k;
        most = std::max(most, alone.iterations);
    }
    EXPECT_EQ(all.iterations, most);

    Points uneven = b;
    uneven.col(2) = a * start.col(2);  // solved before it begins
    const auto solution = get(conjugate_gradients(a, uneven, start));
    EXPECT_EQ(solution.x.col(2), start.col(2));
    EXPECT_LE(residual(a, uneven, solution.x), residual_tolerance);
}

TEST(ConjugateGradients, TakeMatricesOfAnySize) {
    const auto [a, b, start] = smoothing_problem(1);
    const auto expected = get(conjugate_gradients(a, b, start));
    for (const double scale : {0x1p-600, 0x1p-30, 0x1p600}) {  // exact
        const auto scaled = get(conjugate_gradients(scale * a, scale * b, start));
        EXPECT_EQ(scaled.x, expected.x) << scale;
        EXPECT_EQ(scaled.iterations, expected.iterations) << scale;
        const auto moved = get(conjugate_gradients(a, scale * b, scale * start));
        EXPECT_EQ(moved.x, scale * expected.x) << scale;
    }
}

// A path: (S u)_i = Σ (u_i - u_j). Its kernel are the constants, and the sum of a right-hand side must be 0.
TEST(ConjugateGradients, SolveSingularSystemsThatHaveASolution) {
    const SparseMatrix path = sparse((Matrix(3, 3) << 1, -1, 0, -1, 2, -1, 0, -1, 1).finished());
    const auto solution = get(conjugate_gradients(path, points({1, 0, 2, 0, 1, -4, -1, -1, 2}), Points::Zero(3, 3)));
    const Points from_last = solution.x.rowwise() - solution.x.row(2);
    EXPECT_LE((from_last - points({2, 1, 0, 1, 1, -2, 0, 0, 0})).cwiseAbs().maxCoeff(), 1e-13);

    const auto none = conjugate_gradients(path, points({1, 0, 0, 0, 0, 0, 0, 0, 0}), Points::Zero(3, 3));
    ASSERT_FALSE(none.ok());
    EXPECT_TRUE(none.error().code == ErrorCode::not_converged || none.error().code == ErrorCode::not_positive_definite);
}

TEST(ConjugateGradients, RefuseWhatIsNotPositiveDefinite) {
    const Points b = points({1, 2, 3, 3, 1, 4});
    const auto refused = [&](const Matrix& a, std::int64_t element) {
        const auto solution = conjugate_gradients(sparse(a), b, Points::Zero(2, 3));
        ASSERT_FALSE(solution.ok());
        EXPECT_EQ(solution.error().code, ErrorCode::not_positive_definite);
        EXPECT_EQ(solution.error().element, element);
    };
    refused((Matrix(2, 2) << 1, 2, 2, 1).finished(), -1);  // eigenvalues -1 and 3
    refused((Matrix(2, 2) << 1, 2, 2, 0).finished(), 1);   // no diagonal entry
    refused((Matrix(2, 2) << -1, 0, 0, 1).finished(), 0);
    refused((Matrix(2, 2) << 1, 0, 0, std::numeric_limits<double>::quiet_NaN()).finished(), 1);
}

TEST(ConjugateGradients, EndWithoutNumbers) {
    for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        const Matrix a = (Matrix(2, 2) << 1, bad, bad, 1).finished();
        EXPECT_FALSE(conjugate_gradients(sparse(a), Points::Ones(2, 3), Points::Zero(2, 3)).ok()) << bad;
        const SparseMatrix identity = sparse(Matrix::Identity(2, 2));
        EXPECT_FALSE(conjugate_gradients(identity, Points::Constant(2, 3, bad), Points::Zero(2, 3)).ok()) << bad;
        EXPECT_FALSE(conjugate_gradients(identity, Points::Ones(2, 3), Points::Constant(2, 3, bad)).ok()) << bad;
    }
}

TEST(ConjugateGradients, EndWithoutConvergence) {
    const auto [a, b, start] = smoothing_problem(100);
    const auto few = conjugate_gradients(a, b, start, {.most_iterations = 7});
    ASSERT_FALSE(few.ok());
    EXPECT_EQ(few.error().code, ErrorCode::not_converged);
    EXPECT_NE(few.error().message.find('7'), std::string::npos) << few.error().message;
    const auto beyond_rounding = conjugate_gradients(a, b, start, {.tolerance = 1e-18});
    ASSERT_FALSE(beyond_rounding.ok());
    EXPECT_EQ(beyond_rounding.error().code, ErrorCode::not_converged);
}

TEST(ConjugateGradients, RefuseSizesThatDoNotFit) {
    const SparseMatrix a = sparse(Matrix::Identity(3, 3));
    const Points three = Points::Zero(3, 3);
    const Points two = Points::Zero(2, 3);
    SparseMatrix loose(3, 3);
    loose.insert(1, 1) = 1;
    ASSERT_FALSE(loose.isCompressed());
    for (const auto& solution :
         {conjugate_gradients(a, two, three), conjugate_gradients(a, three, two),
          conjugate_gradients(SparseMatrix(3, 2), three, three), conjugate_gradients(loose, three, three)}) {
        ASSERT_FALSE(solution.ok());
        EXPECT_EQ(solution.error().code, ErrorCode::bad_argument);
    }
}

TEST(ConjugateGradients, TickRiseAndStop) {
    const auto mesh = get(make_torus(150, 100));
    const auto m = get(build_operator(mesh, {operators().front()->id, {}}));
    SparseMatrix a = 0.1 * m.stiffness;
    a += m.mass;
    const Points b = m.mass * mesh.positions();
    Ticks all;
    get(conjugate_gradients(a, b, mesh.positions(), {}, all.monitor()));
    ASSERT_GT(all.fractions.size(), 3U);
    EXPECT_TRUE(all.rise());
    EXPECT_GT(all.fractions.back(), 0.5);
    for (std::size_t stop = 1; stop <= all.fractions.size(); ++stop) {
        Ticks ticks;
        ticks.stop_at = stop;
        const auto stopped = conjugate_gradients(a, b, mesh.positions(), {}, ticks.monitor());
        ASSERT_FALSE(stopped.ok());
        EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
        EXPECT_EQ(ticks.fractions.size(), stop);
    }
}

TEST(ConjugateGradients, AreTheSameEachTime) {
    const auto [a, b, start] = smoothing_problem(10);
    EXPECT_EQ(get(conjugate_gradients(a, b, start)).x, get(conjugate_gradients(a, b, start)).x);
}

}  // namespace
}  // namespace polylap::test

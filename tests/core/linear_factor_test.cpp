#include "polylap/solve/linear_factor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "polylap/mesh/shapes.hpp"
#include "polylap/operators/operator.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

SparseMatrix sparse(const Matrix& dense) {
    return dense.sparseView();
}

/// u_i minus the mean of its neighbours, at all vertices of a grid but the last, where u is given.
SparseMatrix random_walk(Index n) {
    const SparseMatrix s = get(build_operator(get(make_grid(n, n)), {"alexa-wardetzky", {0.5}})).stiffness;
    const Vector inverse = Vector(s.diagonal()).cwiseInverse();
    const SparseMatrix walk = inverse.asDiagonal() * s;
    return walk.topLeftCorner(walk.rows() - 1, walk.cols() - 1);
}

void expect_solves(const LinearFactor& factor, const Matrix& a) {
    Matrix x(a.rows(), 3);
    for (Eigen::Index k = 0; k < x.size(); ++k) {
        x.data()[k] = std::sin(1.7 * static_cast<double>(k));
    }
    EXPECT_LE((get(factor.solve(a * x)) - x).cwiseAbs().maxCoeff(), 1e-9);
}

void expect_singular(const SparseMatrix& a, Structure structure, Index row) {
    LinearFactor factor;
    const Status status = factor.factor(a, structure);
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().code, ErrorCode::not_positive_definite);
    if (row >= 0) {
        EXPECT_EQ(status.error().element, row) << status.error().message;
    }
    EXPECT_FALSE(factor.solve(Matrix::Zero(a.rows(), 1)).ok());
}

TEST(LinearFactor, SolvesWhatEachStructureAllows) {
    LinearFactor factor;
    Matrix definite(3, 3);
    definite << 2, -1, 0, -1, 2, -1, 0, -1, 2;
    Matrix indefinite(3, 3);  // no diagonal to pivot on
    indefinite << 0, 1, 2, 1, 0, 3, 2, 3, 0;
    Matrix general(3, 3);
    general << 0, 2, 0, 0, 0, -3, 5, 1, 1;
    for (const auto structure : {Structure::positive_semidefinite, Structure::symmetric, Structure::general}) {
        check(factor.factor(sparse(definite), structure));
        expect_solves(factor, definite);
    }
    expect_singular(sparse(indefinite), Structure::positive_semidefinite, -1);
    for (const auto structure : {Structure::symmetric, Structure::general}) {
        check(factor.factor(sparse(indefinite), structure));
        expect_solves(factor, indefinite);
    }
    check(factor.factor(sparse(general), Structure::general));
    expect_solves(factor, general);
    check(factor.factor(sparse(7 * general), Structure::general));  // the same pattern, other values
    expect_solves(factor, 7 * general);
}

TEST(LinearFactor, SolvesRandomWalksOfAnySizeAndScale) {
    LinearFactor factor;
    for (const Index n : {1, 2, 5, 30, 60}) {
        const SparseMatrix walk = random_walk(n);
        check(factor.factor(walk, Structure::general));
        const Vector x = Vector::LinSpaced(walk.rows(), -1, 1);
        EXPECT_LE((get(factor.solve(walk * x)) - x).cwiseAbs().maxCoeff(), 1e-10) << n;
    }
    // Rows of very different size are no near singularity.
    const SparseMatrix walk = random_walk(5);
    Vector scale(walk.rows());
    for (Index i = 0; i < scale.size(); ++i) {
        scale[i] = std::pow(10.0, (7 * i) % 41 - 20);
    }
    check(factor.factor(scale.asDiagonal() * walk, Structure::general));
    const Vector x = Vector::LinSpaced(walk.rows(), -1, 1);
    EXPECT_LE((get(factor.solve(scale.asDiagonal() * (walk * x))) - x).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(LinearFactor, RefusesSingularMatrices) {
    for (const OperatorInfo* info : operators()) {  // the constants, or what there is instead, are in the kernel
        for (const char* name : {"torus-9x5", "cube-3", "torus-10x7-noisy"}) {
            const auto built = build_operator(specimen(name), {info->id, {}});
            if (!built) continue;
            expect_singular(built->stiffness, Structure::general, -1);
            expect_singular(built->stiffness, Structure::symmetric, -1);
        }
    }
    // The second pair of unknowns occurs as a sum only.
    Matrix pair = Matrix::Identity(4, 4);
    pair(2, 3) = pair(3, 2) = 1;
    pair(0, 3) = 0.25;
    for (const double off : {0.0, 1e-15, -3e-15}) {
        pair(3, 3) = 1 + off;
        expect_singular(sparse(pair), Structure::general, -1);
    }
    pair(3, 3) = 1 + 1e-9;  // nearly, but not quite
    LinearFactor factor;
    check(factor.factor(sparse(pair), Structure::general));

    Matrix hole = Matrix::Identity(4, 4);
    hole(2, 2) = 0;
    expect_singular(sparse(hole), Structure::general, 2);
    expect_singular(SparseMatrix(3, 3), Structure::general, 0);
    expect_singular(sparse(Matrix::Ones(3, 3)), Structure::general, -1);
}

TEST(LinearFactor, RecoversFromARefusal) {
    LinearFactor factor;
    Matrix a = Matrix::Ones(3, 3);
    EXPECT_FALSE(factor.factor(sparse(a), Structure::general).ok());
    a.diagonal().setConstant(-2);
    EXPECT_FALSE(factor.factor(sparse(a), Structure::general).ok());  // rows sum to 0
    a.diagonal().setConstant(4);
    check(factor.factor(sparse(a), Structure::general));
    expect_solves(factor, a);
}

TEST(LinearFactor, RefusesWhatDoesNotFit) {
    LinearFactor factor;
    EXPECT_FALSE(factor.solve(Matrix::Zero(0, 1)).ok());
    const auto expect_refused = [](const Status& status) {
        ASSERT_FALSE(status.ok());
        EXPECT_EQ(status.error().code, ErrorCode::bad_argument);
    };
    expect_refused(factor.factor(SparseMatrix(2, 3), Structure::general));
    Matrix broken = Matrix::Identity(3, 3);
    broken(1, 2) = std::numeric_limits<double>::quiet_NaN();
    expect_refused(factor.factor(sparse(broken), Structure::general));
    SparseMatrix loose(3, 3);
    loose.reserve(Eigen::VectorXi::Constant(3, 2));
    loose.insert(0, 0) = 1;
    expect_refused(factor.factor(loose, Structure::general));

    check(factor.factor(sparse(Matrix::Identity(3, 3)), Structure::general));
    const auto solved = factor.solve(Matrix::Zero(4, 1));
    ASSERT_FALSE(solved.ok());
    EXPECT_EQ(solved.error().code, ErrorCode::bad_argument);
    check(factor.factor(SparseMatrix(0, 0), Structure::general));
    EXPECT_EQ(get(factor.solve(Matrix(0, 2))).cols(), 2);
}

}  // namespace
}  // namespace polylap::test

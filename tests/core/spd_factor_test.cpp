#include "polylap/solve/spd_factor.hpp"

#include <gtest/gtest.h>

#include <limits>

#include <Eigen/Cholesky>

#include "polylap/mesh/shapes.hpp"
#include "polylap/operators/operator.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

SparseMatrix sparse(const Matrix& dense) {
    return dense.sparseView();
}

SparseMatrix system_on(const PolygonMesh& mesh, double weight) {
    const auto matrices = get(build_operator(mesh, {operators().front()->id, {}}));
    return matrices.mass + weight * matrices.stiffness;
}

void expect_solves(const SpdFactor& factor, const SparseMatrix& a, Eigen::Index columns) {
    ASSERT_EQ(factor.size(), a.rows());
    Matrix x(a.rows(), columns);
    for (Eigen::Index j = 0; j < columns; ++j) {
        for (Eigen::Index i = 0; i < x.rows(); ++i) {
            x(i, j) = std::sin(1.7 * static_cast<double>(i) + static_cast<double>(j));
        }
    }
    const Matrix solved = get(factor.solve(a * x));
    ASSERT_EQ(solved.cols(), columns);
    EXPECT_LE((solved - x).norm(), 1e-10 * (1 + x.norm()));
}

TEST(SpdFactor, SolvesAgainAndAgain) {
    const auto torus = get(make_torus(12, 8));
    SpdFactor factor;
    for (const double weight : {0.1, 1.0, 5.0}) {  // the same pattern, other values
        const SparseMatrix a = system_on(torus, weight);
        check(factor.factor(a));
        expect_solves(factor, a, 1);
        expect_solves(factor, a, 7);
        expect_solves(factor, a, 0);
    }
    const SparseMatrix other = system_on(get(make_grid(5, 6)), 1);  // another size
    check(factor.factor(other));
    expect_solves(factor, other, 3);

    Matrix dense = Matrix::Identity(42, 42) * 3;  // the same size, another pattern
    dense(41, 0) = dense(0, 41) = 1;
    check(factor.factor(sparse(dense)));
    expect_solves(factor, sparse(dense), 2);
}

TEST(SpdFactor, AnotherPatternOfTheSameCountIsSeen) {
    Matrix a = Matrix::Identity(4, 4) * 2;
    Matrix b = a;
    a(0, 1) = a(1, 0) = 1;
    b(2, 3) = b(3, 2) = 1;
    SpdFactor factor;
    check(factor.analyse(sparse(a)));
    check(factor.factor(sparse(a)));
    expect_solves(factor, sparse(a), 1);
    check(factor.factor(sparse(b)));
    expect_solves(factor, sparse(b), 1);
}

TEST(SpdFactor, ReadsOnlyTheLowerTriangle) {
    Matrix full(3, 3);
    full << 4, 1, 0.5, 1, 5, 2, 0.5, 2, 6;
    Matrix lower = full.triangularView<Eigen::Lower>();
    lower(0, 2) = 77;
    SpdFactor factor;
    check(factor.factor(sparse(lower)));
    expect_solves(factor, sparse(full), 2);
}

TEST(SpdFactor, TinyMatrices) {
    SpdFactor factor;
    SparseMatrix one(1, 1);
    one.insert(0, 0) = 4;
    one.makeCompressed();
    check(factor.factor(one));
    EXPECT_EQ(get(factor.solve(Matrix::Constant(1, 1, 8)))(0, 0), 2);

    check(factor.factor(SparseMatrix(0, 0)));
    EXPECT_EQ(factor.size(), 0);
    EXPECT_EQ(get(factor.solve(Matrix(0, 2))).cols(), 2);
}

TEST(SpdFactor, RefusesWhatIsNotSquare) {
    SpdFactor factor;
    for (const Status& status : {factor.analyse(SparseMatrix(3, 4)), factor.factor(SparseMatrix(3, 4))}) {
        ASSERT_FALSE(status.ok());
        EXPECT_EQ(status.error().code, ErrorCode::bad_argument);
    }
}

TEST(SpdFactor, NamesTheRowWhereItFails) {
    const auto refused = [](const Matrix& a) {
        SpdFactor factor;
        const Status status = factor.factor(sparse(a));
        EXPECT_FALSE(status.ok());
        if (status.ok()) return std::int64_t{-1};
        EXPECT_EQ(status.error().code, ErrorCode::not_positive_definite);
        EXPECT_NE(status.error().message.find(std::to_string(status.error().element)), std::string::npos)
            << status.error().message;
        return status.error().element;
    };
    Matrix diagonal = Matrix::Identity(5, 5);
    diagonal(3, 3) = -1;
    EXPECT_EQ(refused(diagonal), 3);
    diagonal(3, 3) = 0;
    diagonal(4, 3) = diagonal(3, 4) = 0;
    EXPECT_EQ(refused(diagonal), 3);

    // A block 1–3 that is singular: whichever of the two goes last fails.
    Matrix block = Matrix::Identity(5, 5);
    block(1, 3) = block(3, 1) = 1;
    const std::int64_t row = refused(block);
    EXPECT_TRUE(row == 1 || row == 3) << row;

    // The constants are in the kernel of every stiffness matrix.
    const SparseMatrix s = get(build_operator(get(make_grid(6, 6)), {operators().front()->id, {}})).stiffness;
    SpdFactor factor;
    EXPECT_FALSE(factor.factor(s).ok());
}

TEST(SpdFactor, RefusesWhatIsNotFinite) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
        for (const Index column : {0, 2}) {
            Matrix broken = Matrix::Identity(4, 4);
            broken(2, column) = bad;
            SpdFactor factor;
            const Status status = factor.factor(sparse(broken));
            ASSERT_FALSE(status.ok());
            EXPECT_EQ(status.error().code, ErrorCode::bad_argument);
            EXPECT_EQ(status.error().element, 2);
            EXPECT_EQ(status.error().message, "the matrix is not finite in row 2");
        }
    }
}

TEST(SpdFactor, AnotherMatrixAfterAFailure) {
    SpdFactor factor;
    EXPECT_FALSE(factor.factor(sparse(-Matrix::Identity(4, 4))).ok());
    const SparseMatrix good = sparse(Matrix::Identity(4, 4) * 2);
    check(factor.factor(good));
    expect_solves(factor, good, 1);
}

TEST(SpdFactor, TheScaleDoesNotMatter) {
    const SparseMatrix a = system_on(get(make_torus(6, 5)), 1);
    for (const double scale : {1e-120, 1e-12, 1e12, 1e120}) {
        SpdFactor factor;
        const SparseMatrix scaled = scale * a;
        check(factor.factor(scaled));
        expect_solves(factor, scaled, 1);
    }
}

/// A mesh large enough for several ticks of the analysis and of the factorisation.
SparseMatrix large_system(Points& positions) {
    const auto torus = get(make_torus(260, 200));
    positions = torus.positions();
    return system_on(torus, 1);
}

TEST(SpdFactor, TellsItsProgressAndStopsAtEachTick) {
    Points positions;
    const SparseMatrix a = large_system(positions);
    const auto run = [&](SpdFactor& factor, Monitor monitor) -> Status {
        Stretch analysing{monitor, 0, 0.5};
        if (Status status = factor.analyse(a, positions, analysing.monitor()); !status) return status;
        Stretch factoring{monitor, 0.5, 1};
        return factor.factor(a, factoring.monitor());
    };
    Ticks all;
    SpdFactor whole;
    check(run(whole, all.monitor()));
    EXPECT_TRUE(all.rise());
    EXPECT_GE(all.fractions.size(), 10U);
    for (std::size_t stop = 1; stop <= all.fractions.size(); ++stop) {
        Ticks some;
        some.stop_at = stop;
        SpdFactor factor;
        const Status status = run(factor, some.monitor());
        ASSERT_FALSE(status.ok()) << stop;
        EXPECT_EQ(status.error().code, ErrorCode::cancelled);
        EXPECT_EQ(some.fractions.size(), stop) << "it went on";
        EXPECT_FALSE(factor.solve(Matrix::Ones(a.rows(), 1)).ok());
        if (stop % 4 != 0) continue;
        check(run(factor, {}));
        expect_solves(factor, a, 1);
    }
}

TEST(SpdFactor, SharesAnAnalysis) {
    Points positions;
    const SparseMatrix a = large_system(positions);
    const auto analysis = get(SpdAnalysis::create(a, positions));
    EXPECT_EQ(analysis->size(), a.rows());
    EXPECT_TRUE(analysis->fits(a));
    EXPECT_GT(analysis->factor_entries(), a.nonZeros() / 2);
    EXPECT_GT(analysis->factor_flops(), static_cast<double>(analysis->factor_entries()));
    SpdFactor one;
    SpdFactor other;
    one.use(analysis);
    other.use(analysis);
    const SparseMatrix b = 3 * a;
    check(one.factor(a));
    check(other.factor(b));
    EXPECT_EQ(one.analysis(), other.analysis()) << "neither needed another";
    expect_solves(one, a, 3);
    expect_solves(other, b, 3);
    check(one.factor(b));
    EXPECT_EQ(get(one.solve(Matrix::Ones(a.rows(), 1))), get(other.solve(Matrix::Ones(a.rows(), 1))));
}

TEST(SpdFactor, NamesTheRowInALargeMatrix) {
    Points positions;
    SparseMatrix a = large_system(positions);
    SpdFactor factor;
    check(factor.analyse(a, positions));
    for (const Index row : {0, 7001, static_cast<Index>(a.rows()) - 1}) {
        const double kept = a.coeff(row, row);
        a.coeffRef(row, row) = -kept;
        const Status status = factor.factor(a);
        ASSERT_FALSE(status.ok());
        EXPECT_EQ(status.error().code, ErrorCode::not_positive_definite);
        EXPECT_EQ(status.error().element, row) << "what goes before is positive definite";
        EXPECT_NE(status.error().message.find(std::to_string(row)), std::string::npos);
        a.coeffRef(row, row) = kept;
    }
    check(factor.factor(a));
    expect_solves(factor, a, 1);
}

TEST(SpdFactor, Moves) {
    const SparseMatrix a = sparse(Matrix::Identity(3, 3) * 5);
    SpdFactor first;
    check(first.factor(a));
    SpdFactor second(std::move(first));
    expect_solves(second, a, 1);
    SpdFactor third;
    third = std::move(second);
    expect_solves(third, a, 1);
}

TEST(SpdFactor, RefusesToSolveWithoutAFittingFactor) {
    SpdFactor factor;
    const auto refused = [&factor](Eigen::Index rows) {
        const auto solved = factor.solve(Matrix::Ones(rows, 1));
        return !solved.ok() && solved.error().code == ErrorCode::bad_argument;
    };
    EXPECT_TRUE(refused(3)) << "nothing done";
    check(factor.analyse(sparse(Matrix::Identity(3, 3) * 5)));
    EXPECT_TRUE(refused(3)) << "only analysed";
    check(factor.factor(sparse(Matrix::Identity(3, 3) * 5)));
    EXPECT_FALSE(refused(3));
    EXPECT_TRUE(refused(2)) << "too few rows";
    EXPECT_TRUE(refused(4)) << "too many rows";
    EXPECT_FALSE(factor.factor(sparse(Matrix::Identity(3, 3) * -5)).ok());
    EXPECT_TRUE(refused(3)) << "the last factorisation failed";
}

}  // namespace
}  // namespace polylap::test

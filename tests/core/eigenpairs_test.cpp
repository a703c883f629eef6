#include "polylap/solve/eigenpairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "polylap/mesh/shapes.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

SparseMatrix symmetric_part(const OperatorMatrices& matrices) {
    const SparseMatrix transposed = matrices.stiffness.transpose();
    return 0.5 * (matrices.stiffness + transposed);
}

/// `copies` times the matrix along the diagonal.
SparseMatrix repeat(const SparseMatrix& block, Index copies) {
    const auto n = static_cast<Index>(block.rows());
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index c = 0; c < copies; ++c) {
        for (Index k = 0; k < n; ++k) {
            for (SparseMatrix::InnerIterator it(block, k); it; ++it) {
                entries.emplace_back(c * n + it.index(), c * n + k, it.value());
            }
        }
    }
    SparseMatrix repeated(copies * n, copies * n);
    repeated.setFromTriplets(entries.begin(), entries.end());
    return repeated;
}

Vector dense_eigenvalues(const SparseMatrix& s) {
    return Eigen::SelfAdjointEigenSolver<Matrix>(Matrix(s), Eigen::EigenvaluesOnly).eigenvalues();
}

/// Against `expected`, all eigenvalues ascending.
void expect_lowest(const SparseMatrix& s, Index count, const Vector& expected, const std::string& name) {
    const auto pairs = lowest_eigenpairs(s, count);
    ASSERT_TRUE(pairs.ok()) << name << ": " << pairs.error().message;
    const auto n = static_cast<Index>(s.rows());
    const Index k = std::min(count, n);
    const double scale = std::max(expected.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
    ASSERT_EQ(pairs->values.size(), k) << name;
    ASSERT_EQ(pairs->vectors.rows(), n) << name;
    ASSERT_EQ(pairs->vectors.cols(), k) << name;
    EXPECT_TRUE(std::is_sorted(pairs->values.begin(), pairs->values.end())) << name;
    EXPECT_LE((pairs->values - expected.head(k)).cwiseAbs().maxCoeff(), 1e-10 * scale) << name;
    EXPECT_LE((pairs->vectors.transpose() * pairs->vectors - Matrix::Identity(k, k)).cwiseAbs().maxCoeff(), 1e-10)
        << name;
    EXPECT_LE((s * pairs->vectors - pairs->vectors * pairs->values.asDiagonal()).colwise().norm().maxCoeff(),
              1e-8 * scale)
        << name;
}

TEST(Eigenpairs, EqualTheDenseOnes) {
    for (const auto& [name, mesh] : zoo()) {
        for (const OperatorInfo* info : operators()) {
            const auto built = build_operator(mesh, {info->id, {}});
            if (!built) continue;  // e.g. only for triangles
            const SparseMatrix s = symmetric_part(*built);
            const Vector expected = dense_eigenvalues(s);
            for (const Index count : {1, 12, 40}) {
                expect_lowest(s, count, expected, name + ", " + info->id);
            }
            const double largest = get(largest_eigenvalue(s));
            EXPECT_NEAR(largest, expected[expected.size() - 1], 1e-6 * expected.cwiseAbs().maxCoeff())
                << name << ", " << info->id;
        }
    }
}

// A path of n vertices has the eigenvalues 2 - 2 cos(k π / n).
SparseMatrix path(Index n) {
    SparseMatrix s(n, n);
    for (Index i = 0; i + 1 < n; ++i) {
        s.coeffRef(i, i) += 1;
        s.coeffRef(i + 1, i + 1) += 1;
        s.coeffRef(i, i + 1) -= 1;
        s.coeffRef(i + 1, i) -= 1;
    }
    s.makeCompressed();
    return s;
}
Vector path_eigenvalues(Index n) {
    Vector values(n);
    for (Index k = 0; k < n; ++k) {
        values[k] = 2 - 2 * std::cos(k * 3.14159265358979323846 / n);
    }
    return values;
}

TEST(Eigenpairs, OfALongPath) {
    expect_lowest(path(2000), 30, path_eigenvalues(2000), "path");
    EXPECT_NEAR(get(largest_eigenvalue(path(2000))), path_eigenvalues(2000)[1999], 4e-6);
}

TEST(Eigenpairs, AreTheLowestOfIndefiniteMatrices) {
    SparseMatrix identity(700, 700);
    identity.setIdentity();
    const Vector values = path_eigenvalues(700);
    for (const double shift : {-1e-3, -0.5, -3.0, -1e4, 1.0}) {
        expect_lowest(path(700) + shift * identity, 15, values.array() + shift, "shift " + std::to_string(shift));
    }
    const SparseMatrix negated = -path(700);
    expect_lowest(negated, 15, -values.reverse(), "negated");
    EXPECT_NEAR(get(largest_eigenvalue(negated)), 0, 4e-6);
}

// Each eigenvalue of a matrix that is repeated 45 times has multiples of 45 copies: a Krylov space meets one of each.
TEST(Eigenpairs, CompleteLargeEigenspaces) {
    const SparseMatrix s =
        repeat(get(build_operator(get(make_torus(6, 5)), {operators().front()->id, {}})).stiffness, 45);
    const Vector expected = dense_eigenvalues(s);
    ASSERT_LT(expected[44], 1e-12);
    ASSERT_GT(expected[45], 1e-3);
    for (const Index count : {40, 45, 46, 64, 120}) {
        expect_lowest(s, count, expected, std::to_string(count));
    }
    expect_lowest(-s, 50, -expected.reverse(), "negated");
}

TEST(Eigenpairs, OfTheIdentityAndOfZero) {
    SparseMatrix identity(500, 500);
    identity.setIdentity();
    expect_lowest(identity, 20, Vector::Ones(500), "identity");
    expect_lowest(1e-200 * identity, 20, Vector::Constant(500, 1e-200), "tiny");
    expect_lowest(1e100 * identity, 20, Vector::Constant(500, 1e100), "huge");
    expect_lowest(SparseMatrix(500, 500), 20, Vector::Zero(500), "zero");
    EXPECT_EQ(get(largest_eigenvalue(SparseMatrix(500, 500))), 0);
    EXPECT_NEAR(get(largest_eigenvalue(-3 * identity)), -3, 1e-5);
    EXPECT_EQ(get(lowest_eigenpairs(SparseMatrix(0, 0), 3)).values.size(), 0);
}

// M^-½ S M^-½ on a sphere of radius 1: ℓ(ℓ+1), each 2ℓ+1 times.
TEST(Eigenpairs, OfASphereComeInOddGroups) {
    const auto& sphere = load_mesh("triangle-sphere-2");
    const auto matrices = get(build_operator(sphere, {"cotan", {}}));
    const Vector half = Vector(matrices.mass.diagonal()).cwiseSqrt().cwiseInverse();
    const SparseMatrix s = half.asDiagonal() * matrices.stiffness * half.asDiagonal();
    const auto pairs = get(lowest_eigenpairs(s, 16));
    const double radius = sphere.positions().rowwise().norm().mean();
    Index k = 0;
    for (Index l = 0; l < 4; ++l) {
        for (Index m = 0; m < 2 * l + 1; ++m, ++k) {
            EXPECT_NEAR(pairs.values[k] * radius * radius, l * (l + 1), 0.08 * l * (l + 1) + 1e-10) << k;
        }
    }
}

/// |M^-½ (S x - μ M x)| of the worst pair over |M^-½ S M^-½|∞, and how far the vectors are from M-orthonormal.
void expect_generalised(const OperatorMatrices& m, const Eigenpairs& pairs, const std::string& name) {
    Vector half = m.mass.diagonal();
    for (double& mass : half)
        mass = mass > 0 ? 1 / std::sqrt(mass) : 0;
    const Matrix scaled = half.asDiagonal() * Matrix(m.stiffness) * half.asDiagonal();
    const double scale = scaled.cwiseAbs().rowwise().sum().maxCoeff();
    const Matrix residual =
        half.asDiagonal() * (m.stiffness * pairs.vectors - m.mass * pairs.vectors * pairs.values.asDiagonal());
    EXPECT_LE(residual.colwise().norm().maxCoeff(), eigenpair_tolerance * scale) << name;
    const auto k = pairs.values.size();
    EXPECT_LE((pairs.vectors.transpose() * m.mass * pairs.vectors - Matrix::Identity(k, k)).cwiseAbs().maxCoeff(), 1e-9)
        << name;
}

TEST(Eigenpairs, WithAMassEqualTheDenseOnes) {
    for (const auto& [name, mesh] : zoo()) {
        const auto matrices = build_operator(mesh, {operators().front()->id, {}});
        if (!matrices || matrices->structure != Structure::positive_semidefinite) continue;
        std::vector<Index> used;
        const Vector mass = matrices->mass.diagonal();
        for (Index v = 0; v < mesh.vertex_count(); ++v) {
            if (mass[v] > 0) used.push_back(v);
        }
        const Vector part = mass(used);
        const Matrix s = Matrix(matrices->stiffness)(used, used);
        const Vector expected =
            Eigen::GeneralizedSelfAdjointEigenSolver<Matrix>(s, Matrix(part.asDiagonal()), Eigen::EigenvaluesOnly)
                .eigenvalues();
        const auto pairs = get(lowest_eigenpairs(matrices->stiffness, matrices->mass, 12, {}, mesh.positions()));
        ASSERT_EQ(pairs.vectors.rows(), mesh.vertex_count());
        ASSERT_EQ(pairs.values.size(), std::min<Eigen::Index>(12, expected.size())) << name;
        EXPECT_LE((pairs.values - expected.head(pairs.values.size())).cwiseAbs().maxCoeff(),
                  1e-9 * expected.cwiseAbs().maxCoeff())
            << name;
        expect_generalised(*matrices, pairs, name);
        for (Index v = 0; v < mesh.vertex_count(); ++v) {
            if (mass[v] > 0) continue;
            EXPECT_EQ(pairs.vectors.row(v).norm(), 0) << name;
        }
    }
}

PolygonMesh made(const char* shape, const char* parameter, const char* value) {
    const std::vector<std::pair<std::string, std::string>> settings{{parameter, value}};
    return get(make_shape(shape, settings));
}

// ℓ(ℓ+1), each 2ℓ+1 times, in groups that the mesh hardly splits.
TEST(Eigenpairs, OfALargeSphereComeInOddGroups) {
    const PolygonMesh sphere = made("hexagon-sphere", "level", "4");
    const auto matrices = get(build_operator(sphere, {"alexa-wardetzky", {}}));
    ASSERT_GT(sphere.vertex_count(), 2000);
    const auto pairs = get(lowest_eigenpairs(matrices.stiffness, matrices.mass, 25, {}, sphere.positions()));
    expect_generalised(matrices, pairs, "hexagon-sphere");
    double below = 0;
    for (Index l = 1, k = 1; l < 5; k += 2 * l + 1, ++l) {
        const double first = pairs.values[k];
        const double last = pairs.values[k + 2 * l];
        const double mean = pairs.values.segment(k, 2 * l + 1).mean();
        EXPECT_LE(last - first, 0.02 * mean) << l;
        EXPECT_GE(first - below, 20 * (last - first)) << l;
        below = last;
    }
    EXPECT_NEAR(pairs.values[0], 0, 1e-9 * pairs.values[24]);
    EXPECT_NEAR(pairs.values[20] / pairs.values[2], 10, 0.3);  // ℓ = 4 against ℓ = 1
}

// The symmetries of a cube leave eigenvalues of 1, 2 and 3 copies, exactly.
TEST(Eigenpairs, OfASymmetricMeshHaveAllTheirCopies) {
    const PolygonMesh cube = made("cube", "n", "12");
    const auto matrices = get(build_operator(cube, {operators().front()->id, {}}));
    const Vector expected = Eigen::GeneralizedSelfAdjointEigenSolver<Matrix>(
                                Matrix(matrices.stiffness), Matrix(matrices.mass), Eigen::EigenvaluesOnly)
                                .eigenvalues();
    const auto pairs = get(lowest_eigenpairs(matrices.stiffness, matrices.mass, 30, {}, cube.positions()));
    EXPECT_LE((pairs.values - expected.head(30)).cwiseAbs().maxCoeff(), 1e-10 * expected.maxCoeff());
    EXPECT_NEAR(pairs.values[3], pairs.values[1], 1e-8 * pairs.values[1]);  // the first three are x, y and z
    expect_generalised(matrices, pairs, "cube");
}

TEST(Eigenpairs, RefuseMassesThatAreNone) {
    const auto m = get(build_operator(specimen("grid-2x2"), {operators().front()->id, {}}));
    const auto refused = [&](const SparseMatrix& mass, const Points& positions = {}) {
        const auto pairs = lowest_eigenpairs(m.stiffness, mass, 3, {}, positions);
        return pairs ? Error{ErrorCode::out_of_memory, "was not refused"} : pairs.error();
    };
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        SparseMatrix mass = m.mass;
        mass.coeffRef(4, 4) = bad;
        EXPECT_EQ(refused(mass).code, ErrorCode::mass_not_positive);
        EXPECT_EQ(refused(mass).element, 4);
    }
    SparseMatrix full = m.mass;
    full.coeffRef(2, 1) = 0.1;
    EXPECT_EQ(refused(full).code, ErrorCode::bad_argument);
    EXPECT_EQ(refused(full).element, 1);
    EXPECT_EQ(refused(SparseMatrix(3, 3)).code, ErrorCode::bad_argument);
    EXPECT_EQ(refused(m.mass, Points::Zero(4, 3)).code, ErrorCode::bad_argument);
}

TEST(Eigenpairs, CountsThoseBelow) {
    const Vector values = path_eigenvalues(400);
    for (const double shift : {-1.0, 0.001, 0.5, 1.7, 3.0, 3.999, 5.0}) {
        EXPECT_EQ(get(count_eigenvalues_below(path(400), shift)), (values.array() < shift).count()) << shift;
    }
    EXPECT_EQ(get(count_eigenvalues_below(SparseMatrix(0, 0), 1)), 0);
    // A first pivot of 0, and one that is nearly 0: no exchange, no count.
    Matrix swap(2, 2);
    swap << 0, 1, 1, 0;
    for (const double shift : {0.0, 1e-14}) {
        const auto count = count_eigenvalues_below(swap.sparseView(), shift);
        ASSERT_FALSE(count.ok());
        EXPECT_EQ(count.error().code, ErrorCode::not_converged);
    }
    EXPECT_EQ(get(count_eigenvalues_below(swap.sparseView(), 0.1)), 1);
}

TEST(Eigenpairs, TickRiseAndStop) {
    const SparseMatrix s = path(1000);
    Ticks all;
    get(lowest_eigenpairs(s, 10, all.monitor()));
    EXPECT_GT(all.fractions.size(), 10U);
    EXPECT_TRUE(all.rise());
    for (const std::size_t stop : {std::size_t{1}, std::size_t{7}, all.fractions.size()}) {
        Ticks ticks;
        ticks.stop_at = stop;
        const auto stopped = lowest_eigenpairs(s, 10, ticks.monitor());
        ASSERT_FALSE(stopped.ok());
        EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
        EXPECT_EQ(ticks.fractions.size(), stop);
    }
    Ticks ticks;
    ticks.stop_at = 3;
    const auto stopped = largest_eigenvalue(s, ticks.monitor());
    ASSERT_FALSE(stopped.ok());
    EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}

TEST(Eigenpairs, AreTheSameEachTime) {
    const SparseMatrix s = path(600);
    const auto a = get(lowest_eigenpairs(s, 9));
    const auto b = get(lowest_eigenpairs(s, 9));
    EXPECT_EQ(a.values, b.values);
    EXPECT_EQ(a.vectors, b.vectors);
}

TEST(Eigenpairs, RefuseWhatHasNone) {
    const auto expect_refused = [](const SparseMatrix& s, Index count) {
        const auto pairs = lowest_eigenpairs(s, count);
        ASSERT_FALSE(pairs.ok());
        EXPECT_EQ(pairs.error().code, ErrorCode::bad_argument);
    };
    expect_refused(path(10), 0);
    expect_refused(path(10), -3);
    expect_refused(SparseMatrix(3, 4), 1);
    SparseMatrix lopsided = path(10);
    lopsided.coeffRef(3, 4) = -1.001;
    expect_refused(lopsided, 1);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        SparseMatrix broken = path(10);
        broken.coeffRef(2, 2) = bad;
        expect_refused(broken, 1);
        EXPECT_FALSE(largest_eigenvalue(broken).ok());
        EXPECT_FALSE(count_eigenvalues_below(broken, 0).ok());
        EXPECT_FALSE(count_eigenvalues_below(path(10), bad).ok());
    }
    EXPECT_FALSE(largest_eigenvalue(SparseMatrix(0, 0)).ok());
}

}  // namespace
}  // namespace polylap::test

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "solve/supernodal/numeric.hpp"
#include "solve/supernodal/symbolic.hpp"
#include "sparse_patterns.hpp"

namespace polylap::test {
namespace {

bool is_permutation(std::vector<Index> order) {
    std::sort(order.begin(), order.end());
    std::vector<Index> all(order.size());
    std::iota(all.begin(), all.end(), 0);
    return order == all;
}

/// nnz(L) by playing the elimination through, with sets.
std::int64_t entries_by_elimination(const SparseMatrix& a, const std::vector<Index>& order) {
    const auto n = static_cast<std::size_t>(a.cols());
    std::vector<Index> place(n);
    for (std::size_t k = 0; k < n; ++k)
        place[static_cast<std::size_t>(order[k])] = static_cast<Index>(k);
    std::vector<std::vector<Index>> below(n);
    for (Index column = 0; column < a.cols(); ++column) {
        for (SparseMatrix::InnerIterator it(a, column); it; ++it) {
            const Index i = place[static_cast<std::size_t>(it.row())];
            const Index j = place[static_cast<std::size_t>(column)];
            if (it.row() > column) below[static_cast<std::size_t>(std::min(i, j))].push_back(std::max(i, j));
        }
    }
    std::int64_t entries = 0;
    for (auto& rows : below) {
        std::sort(rows.begin(), rows.end());
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
        entries += 1 + static_cast<std::int64_t>(rows.size());
        if (rows.size() < 2) continue;
        auto& parent = below[static_cast<std::size_t>(rows.front())];
        parent.insert(parent.end(), rows.begin() + 1, rows.end());
    }
    return entries;
}

/// |Ax − b| over |A||x| + |b|, in the largest norm.
double residual(const SparseMatrix& a, const Matrix& x, const Matrix& b) {
    if (b.size() == 0) return 0;
    const Vector sums = a.cwiseAbs() * Vector::Ones(a.cols());
    const double scale = sums.maxCoeff() * x.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff();
    return (a * x - b).cwiseAbs().maxCoeff() / scale;
}

Matrix some_rhs(Eigen::Index n, Eigen::Index k) {
    Matrix b(n, k);
    for (Eigen::Index j = 0; j < k; ++j) {
        for (Eigen::Index i = 0; i < n; ++i)
            b(i, j) = std::sin(0.3 + 2.1 * static_cast<double>(i) + static_cast<double>(j * j));
    }
    return b;
}

/// With minimum degree where the system is small, and with nested dissection throughout.
class Ordered : public ::testing::TestWithParam<Index> {};
INSTANTIATE_TEST_SUITE_P(Supernodal, Ordered, ::testing::Values(0, minimum_degree_size));

TEST_P(Ordered, CountsAndSolvesEveryPattern) {
    for (const System& system : sparse_systems()) {
        for (std::size_t where = 0; where < system.positions.size(); ++where) {
            SCOPED_TRACE(system.name + ", positions " + std::to_string(where));
            const Symbolic symbolic = get(analyse_pattern(system.a, system.positions[where], {}, GetParam()));
            EXPECT_TRUE(is_permutation(symbolic.original));
            EXPECT_EQ(symbolic.entries, entries_by_elimination(system.a, symbolic.original));
            EXPECT_GE(symbolic.flops, symbolic.entries);
            for (const dense::Kernels* kernels : dense::kernels()) {
                Numeric numeric(*kernels);
                check(numeric.factor(symbolic, system.a, {}));
                for (const Eigen::Index k : {0, 1, 3, 4, 8, 30}) {
                    const Matrix b = some_rhs(system.a.rows(), k);
                    const Matrix x = numeric.solve(symbolic, b);
                    ASSERT_EQ(x.cols(), k);
                    EXPECT_LE(residual(system.a, x, b), 1e-14) << kernels->name << ", " << k << " right-hand sides";
                }
            }
        }
    }
}

TEST_P(Ordered, SolvesOnTheWholeZoo) {
    for (const Specimen& specimen : zoo()) {
        SCOPED_TRACE(specimen.name);
        for (const OperatorInfo* info : operators()) {
            const auto built = build_operator(specimen.mesh, {info->id, {}});
            if (!built) continue;
            const SparseMatrix s = built->stiffness.selfadjointView<Eigen::Lower>();
            double scale = 0;
            for (Index column = 0; column < s.cols(); ++column) {
                for (SparseMatrix::InnerIterator it(s, column); it; ++it)
                    scale = std::max(scale, std::abs(it.value()));
            }
            SparseMatrix identity(s.rows(), s.cols());
            identity.setIdentity();
            const SparseMatrix a = s + (scale > 0 ? 1e-6 * scale : 1.0) * identity;
            const Symbolic symbolic = get(analyse_pattern(a, specimen.mesh.positions(), {}, GetParam()));
            for (const dense::Kernels* kernels : dense::kernels()) {
                Numeric numeric(*kernels);
                const Status status = numeric.factor(symbolic, a, {});
                if (!status) {  // an indefinite stiffness
                    EXPECT_EQ(status.error().code, ErrorCode::not_positive_definite);
                    continue;
                }
                const Matrix b = some_rhs(a.rows(), 3);
                EXPECT_LE(residual(a, numeric.solve(symbolic, b), b), 1e-12) << info->id;
            }
        }
    }
}

TEST_P(Ordered, KeepsTheFillOfGridsLow) {
    // n log₂ n entries times 31/4 is George's bound for the nine-point stencil on a square; this is to notice when an
    // ordering goes astray, not to tell how good it is.
    const System grid = grid_system(64, 60);
    const auto n = static_cast<double>(grid.a.rows());
    for (std::size_t where = 0; where < grid.positions.size(); ++where) {
        const Symbolic symbolic = get(analyse_pattern(grid.a, grid.positions[where], {}, GetParam()));
        EXPECT_LE(static_cast<double>(symbolic.entries), 3.3 * n * std::log2(n)) << where;
    }
    for (const System& system : sparse_systems()) {
        if (system.name != "tridiagonal" && system.name != "arrow" && system.name != "pairs") continue;
        const Symbolic symbolic = get(analyse_pattern(system.a, Points(0, 3), {}, GetParam()));
        EXPECT_LE(symbolic.entries, 3 * system.a.rows()) << system.name;  // none would be 2 n
    }
}

TEST(Supernodal, OrdersLargeGraphsByTheirClusters) {
    const System grid = grid_system(150, 140);
    const auto n = static_cast<double>(grid.a.rows());
    for (std::size_t where = 0; where < grid.positions.size(); ++where) {
        SCOPED_TRACE(where);
        const Symbolic symbolic = get(analyse_pattern(grid.a, grid.positions[where], {}, 0));
        EXPECT_TRUE(is_permutation(symbolic.original));
        EXPECT_LE(static_cast<double>(symbolic.entries), 3.3 * n * std::log2(n));
        Numeric numeric;
        check(numeric.factor(symbolic, grid.a, {}));
        const Matrix b = some_rhs(grid.a.rows(), 2);
        EXPECT_LE(residual(grid.a, numeric.solve(symbolic, b), b), 1e-14);
    }
}

TEST(Supernodal, IsTheSameEachTime) {
    const System grid = grid_system(64, 60);
    for (const Points& positions : grid.positions) {
        const Symbolic first = get(analyse_pattern(grid.a, positions, {}, 0));
        const Symbolic second = get(analyse_pattern(grid.a, positions, {}, 0));
        EXPECT_EQ(first.original, second.original);
        const Matrix b = some_rhs(grid.a.rows(), 2);
        Numeric one;
        Numeric other;
        check(one.factor(first, grid.a, {}));
        check(other.factor(second, grid.a, {}));
        EXPECT_EQ(one.solve(first, b), other.solve(second, b));
    }
}

}  // namespace
}  // namespace polylap::test

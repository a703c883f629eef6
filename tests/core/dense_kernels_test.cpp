// Every instruction set that this machine has, against Eigen.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Cholesky>

#include "polylap/base/types.hpp"
#include "solve/dense/kernels.hpp"

namespace polylap::test {
namespace {

using dense::Kernels;

Matrix waves(Eigen::Index rows, Eigen::Index columns, double phase) {
    Matrix a(rows, columns);
    for (Eigen::Index j = 0; j < columns; ++j) {
        for (Eigen::Index i = 0; i < rows; ++i) {
            a(i, j) = std::sin(phase + 1.3 * static_cast<double>(i) + 0.7 * static_cast<double>(i * j % 101));
        }
    }
    return a;
}

/// A matrix with unused rows between its columns, as kernels get it; around it, what they may read but not use.
struct Panel {
    Panel(const Matrix& a, Eigen::Index stride)
        : rows(a.rows()),
          columns(a.cols()),
          data(static_cast<std::size_t>(stride * a.cols()) + dense::slack, unused),
          all(data.data(), a.rows(), a.cols(), Eigen::OuterStride<>(stride)) {
        all = a;
    }
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

    /// Whether nothing was written but the matrix.
    bool untouched_outside() const {
        for (std::size_t k = 0; k < data.size(); ++k) {
            const auto stride = static_cast<std::size_t>(all.outerStride());
            const bool within =
                k % stride < static_cast<std::size_t>(rows) && k / stride < static_cast<std::size_t>(columns);
            if (!within && !std::isnan(data[k])) return false;
        }
        return true;
    }
    Matrix lower() const {
        Matrix l = all;
        for (Eigen::Index j = 1; j < columns; ++j)
            l.col(j).head(j).setZero();
        return l;
    }

    static constexpr double unused = std::numeric_limits<double>::quiet_NaN();
    Eigen::Index rows, columns;
    std::vector<double> data;
    Eigen::Map<Matrix, 0, Eigen::OuterStride<>> all;
};

class DenseKernels : public ::testing::TestWithParam<const Kernels*> {
protected:
    const Kernels& kernels() const { return *GetParam(); }
    double* scratch() { return scratch_.data(); }

private:
    std::vector<double> scratch_ = std::vector<double>(GetParam()->scratch_doubles + dense::slack);
};

/// The leading columns of a positive definite matrix, eliminated, leave L in them.
TEST_P(DenseKernels, FactorsTrapezoids) {
    for (const Eigen::Index columns : {1, 2, 3, 4, 5, 7, 8, 9, 13, 16, 31, 32, 33, 40, 64, 77, 150, 300}) {
        for (const Eigen::Index below : {0, 1, 2, 3, 5, 8, 17, 24, 25, 63, 210}) {
            const Eigen::Index n = columns + below;
            const Matrix b = waves(n, n, 0.3);
            const Matrix a = b * b.transpose() + static_cast<double>(n) * Matrix::Identity(n, n);
            const Matrix expected = a.llt().matrixL();
            Panel panel(a.leftCols(columns), n + 3);
            const Vector least = Vector::Zero(columns);
            if (columns > dense::block_columns) continue;
            ASSERT_EQ(kernels().factor(panel.all.data(), n + 3, n, columns, least.data(), scratch()), -1);
            EXPECT_LE((panel.lower() - expected.leftCols(columns)).norm(), 1e-13 * expected.norm())
                << columns << " columns, " << below << " rows below";
            EXPECT_TRUE(panel.untouched_outside());
        }
    }
}

TEST_P(DenseKernels, RefusesThePivotThatIsTooSmall) {
    for (const Eigen::Index columns : {1, 3, 8, 20, 50, 200}) {
        for (Eigen::Index bad = 0; bad < columns; bad += 1 + columns / 7) {
            Matrix a = Matrix::Identity(columns + 2, columns) * 4;
            Panel panel(a, columns + 2);
            Vector least = Vector::Constant(columns, 3.9);
            least[bad] = 4;
            EXPECT_EQ(kernels().factor(panel.all.data(), columns + 2, columns + 2, columns, least.data(), scratch()),
                      bad);
            panel.all = a;
            panel.all(bad, bad) = std::numeric_limits<double>::quiet_NaN();
            EXPECT_EQ(kernels().factor(panel.all.data(), columns + 2, columns + 2, columns, least.data(), scratch()),
                      bad);
        }
    }
}

TEST_P(DenseKernels, DowndatesTrapezoids) {
    for (const Eigen::Index columns : {1, 2, 3, 5, 8, 11, 24, 50, 97, 130}) {
        for (const Eigen::Index below : {0, 1, 7, 30, 260}) {
            for (const Eigen::Index depth : {1, 2, 5, 31, 32, 100, 256}) {
                const Eigen::Index rows = columns + below;
                Panel a(waves(rows, depth, 1), rows + 1);
                const Matrix before = waves(rows, columns, 2);
                const Matrix product = a.all * a.all.topRows(columns).transpose();
                for (const bool overwrite : {false, true}) {
                    Panel c(before, rows + 2);
                    kernels().downdate(c.all.data(), rows + 2, rows, columns, a.all.data(), rows + 1, depth, overwrite,
                                       scratch());
                    Matrix expected = overwrite ? Matrix(-product) : Matrix(before - product);
                    for (Eigen::Index j = 1; j < columns; ++j)
                        expected.col(j).head(j).setZero();
                    ASSERT_LE((c.lower() - expected).cwiseAbs().maxCoeff(), 1e-13 * static_cast<double>(depth + 1))
                        << rows << "×" << columns << ", depth " << depth;
                    EXPECT_TRUE(c.untouched_outside());
                }
            }
        }
    }
}

TEST_P(DenseKernels, SolveForwardAndBackward) {
    for (const Eigen::Index columns : {1, 2, 3, 4, 5, 7, 8, 30}) {
        for (const Eigen::Index below : {0, 1, 3, 8, 9, 40}) {
            for (const Eigen::Index width : {Eigen::Index{1}, Eigen::Index{4}, Eigen::Index{dense::rhs_block}}) {
                const Eigen::Index rows = columns + below;
                Matrix l = waves(rows, columns, 0.5);
                l.diagonal().array() += 5;
                const Panel panel(l, rows + 1);
                const Matrix triangle = l.topRows(columns).triangularView<Eigen::Lower>();
                using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
                const RowMajor x = waves(rows, width, 3);
                RowMajor forward = x;
                kernels().forward(panel.all.data(), rows + 1, rows, columns, forward.data(), width);
                const Matrix own = triangle.triangularView<Eigen::Lower>().solve(Matrix(x.topRows(columns)));
                EXPECT_LE((forward.topRows(columns) - own).norm(), 1e-12 * (1 + own.norm()));
                EXPECT_LE((forward.bottomRows(below) - (x.bottomRows(below) - l.bottomRows(below) * own)).norm(),
                          1e-11);

                RowMajor backward = x;
                kernels().backward(panel.all.data(), rows + 1, rows, columns, backward.data(), width);
                const Matrix rest = x.topRows(columns) - l.bottomRows(below).transpose() * x.bottomRows(below);
                const Matrix solved = triangle.transpose().triangularView<Eigen::Upper>().solve(rest);
                EXPECT_LE((backward.topRows(columns) - solved).norm(), 1e-12 * (1 + solved.norm()));
                EXPECT_EQ(Matrix(backward.bottomRows(below)), Matrix(x.bottomRows(below)));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, DenseKernels, ::testing::ValuesIn(dense::kernels().begin(), dense::kernels().end()),
                         [](const auto& kernels) { return std::string(kernels.param->name); });

}  // namespace
}  // namespace polylap::test

#include "polylap/solve/eigenpairs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "polylap/solve/spd_factor.hpp"
#include "solve/block_lanczos.hpp"
#include "solve/symmetric_check.hpp"

namespace polylap {
namespace {

/// Up to this size the dense solver is the faster one. Measured: 100 rows 4 ms, 289 rows 95 ms; Lanczos takes
/// 3 ms for 20 pairs of 361 rows.
constexpr Index dense_limit = 100;

/// Up to this size the dense solver, within about a second, helps out where Lanczos does not converge: where nearly
/// all of the spectrum is one eigenvalue.
constexpr Index dense_rescue = 1000;

/// The shift stays below zero by this multiple of the mean |diagonal entry|: close to the spectrum, so that low
/// eigenvalues stand far apart after inversion, and far enough for a well-conditioned factor.
constexpr double first_shift = 1e-5;

/// Relative accuracy that Lanczos is asked for: what it leaves after inversion is as much of |S|∞ at most, before.
constexpr double lanczos_tolerance = 1e-10;

/// Measured, 30 pairs of a torus of 20 000 vertices: blocks of 1, 2, 3 and 4 take 105, 65, 45 and 42 solves, each of
/// about the same time.
constexpr Index lanczos_block = 3;

Error cancelled() {
    return {ErrorCode::cancelled, "cancelled"};
}

/// Counts matrix operations. How many there will be is not known: progress tends to 1.
class Progress {
public:
    Progress(Monitor monitor, Index expected) : monitor_(monitor), expected_(expected) {}
    bool step() {
        ++done_;
        return monitor_.proceed(done_ / (done_ + expected_));
    }

private:
    Monitor monitor_;
    double expected_;
    double done_ = 0;
};

/// X ↦ (S - σI)⁻¹ X, whose largest eigenvalues belong to the lowest of S.
BlockOperator inverse(const SpdFactor& factor, Progress& progress) {
    return [&](const Eigen::Ref<const Matrix>& x) -> Result<Matrix> {
        if (!progress.step()) return cancelled();
        return factor.solve(x);
    };
}

/// S + shift·I, with all of its diagonal stored.
SparseMatrix with_diagonal(const SparseMatrix& s, double shift) {
    SparseMatrix identity(s.rows(), s.cols());
    identity.setIdentity();
    return s + shift * identity;
}

/// Factors S - σI for a σ below the spectrum: a little below `origin`, and ten times as far until the factor exists.
/// @return σ
Result<double> factor_below(const SparseMatrix& s, double origin, SpdFactor& factor, Progress& progress) {
    const double first = std::max(first_shift * s.diagonal().cwiseAbs().mean(), 10 * pivot_tolerance);
    const double deepest = 3;  // |S|∞ is 1
    for (double depth = first;; depth = std::min(10 * depth, deepest)) {
        if (!progress.step()) return cancelled();
        const Status status = factor.factor(with_diagonal(s, depth - origin));
        if (status) return origin - depth;
        if (status.error().code != ErrorCode::not_positive_definite || depth == deepest) return status.error();
    }
}

/// The same for σ close to the spectrum, wherever that begins.
Status factor_below_spectrum(const SparseMatrix& s, SpdFactor& factor, Progress& progress) {
    const auto shift = factor_below(s, 0, factor, progress);
    if (!shift) return shift.error();
    if (*shift >= -2 * first_shift) return Done{};
    // Far below an indefinite spectrum the low eigenvalues hardly differ after inversion: come closer to the lowest.
    const auto largest = largest_eigenpairs(inverse(factor, progress), Matrix(s.rows(), 0), {.tolerance = 1e-3});
    if (!largest) return largest.error();
    const auto closer = factor_below(s, *shift + 1 / largest->values[0], factor, progress);
    if (!closer) return closer.error();
    return Done{};
}

/// All eigenpairs of a dense symmetric matrix.
Result<Eigenpairs> solve_densely(Matrix a) {
    Eigen::SelfAdjointEigenSolver<Matrix> solver(a);
    if (solver.info() == Eigen::Success) return Eigenpairs{solver.eigenvalues(), solver.eigenvectors()};
    // Eigen ends where an entry is small against its neighbours on the diagonal, which may never be where many
    // eigenvalues are 0: moved up by the size of the matrix, the neighbours are of that size.
    const double shift = a.cwiseAbs().rowwise().sum().maxCoeff();
    a.diagonal().array() += shift;
    solver.compute(a);
    if (solver.info() == Eigen::Success) {
        return Eigenpairs{solver.eigenvalues().array() - shift, solver.eigenvectors()};
    }
    return Error{ErrorCode::not_converged, "the eigenvalues of the matrix were not found"};
}

/// Eigenpairs of S within the span of the columns.
Result<Eigenpairs> rayleigh_ritz(const SparseMatrix& s, const Matrix& span) {
    const Matrix q = Eigen::HouseholderQR<Matrix>(span).householderQ() * Matrix::Identity(span.rows(), span.cols());
    const Matrix projected = q.transpose() * (s * q);
    auto pairs = solve_densely(0.5 * (projected + projected.transpose()));
    if (pairs) pairs->vectors = q * pairs->vectors;
    return pairs;
}

/// The same eigenvectors with their Rayleigh quotients, ascending.
Eigenpairs in_order(const SparseMatrix& s, Matrix vectors) {
    const Vector values = vectors.cwiseProduct(s * vectors).colwise().sum();
    std::vector<Index> order(static_cast<std::size_t>(values.size()));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return values[a] < values[b]; });
    return {values(order), vectors(Eigen::all, order)};
}

Eigenpairs head(const Eigenpairs& pairs, Index count) {
    return {pairs.values.head(count), pairs.vectors.leftCols(count)};
}

/// How many eigenvalues of S below the last one found are missing.
Result<Index> count_missing(const SparseMatrix& s, const Vector& values) {
    // Within the tolerance it does not matter on which side an eigenvalue falls: some shift there will do.
    for (const double share : {0.5, 0.37, 0.71, 0.23, 0.86}) {
        const double shift = values[values.size() - 1] - share * eigenpair_tolerance;
        const auto below = count_eigenvalues_below(s, shift);
        if (!below && below.error().code == ErrorCode::not_converged) continue;
        if (!below) return below.error();
        return std::max<Index>(0, *below - static_cast<Index>((values.array() < shift).count()));
    }
    return Error{ErrorCode::not_converged, "the eigenvalues could not be counted"};
}

Result<Eigenpairs> dense_eigenpairs(const SparseMatrix& s, Index count, Monitor monitor) {
    if (!monitor.proceed(0)) return cancelled();
    const auto pairs = solve_densely(Matrix(s));
    if (!pairs) return pairs.error();
    return head(*pairs, count);
}

/// @param s |S|∞ = 1
Result<Eigenpairs> sparse_eigenpairs(const SparseMatrix& s, Index count, const Points& positions, Monitor monitor) {
    const auto n = static_cast<Index>(s.rows());
    Progress progress(monitor, 4 * count);
    SpdFactor factor;
    if (Status status = factor.analyse(with_diagonal(s, 0), positions); !status) return status.error();
    if (Status status = factor_below_spectrum(s, factor, progress); !status) return status.error();

    Eigenpairs pairs{Vector(0), Matrix(n, 0)};
    LanczosOptions options{.block = lanczos_block, .tolerance = lanczos_tolerance};
    const auto add = [&](Matrix vectors) -> Status {
        if (pairs.vectors.cols() == 0) {
            pairs = in_order(s, std::move(vectors));
            return Done{};
        }
        Matrix span(n, pairs.vectors.cols() + vectors.cols());
        span << pairs.vectors, vectors;
        const auto all = rayleigh_ritz(s, span);
        if (!all) return all.error();
        pairs = head(*all, count);
        return Done{};
    };
    const auto find_more = [&](Index more) -> Status {
        options.pairs = std::min(more, count);
        ++options.start;
        auto found = largest_eigenpairs(inverse(factor, progress), pairs.vectors, options);
        return found ? add(std::move(found->vectors)) : found.error();
    };
    // A Krylov space meets each eigenspace in as many directions as a block has; rounding brings in others, but not
    // surely all. What one run misses, the next one finds in the complement.
    for (Index missing = count; missing > 0;) {
        if (Status status = find_more(missing); !status) return status.error();
        if (!progress.step()) return cancelled();
        const auto left = count_missing(s, pairs.values);
        if (!left && left.error().code != ErrorCode::not_converged) return left.error();
        if (left) {
            missing = *left;
            continue;
        }
        // On symmetric meshes, leading blocks may share the eigenvalue: then the lowest of the complement has to tell.
        const double before = pairs.values.sum();
        if (Status status = find_more(1); !status) return status.error();
        missing = pairs.values.sum() < before - eigenpair_tolerance ? 1 : 0;
    }

    const Matrix residual = s * pairs.vectors - pairs.vectors * pairs.values.asDiagonal();
    if (!(residual.colwise().norm().maxCoeff() <= eigenpair_tolerance)) {
        return Error{ErrorCode::not_converged, "the eigenvectors are not accurate"};
    }
    return pairs;
}

}  // namespace

Result<Eigenpairs> lowest_eigenpairs(const SparseMatrix& symmetric, Index count, Monitor monitor,
                                     const Points& positions) {
    return guard_memory([&]() -> Result<Eigenpairs> {
        if (Status status = check_symmetric(symmetric); !status) return status.error();
        if (count < 1) return Error{ErrorCode::bad_argument, "at least one eigenpair must be asked for"};
        const auto n = static_cast<Index>(symmetric.rows());
        count = std::min(count, n);
        const double scale = largest_row_sum(symmetric);
        if (scale == 0) return Eigenpairs{Vector::Zero(count), Matrix::Identity(n, count)};
        const SparseMatrix unit = symmetric / scale;
        auto pairs = n <= dense_limit || count > n / 4 ? dense_eigenpairs(unit, count, monitor)
                                                       : sparse_eigenpairs(unit, count, positions, monitor);
        if (!pairs && pairs.error().code == ErrorCode::not_converged && n <= dense_rescue) {
            pairs = dense_eigenpairs(unit, count, monitor);
        }
        if (pairs) pairs->values *= scale;
        if (pairs && !monitor.proceed(1)) return cancelled();
        return pairs;
    });
}

Result<double> largest_eigenvalue(const SparseMatrix& symmetric, Monitor monitor) {
    return guard_memory([&]() -> Result<double> {
        if (Status status = check_symmetric(symmetric); !status) return status.error();
        const auto n = static_cast<Index>(symmetric.rows());
        if (n == 0) return Error{ErrorCode::bad_argument, "an empty matrix has no eigenvalues"};
        const double scale = largest_row_sum(symmetric);
        if (scale == 0) return 0.0;
        if (n <= dense_limit) {
            auto all = dense_eigenpairs(symmetric, n, monitor);
            if (!all) return all.error();
            return all->values[n - 1];
        }
        Progress progress(monitor, 100);
        const SparseMatrix unit = symmetric / scale;
        constexpr double shift = 2;  // eigenvalues in [1, 3]: accuracy relative to |S|∞
        const BlockOperator product = [&](const Eigen::Ref<const Matrix>& x) -> Result<Matrix> {
            if (!progress.step()) return cancelled();
            return Matrix(unit * x + shift * x);
        };
        const auto top = largest_eigenpairs(product, Matrix(n, 0), {.tolerance = 3e-7});
        if (!top) return top.error();
        return (top->values[0] - shift) * scale;
    });
}

}  // namespace polylap

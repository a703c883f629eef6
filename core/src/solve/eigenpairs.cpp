#include "polylap/solve/eigenpairs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Spectra/SymEigsSolver.h>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "polylap/solve/spd_factor.hpp"
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
constexpr double lanczos_tolerance = 1e-11;

/// Restarts of one Lanczos run, so that it ends.
constexpr Eigen::Index most_restarts = 1000;

/// Leaves Spectra, which has no other way out; caught in this file.
struct Stopped {
    Error error;
};

/// Runs `work` and turns what Spectra throws into an Error.
template <class Work>
auto guard_spectra(Work&& work) -> decltype(work()) {
    try {
        return guard_memory(std::forward<Work>(work));
    } catch (const Stopped& stopped) {
        return stopped.error;
    } catch (const std::invalid_argument& e) {  // e.g. a start vector of length 0
        return Error{ErrorCode::not_converged, e.what()};
    } catch (const std::runtime_error& e) {
        return Error{ErrorCode::not_converged, e.what()};
    }
}

/// Counts matrix operations. How many there will be is not known: progress tends to 1.
class Progress {
public:
    Progress(Monitor monitor, Index expected) : monitor_(monitor), expected_(expected) {}
    void step() {
        ++done_;
        if (!monitor_.proceed(done_ / (done_ + expected_))) throw Stopped{{ErrorCode::cancelled, "cancelled"}};
    }

private:
    Monitor monitor_;
    double expected_;
    double done_ = 0;
};

/// x ↦ P (S - σI)⁻¹ P x, P orthogonal to the eigenvectors found so far: its largest eigenvalues belong to the lowest of
/// S that are missing.
class DeflatedInverse {
public:
    using Scalar = double;

    DeflatedInverse(const SpdFactor& factor, const Matrix& found, Progress& progress)
        : factor_(factor), found_(found), progress_(progress) {}

    Eigen::Index rows() const { return factor_.size(); }
    Eigen::Index cols() const { return factor_.size(); }
    void perform_op(const double* in, double* out) const {
        progress_.step();
        auto solved = factor_.solve(project(Eigen::Map<const Vector>(in, rows())));
        if (!solved) throw Stopped{solved.error()};
        Eigen::Map<Vector>(out, rows()) = project(*solved);
    }
    Vector project(Vector x) const {
        for (int twice = 0; twice < 2 && found_.cols() > 0; ++twice) {  // once leaves rounding of the larger part
            x -= found_ * (found_.transpose() * x);
        }
        return x;
    }

private:
    const SpdFactor& factor_;
    const Matrix& found_;
    Progress& progress_;
};

/// x ↦ (S + shift·I) x
class ShiftedProduct {
public:
    using Scalar = double;

    ShiftedProduct(const SparseMatrix& s, double shift, Progress& progress)
        : s_(s), shift_(shift), progress_(progress) {}

    Eigen::Index rows() const { return s_.rows(); }
    Eigen::Index cols() const { return s_.rows(); }
    void perform_op(const double* in, double* out) const {
        progress_.step();
        const Eigen::Map<const Vector> x(in, rows());
        Eigen::Map<Vector>(out, rows()) = s_ * x + shift_ * x;
    }

private:
    const SparseMatrix& s_;
    double shift_;
    Progress& progress_;
};

/// Size of the Krylov space for so many pairs.
Eigen::Index krylov_size(Index pairs, Index rows) {
    return std::min(std::max(2 * pairs + 1, 20), rows);
}

/// The largest eigenvalues of an operator, descending, and their eigenvectors.
template <class Operator>
Eigenpairs lanczos(Operator& op, Index pairs, const Vector& start, double tolerance) {
    Spectra::SymEigsSolver<Operator> solver(op, pairs, krylov_size(pairs, static_cast<Index>(op.rows())));
    solver.init(start.data());
    if (solver.compute(Spectra::SortRule::LargestAlge, most_restarts, tolerance) < pairs) {
        throw Stopped{{ErrorCode::not_converged, "the eigenvalues did not converge"}};
    }
    return {solver.eigenvalues(), solver.eigenvectors()};
}

/// Without a preferred direction, and always the same.
Vector start_vector(Eigen::Index rows, Eigen::Index seed) {
    return Spectra::SimpleRandom<double>(static_cast<unsigned long>(seed)).random_vec(rows);
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
        progress.step();
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
    const Matrix none(s.rows(), 0);
    DeflatedInverse inverse(factor, none, progress);
    const double largest = lanczos(inverse, 1, start_vector(s.rows(), 0), 1e-3).values[0];
    const auto closer = factor_below(s, *shift + 1 / largest, factor, progress);
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
    if (!monitor.proceed(0)) return Error{ErrorCode::cancelled, "cancelled"};
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
    DeflatedInverse inverse(factor, pairs.vectors, progress);
    Eigen::Index seed = 0;
    const auto find_more = [&](Index more) {
        return lanczos(inverse, more, inverse.project(start_vector(n, ++seed)), lanczos_tolerance).vectors;
    };
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
    // A Krylov space meets each eigenspace in one direction; rounding brings in others, but not surely all. What one
    // run misses, the next one finds in the complement.
    for (Index missing = count; missing > 0;) {
        if (Status status = add(find_more(std::min(missing, count))); !status) return status.error();
        progress.step();
        const auto left = count_missing(s, pairs.values);
        if (!left && left.error().code != ErrorCode::not_converged) return left.error();
        if (left) {
            missing = *left;
            continue;
        }
        // On symmetric meshes, leading blocks may share the eigenvalue: then the lowest of the complement has to tell.
        const double before = pairs.values.sum();
        if (Status status = add(find_more(1)); !status) return status.error();
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
    return guard_spectra([&]() -> Result<Eigenpairs> {
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
        if (pairs && !monitor.proceed(1)) return Error{ErrorCode::cancelled, "cancelled"};
        return pairs;
    });
}

Result<double> largest_eigenvalue(const SparseMatrix& symmetric, Monitor monitor) {
    return guard_spectra([&]() -> Result<double> {
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
        ShiftedProduct product(unit, 2, progress);  // eigenvalues in [1, 3]: accuracy relative to |S|∞
        return (lanczos(product, 1, start_vector(n, 0), 3e-7).values[0] - 2) * scale;
    });
}

}  // namespace polylap

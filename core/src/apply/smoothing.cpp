#include "polylap/apply/smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "apply/smoothing_cost.hpp"
#include "polylap/solve/conjugate_gradients.hpp"
#include "solve/fixed_vertices.hpp"
#include "solve/held_rows.hpp"
#include "solve/lower_triangle.hpp"
#include "solve/sparse_loops.hpp"

namespace polylap {
namespace {

/// S keeps constants where no row sum exceeds this multiple of the sum of its absolute values in M + tS: far above the
/// rounding of sums over faces, and no more than the solvers leave.
constexpr double constants_rounding = 1e-12;

/// Up to this size a factor costs next to nothing (2000 rows: 2 ms).
constexpr Eigen::Index always_factored = 2000;

bool stores_diagonal(const SparseMatrix& a) {
    for (Index k = 0; k < a.cols(); ++k) {
        const Index* const begin = a.innerIndexPtr() + a.outerIndexPtr()[k];
        const Index* const end = a.innerIndexPtr() + a.outerIndexPtr()[k + 1];
        if (!std::binary_search(begin, end, k)) return false;
    }
    return true;
}

/// t S + diag(d), or the lower triangle of it, of a compressed S that stores its diagonal.
SparseMatrix add(const SparseMatrix& s, double t, const Vector& d, bool lower) {
    SparseMatrix sum;
    if (lower)
        lower_triangle(s).swap(sum);
    else
        sum = s;
    sum.coeffs() *= t;
    for (Index k = 0; k < sum.cols(); ++k) {
        const Index* const begin = sum.innerIndexPtr() + sum.outerIndexPtr()[k];
        const Index* const end = sum.innerIndexPtr() + sum.outerIndexPtr()[k + 1];
        sum.valuePtr()[std::lower_bound(begin, end, k) - sum.innerIndexPtr()] += d[k];
    }
    return sum;
}

void release(SparseMatrix& a) {
    SparseMatrix().swap(a);
}

}  // namespace

std::string_view solver_name(SmoothingSolver solver) noexcept {
    switch (solver) {
        case SmoothingSolver::cholesky:
            return "cholesky";
        case SmoothingSolver::lu:
            return "lu";
        case SmoothingSolver::diagonal:
            return "diagonal";
        case SmoothingSolver::conjugate_gradients:
            break;
    }
    return "conjugate-gradients";
}

Result<ImplicitSmoother> ImplicitSmoother::create(const OperatorMatrices& matrices, double time,
                                                  const SmootherOptions& options, Monitor monitor) {
    return guard_memory([&]() -> Result<ImplicitSmoother> {
        ImplicitSmoother smoother;
        if (Status status = smoother.update(matrices, time, options, monitor); !status) return status.error();
        return smoother;
    });
}

ImplicitSmoother::ImplicitSmoother() : iterations_per_root_condition_(SmoothingCost::iterations_per_root_condition) {}

const std::shared_ptr<const SpdAnalysis>& ImplicitSmoother::analysis() const noexcept {
    return factor_.analysis();
}

Status ImplicitSmoother::update(const OperatorMatrices& matrices, double time, const SmootherOptions& options,
                                Monitor monitor) {
    if (Status status = update_later(matrices, time, options); !status) return status;
    return guard_memory([&]() -> Status {
        const bool factor_now = needs_factor();
        ready_ = false;
        if (!monitor.proceed(0)) return Error{ErrorCode::cancelled, "cancelled"};
        if (factor_now) {
            if (Status status = factor(monitor); !status) return status;
        }
        ready_ = true;
        return Done{};
    });
}

Status ImplicitSmoother::update_later(const OperatorMatrices& matrices, double time, const SmootherOptions& options) {
    ready_ = factored_ = false;
    if (!(time > 0) || !std::isfinite(time)) {
        return Error{ErrorCode::bad_argument, "the time step must be a positive number"};
    }
    const auto n = matrices.stiffness.rows();
    if (matrices.stiffness.cols() != n || matrices.mass.rows() != n || matrices.mass.cols() != n) {
        return Error{ErrorCode::bad_argument, "stiffness and mass must be square and of the same size"};
    }
    return guard_memory([&]() -> Status {
        Status status = build(matrices, time, options);
        ready_ = status.ok();
        return status;
    });
}

bool ImplicitSmoother::needs_factor() const {
    return ready_ && !factored_ && !(whole_ && iterations_pay());
}

Status ImplicitSmoother::build(const OperatorMatrices& matrices, double time, const SmootherOptions& options) {
    release(system_);
    coupling_.clear();
    const auto n = static_cast<Index>(matrices.mass.rows());
    fixed_.assign(options.fixed.begin(), options.fixed.end());
    const auto place = places_of(fixed_, n);
    if (!place) return place.error();
    const auto held = [&](Index v) { return (*place)[static_cast<std::size_t>(v)] >= 0; };
    Vector diagonal = matrices.mass.diagonal();
    Vector unused = Vector::Zero(n);
    for (Index v = 0; v < n; ++v) {
        if (diagonal[v] > 0) continue;
        if (!held(v) && (!is_zero(matrices.stiffness, v) || !is_zero(matrices.mass, v))) {
            return Error{ErrorCode::mass_not_positive, "the mass of vertex " + std::to_string(v) + " is not positive",
                         v};
        }
        diagonal[v] = unused[v] = 1;  // in no face: 1 x' = 1 x
    }
    mass_ = matrices.mass;
    if (unused.any()) add_diagonal(mass_, unused);

    // M + tS = factor · part + diag(added)
    SparseMatrix sum;
    const SparseMatrix* part = &matrices.stiffness;
    double factor = time;
    Vector added = diagonal;
    if (!fixed_.empty() || !is_diagonal(mass_) || !part->isCompressed() || !stores_diagonal(*part)) {
        sum = time * matrices.stiffness;
        sum += mass_;
        part = &sum;
        factor = 1;
        added.setZero();
    }
    entries_ = static_cast<double>(part->nonZeros());

    condition_ = 0;
    keeps_constants_ = matrices.structure != Structure::general;  // whose columns are not its rows
    for (Index k = 0; k < n; ++k) {
        double size = 0;
        double excess = 0;  // of column k of tS
        for (SparseMatrix::InnerIterator it(*part, k); it; ++it) {
            const double value = factor * it.value() + (it.index() == k ? added[k] : 0);
            size += std::abs(value);
            excess += value;
        }
        for (SparseMatrix::InnerIterator it(mass_, k); it; ++it) {
            excess -= it.value();
        }
        condition_ += size / diagonal[k] / n;
        keeps_constants_ = keeps_constants_ && std::abs(excess) <= constants_rounding * size;
    }

    if (!fixed_.empty()) {
        // (M + tS)_II x'_I = M_II x_I - t S_IB x_B: what M couples to fixed vertices is the same on both sides.
        coupling_ = held_entries(matrices.stiffness, time, *place);
        Vector own = sum.diagonal();
        for (double& entry : own)
            if (!(entry > 0)) entry = 1;
        hold_rows(sum, *place, own);
        hold_rows(mass_, *place, own);
    }

    structure_ = matrices.structure;
    choice_ = options.choice;
    steps_to_come_ = std::max(1, options.steps);
    iterations_spent_ = 0;
    positions_ = options.positions;
    const bool definite = structure_ == Structure::positive_semidefinite;
    whole_ = !definite;
    add(*part, factor, added, definite).swap(system_);
    const auto fits = [this](const auto& known) { return known != nullptr && known->fits(system_); };
    analysed_ = fits(analysis());
    if (const auto known = std::find_if(options.known.begin(), options.known.end(), fits);
        !analysed_ && known != options.known.end()) {
        factor_.use(*known);
        analysed_ = true;
    }
    if (iterations_pay() && !whole_) {
        whole_ = true;
        add(*part, factor, added, false).swap(system_);
    }
    return Done{};
}

SmoothingCost ImplicitSmoother::cost() const {
    return {static_cast<double>(mass_.rows()), entries_, analysed_ ? analysis().get() : nullptr,
            lost_without_analysis_};
}

double ImplicitSmoother::iterations_worth_a_factor() const {
    const SmoothingCost cost = this->cost();
    const double factor = cost.factor() + steps_to_come_ * cost.solve();
    return (factor / cost.iteration() - iterations_spent_) / steps_to_come_ - SmoothingCost::preparing;
}

bool ImplicitSmoother::iterations_pay() const {
    if (structure_ != Structure::positive_semidefinite) return false;
    if (choice_ != SmootherOptions::Choice::automatic) return choice_ == SmootherOptions::Choice::iterative;
    if (mass_.rows() <= always_factored) return false;
    return iterations_per_root_condition_ * std::sqrt(condition_) < iterations_worth_a_factor();
}

Status ImplicitSmoother::factor(Monitor monitor) {
    const bool definite = structure_ == Structure::positive_semidefinite;
    if (definite && whole_) {  // iterations were to read it
        lower_triangle(system_).swap(system_);
        whole_ = false;
    }
    const Points nowhere;
    Status status = factor_.factor(system_, structure_, positions_ == nullptr ? nowhere : *positions_, monitor);
    factored_ = status.ok();
    if (factored_) release(system_);
    if (factored_ || status.error().code != ErrorCode::not_positive_definite) return status;
    Error error = status.error();
    error.message = std::string("M + tS is ") + (definite ? "not positive definite" : "singular");
    if (error.element >= 0) error.message += " at vertex " + std::to_string(error.element);
    error.message += ", where the surface may have collapsed, or t is too large";
    return error;
}

Result<Points> ImplicitSmoother::step(const Points& points, Monitor monitor) {
    if (!ready_) return Error{ErrorCode::bad_argument, "there is no system to solve"};
    if (points.rows() != mass_.rows()) {
        return Error{ErrorCode::bad_argument, "the operator has " + std::to_string(mass_.rows()) + " vertices, but " +
                                                  std::to_string(points.rows()) + " points were given"};
    }
    if (!points.allFinite()) return Error{ErrorCode::bad_argument, "the points must be finite"};
    return guard_memory([&]() -> Result<Points> {
        // Around their centre, so that what is small against the points is small against the surface.
        Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
        if (keeps_constants_ && points.rows() > 0) centre = points.colwise().mean();
        auto moved = solve(points.rowwise() - centre, monitor);
        if (moved) {
            moved->rowwise() += centre;
            for (const Index v : fixed_)
                moved->row(v) = points.row(v);
        }
        steps_to_come_ = std::max(1, steps_to_come_ - 1);
        return moved;
    });
}

Result<Points> ImplicitSmoother::solve(const Points& points, Monitor monitor) {
    Points rhs = mass_ * points;
    for (const auto& entry : coupling_)
        rhs.row(entry.row()) -= entry.value() * points.row(entry.col());
    double done = 0;
    if (!factored_ && !needs_factor()) {
        constexpr double iterating = 0.9;  // of the progress; a factor takes the rest where that fails
        Stretch stretch{monitor, done, iterating};
        auto moved = iterate(points, rhs, stretch.monitor());
        if (moved) return moved;
        const ErrorCode code = moved.error().code;
        if (code != ErrorCode::not_converged && code != ErrorCode::not_positive_definite) return moved;
        done = iterating;
    }
    if (!factored_) {
        Stretch stretch{monitor, done, 1};
        if (Status status = factor(stretch.monitor()); !status) return status.error();
    }
    const auto moved = factor_.solve(rhs);
    if (!moved) return moved.error();
    last_ = {factor_.is_cholesky() ? SmoothingSolver::cholesky : SmoothingSolver::lu, 0};
    return Points(*moved);
}

Result<Points> ImplicitSmoother::iterate(const Points& points, const Points& rhs, Monitor monitor) {
    GradientOptions options;
    if (choice_ == SmootherOptions::Choice::automatic) {  // where the forecast fails, no more than a factor is lost
        options.most_iterations = static_cast<int>(std::min(std::ceil(iterations_worth_a_factor()), 1e9));
    }
    auto moved = conjugate_gradients(system_, rhs, points, options, monitor);
    const bool failed = !moved && moved.error().code == ErrorCode::not_converged;
    const int iterations = moved ? moved->iterations : options.most_iterations;
    if (moved || failed) {
        iterations_spent_ += iterations;
        lost_without_analysis_ += cost().loss(iterations);
        // So that what failed is not tried again on a system like it.
        iterations_per_root_condition_ = (iterations + 1) / std::sqrt(condition_);
    }
    if (!moved) return moved.error();
    last_ = {SmoothingSolver::conjugate_gradients, iterations};
    return std::move(moved->x);
}

}  // namespace polylap

#include "polylap/apply/explicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "polylap/solve/conjugate_gradients.hpp"
#include "solve/fixed_vertices.hpp"
#include "solve/held_rows.hpp"
#include "solve/pencil_ends.hpp"
#include "solve/sparse_loops.hpp"

namespace polylap {
namespace {

/// Weights of the rows that make S symmetric agree along all edges within this.
constexpr double symmetric_rounding = 1e-9;

/// S 1 = 0 where no row sum exceeds this multiple of the sum of its absolute values.
constexpr double constants_rounding = 1e-12;

/// Which rows stand still: fixed vertices and those in no face.
struct Rows {
    std::vector<Index> place;  ///< V, -1: moves.

    static Result<Rows> of(const OperatorMatrices& matrices, std::span<const Index> fixed) {
        const auto& [stiffness, mass] = std::tie(matrices.stiffness, matrices.mass);
        const auto n = static_cast<Index>(stiffness.rows());
        if (stiffness.cols() != n || mass.rows() != n || mass.cols() != n)
            return Error{ErrorCode::bad_argument, "stiffness and mass must be square and of the same size"};
        auto place = places_of(fixed, n);
        if (!place) return place.error();
        const Vector diagonal = mass.diagonal();
        for (Index v = 0; v < n; ++v) {
            Index& at = (*place)[static_cast<std::size_t>(v)];
            if (diagonal[v] > 0 || at >= 0) continue;
            if (!is_zero(stiffness, v) || !is_zero(mass, v)) {
                return Error{ErrorCode::mass_not_positive,
                             "the mass of vertex " + std::to_string(v) + " is not positive", v};
            }
            at = n;
        }
        return Rows{*std::move(place)};
    }

    /// M with those rows cut off: 1 on the diagonal, stored.
    SparseMatrix mass(const SparseMatrix& m) const {
        Vector still(m.rows());
        for (Eigen::Index v = 0; v < still.size(); ++v)
            still[v] = place[static_cast<std::size_t>(v)] >= 0 ? 1 : 0;
        SparseMatrix cut = m;
        add_diagonal(cut, still);
        hold_rows(cut, place, still);
        return cut;
    }
};

Error not_definite(Error error) {
    error.code = ErrorCode::mass_not_positive;
    error.message = "the mass is not positive definite";
    if (error.element >= 0) error.message += " at vertex " + std::to_string(error.element);
    return error;
}

bool keeps_constants(const SparseMatrix& s) {
    Vector sums = Vector::Zero(s.rows());
    Vector sizes = Vector::Zero(s.rows());
    for (Index k = 0; k < s.cols(); ++k) {
        for (SparseMatrix::InnerIterator it(s, k); it; ++it) {
            sums[it.index()] += it.value();
            sizes[it.index()] += std::abs(it.value());
        }
    }
    for (Eigen::Index k = 0; k < sums.size(); ++k)
        if (!(std::abs(sums[k]) <= constants_rounding * sizes[k])) return false;
    return true;
}

/// d > 0 for which diag(d) S is symmetric, if there are any: as for a random walk that can go both ways alike
/// (Kolmogorov's criterion).
std::optional<Vector> symmetriser(const SparseMatrix& s) {
    Vector d = Vector::Zero(s.rows());
    std::vector<Index> queue;
    for (Index first = 0; first < s.cols(); ++first) {
        if (d[first] != 0) continue;
        d[first] = 1;
        queue.push_back(first);
        while (!queue.empty()) {
            const Index i = queue.back();
            queue.pop_back();
            for (SparseMatrix::InnerIterator it(s, i); it; ++it) {
                const auto j = static_cast<Index>(it.index());
                const double there = s.coeff(i, j);
                if (it.value() == 0 && there == 0) continue;
                const double wanted = d[i] * there / it.value();
                if (!(wanted > 0 && std::isfinite(wanted))) return std::nullopt;
                if (d[j] == 0) {
                    d[j] = wanted;
                    queue.push_back(j);
                } else if (std::abs(d[j] - wanted) > symmetric_rounding * wanted) {
                    return std::nullopt;
                }
            }
        }
    }
    return d;
}

}  // namespace

Result<SmoothingStep> explicit_step(const OperatorMatrices& matrices, double time, const Points& points,
                                    std::span<const Index> fixed, Monitor monitor) {
    if (!(time > 0) || !std::isfinite(time))
        return Error{ErrorCode::bad_argument, "the time step must be a positive number"};
    if (points.rows() != matrices.stiffness.rows()) {
        return Error{ErrorCode::bad_argument, "the operator has " + std::to_string(matrices.stiffness.rows()) +
                                                  " vertices, but " + std::to_string(points.rows()) +
                                                  " points were given"};
    }
    if (!points.allFinite()) return Error{ErrorCode::bad_argument, "the points must be finite"};
    return guard_memory([&]() -> Result<SmoothingStep> {
        const auto rows = Rows::of(matrices, fixed);
        if (!rows) return rows.error();
        if (!monitor.proceed(0)) return Error{ErrorCode::cancelled, "cancelled"};
        // Around their centre, so that what is small against the points is small against the surface.
        Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
        if (points.rows() > 0 && keeps_constants(matrices.stiffness)) centre = points.colwise().mean();
        Points centred = points;
        centred.rowwise() -= centre;
        Points flow(points.rows(), 3);
        multiply(matrices.stiffness, centred.data(), 3, flow.data());
        for (Index v = 0; v < flow.rows(); ++v)
            if (rows->place[static_cast<std::size_t>(v)] >= 0) flow.row(v).setZero();

        const SparseMatrix mass = rows->mass(matrices.mass);
        SmoothingStep step{{}, {SmoothingSolver::diagonal, 0}};
        if (is_diagonal(mass)) {
            for (Index v = 0; v < flow.rows(); ++v)
                flow.row(v) /= mass.coeff(v, v);
        } else {
            Stretch solving{monitor, 0.2, 1};
            auto solved = conjugate_gradients(mass, flow, Points::Zero(flow.rows(), 3), {}, solving.monitor());
            if (!solved) {
                const bool indefinite = solved.error().code == ErrorCode::not_positive_definite;
                return indefinite ? not_definite(solved.error()) : solved.error();
            }
            flow = std::move(solved->x);
            step.solve = {SmoothingSolver::conjugate_gradients, solved->iterations};
        }
        step.points = points;
        for (Index v = 0; v < step.points.rows(); ++v) {
            step.points.row(v) -= time * flow.row(v);
            if (step.points.row(v).cwiseAbs().maxCoeff() <= largest_coordinate && step.points.row(v).allFinite())
                continue;
            return Error{ErrorCode::not_converged,
                         "this explicit step would take vertex " + std::to_string(v) +
                             " beyond what can be computed with: the steps are unstable, and each is larger than the "
                             "one before",
                         v};
        }
        return step;
    });
}

Result<Stability> explicit_stability(const OperatorMatrices& matrices, std::span<const Index> fixed, Monitor monitor) {
    return guard_memory([&]() -> Result<Stability> {
        const auto rows = Rows::of(matrices, fixed);
        if (!rows) return rows.error();
        SparseMatrix s = matrices.stiffness;
        SparseMatrix mass = matrices.mass;
        if (matrices.structure == Structure::general) {
            const auto weights = symmetriser(s);
            if (!weights || !is_diagonal(mass)) {
                return Error{ErrorCode::bad_argument,
                             "the stiffness is not symmetric, nor becomes so by weights for its rows: no bound of its "
                             "explicit steps is known"};
            }
            for (SparseMatrix* const a : {&s, &mass})
                for (Index k = 0; k < a->cols(); ++k)
                    for (SparseMatrix::InnerIterator it(*a, k); it; ++it)
                        it.valueRef() *= (*weights)[it.index()];
        }
        hold_rows(s, rows->place, Vector::Zero(s.rows()));
        const bool definite = matrices.structure == Structure::positive_semidefinite;
        const auto ends = pencil_ends(s, rows->mass(mass), !definite, monitor);
        if (!ends) {
            const bool mass_failed = ends.error().code == ErrorCode::not_positive_definite;
            return mass_failed ? not_definite(ends.error()) : ends.error();
        }
        const bool negative = !definite && ends->smallest < -negative_eigenvalue_tolerance * ends->largest;
        return Stability{std::max(0.0, ends->largest), negative ? ends->smallest : 0};
    });
}

}  // namespace polylap

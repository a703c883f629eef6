#include "polylap/apply/smoothing.hpp"

#include <cmath>
#include <string>

namespace polylap {
namespace {

/// Not 0 at the columns with a nonzero (or no finite) entry.
Vector columns_in_use(const SparseMatrix& a) {
    Vector used = Vector::Zero(a.cols());
    for (Index k = 0; k < a.cols(); ++k) {
        for (SparseMatrix::InnerIterator it(a, k); it; ++it) {
            if (it.value() != 0) used[k] = 1;
        }
    }
    return used;
}

}  // namespace

Result<ImplicitSmoother> ImplicitSmoother::create(const OperatorMatrices& matrices, double time) {
    return guard_memory([&]() -> Result<ImplicitSmoother> {
        ImplicitSmoother smoother;
        if (Status status = smoother.update(matrices, time); !status) return status.error();
        return smoother;
    });
}

Status ImplicitSmoother::update(const OperatorMatrices& matrices, double time) {
    if (!(time > 0) || !std::isfinite(time)) {
        return Error{ErrorCode::bad_argument, "the time step must be a positive number"};
    }
    const auto n = matrices.stiffness.rows();
    if (matrices.stiffness.cols() != n || matrices.mass.rows() != n || matrices.mass.cols() != n) {
        return Error{ErrorCode::bad_argument, "stiffness and mass must be square and of the same size"};
    }
    return guard_memory([&]() -> Status {
        const Vector used = columns_in_use(matrices.stiffness) + columns_in_use(matrices.mass);
        const Vector diagonal = matrices.mass.diagonal();
        Vector unused = Vector::Zero(n);
        for (Index v = 0; v < n; ++v) {
            if (used[v] == 0) {
                unused[v] = 1;  // in no face: 1 x' = 1 x
            } else if (!(diagonal[v] > 0)) {
                return Error{ErrorCode::mass_not_positive,
                             "the mass of vertex " + std::to_string(v) + " is not positive", v};
            }
        }
        SparseMatrix mass = matrices.mass;
        mass += SparseMatrix(unused.asDiagonal());
        SparseMatrix system = time * matrices.stiffness;
        system += mass;
        if (Status status = factor_.factor(system, matrices.structure); !status) {
            Error error = status.error();
            if (error.code == ErrorCode::not_positive_definite) {
                const bool definite = matrices.structure == Structure::positive_semidefinite;
                error.message = std::string("M + tS is ") + (definite ? "not positive definite" : "singular");
                if (error.element >= 0) error.message += " at vertex " + std::to_string(error.element);
                error.message += ", where the surface may have collapsed, or t is too large";
            }
            return error;
        }
        mass_.swap(mass);
        return Done{};
    });
}

Result<Points> ImplicitSmoother::step(const Points& points) const {
    if (points.rows() != mass_.rows()) {
        return Error{ErrorCode::bad_argument, "the operator has " + std::to_string(mass_.rows()) + " vertices, but " +
                                                  std::to_string(points.rows()) + " points were given"};
    }
    if (!points.allFinite()) return Error{ErrorCode::bad_argument, "the points must be finite"};
    return guard_memory([&]() -> Result<Points> {
        const auto moved = factor_.solve(mass_ * points);
        if (!moved) return moved.error();
        return Points(*moved);
    });
}

}  // namespace polylap

#include "polylap/apply/smoothing.hpp"

#include <cmath>
#include <string>

namespace polylap {

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
        Vector mass = matrices.mass.diagonal();
        const Vector stiffness = matrices.stiffness.diagonal();
        for (Index v = 0; v < mass.size(); ++v) {
            if (mass[v] == 0 && stiffness[v] == 0) {
                mass[v] = 1;  // in no face: 1 x' = 1 x
            } else if (!(mass[v] > 0)) {
                return Error{ErrorCode::mass_not_positive,
                             "the mass of vertex " + std::to_string(v) + " is not positive", v};
            }
        }
        SparseMatrix system = time * matrices.stiffness;
        system += SparseMatrix(mass.asDiagonal());
        if (Status status = factor_.factor(system); !status) {
            Error error = status.error();
            if (error.code == ErrorCode::not_positive_definite) {
                error.message = "M + tS is not positive definite at vertex " + std::to_string(error.element) +
                                ", where the surface may have collapsed, or t is too large";
            }
            return error;
        }
        mass_ = std::move(mass);
        return Done{};
    });
}

Result<Points> ImplicitSmoother::step(const Points& points) const {
    if (points.rows() != mass_.size()) {
        return Error{ErrorCode::bad_argument, "the operator has " + std::to_string(mass_.size()) + " vertices, but " +
                                                  std::to_string(points.rows()) + " points were given"};
    }
    if (!points.allFinite()) return Error{ErrorCode::bad_argument, "the points must be finite"};
    return guard_memory([&]() -> Result<Points> {
        const auto moved = factor_.solve(mass_.asDiagonal() * points);
        if (!moved) return moved.error();
        return Points(*moved);
    });
}

}  // namespace polylap

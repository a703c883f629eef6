#pragma once

#include "polylap/operators/operator.hpp"
#include "polylap/solve/spd_factor.hpp"

namespace polylap {

/// One implicit Euler step of the heat flow, (M + t S) x' = M x (Desbrun, Meyer, Schröder & Barr 1999). Factors once
/// for any number of steps.
class ImplicitSmoother {
public:
    /// @param matrices symmetric S, positive diagonal M   @param time t > 0, length²
    /// @error bad_argument (t not positive, sizes that do not fit), mass_not_positive (element = vertex),
    /// not_positive_definite (element = vertex), out_of_memory
    static Result<ImplicitSmoother> create(const OperatorMatrices& matrices, double time);

    /// The same for other values of S, M and t: keeps the ordering and symbolic analysis while the pattern stands.
    Status update(const OperatorMatrices& matrices, double time);

    /// @param points V×3   @return V×3. Vertices without an equation (in no face) stay.
    /// @error bad_argument (another number of rows, a point not finite), out_of_memory
    Result<Points> step(const Points& points) const;

private:
    ImplicitSmoother() = default;

    SpdFactor factor_;
    Vector mass_;
};

}  // namespace polylap

#pragma once

#include "polylap/operators/operator.hpp"
#include "polylap/solve/linear_factor.hpp"

namespace polylap {

/// One implicit Euler step of the heat flow, (M + t S) x' = M x (Desbrun, Meyer, Schröder & Barr 1999). Factors once
/// for any number of steps.
class ImplicitSmoother {
public:
    /// @param matrices any S; M diagonal or sparse, symmetric positive definite   @param time t > 0, length²
    /// @error bad_argument (t not positive, sizes that do not fit), mass_not_positive (element = vertex: its diagonal
    ///        entry of M), not_positive_definite (M + t S is not, or is singular if S is not positive semi-definite;
    ///        element = vertex, -1 where none can be named), out_of_memory
    static Result<ImplicitSmoother> create(const OperatorMatrices& matrices, double time);

    /// The same for other values of S, M and t: keeps the ordering and symbolic analysis while the pattern stands.
    Status update(const OperatorMatrices& matrices, double time);

    /// @param points V×3   @return V×3. Vertices without an equation (in no face) stay.
    /// @error bad_argument (another number of rows, a point not finite), out_of_memory
    Result<Points> step(const Points& points) const;

private:
    ImplicitSmoother() = default;

    LinearFactor factor_;
    SparseMatrix mass_;  ///< 1 on the diagonal of vertices in no face.
};

}  // namespace polylap

#pragma once

#include <span>
#include <vector>

#include "polylap/solve/linear_factor.hpp"

namespace polylap {

/// S u = 0 at the free vertices, u given at the fixed ones: S_II u_I = -S_IB u_B. Factors once for any values.
class DirichletProblem {
public:
    /// @param stiffness V×V; row i is the equation of vertex i   @param fixed distinct vertices
    /// @param positions V×3, where the vertices lie, for a better ordering; without rows, the graph alone decides
    /// @error bad_argument (S not square, a fixed vertex out of range or twice, another number of positions),
    ///        unconstrained_component (element = the lowest vertex whose equation leads, from row to row, to no fixed
    ///        vertex), not_positive_definite (element = vertex, -1 where none can be named: the free vertices'
    ///        equations have no unique solution), out_of_memory, cancelled
    static Result<DirichletProblem> create(const SparseMatrix& stiffness, std::span<const Index> fixed,
                                           Structure structure = Structure::positive_semidefinite,
                                           const Points& positions = {}, Monitor monitor = {});

    /// @param fixed_values B×k, in the order of `fixed`, finite
    /// @return V×k. A vertex that is in no equation (in no face) and not fixed gets NaN.
    /// @error bad_argument (another number of rows, a value not finite, values too far apart for the solution to be
    ///        finite), out_of_memory
    Result<Matrix> solve(const Eigen::Ref<const Matrix>& fixed_values) const;

    /// Of memory for the factor's numbers.
    std::int64_t bytes() const noexcept { return factor_.bytes(); }

private:
    DirichletProblem() = default;

    std::vector<Index> fixed_;
    std::vector<Index> free_;
    SparseMatrix coupling_;  ///< S_IB
    LinearFactor factor_;
    Index size_ = 0;
};

}  // namespace polylap

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "known_analyses.hpp"
#include "polylap/operators/operator.hpp"
#include "polylap/solve/dirichlet.hpp"
#include "polylap/solve/pinned_problem.hpp"

namespace polylap {

/// Harmonic functions of one stiffness for pins and values that change. On the factor of a PinnedProblem where that
/// applies and pays; else the pins are eliminated, and that factor is kept until they change. Holds one factor at most.
class HarmonicProblem {
public:
    /// @param constants_in_kernel whether S 1 = 0
    HarmonicProblem(std::shared_ptr<const OperatorMatrices> matrices, bool constants_in_kernel)
        : matrices_(std::move(matrices)),
          grounds_(constants_in_kernel && matrices_->structure == Structure::positive_semidefinite) {}

    /// @param positions V×3, for orderings   @return and @error as of DirichletProblem, with one value per pin
    Result<Vector> solve(std::span<const Index> pins, const Eigen::Ref<const Vector>& values, const Points& positions,
                         KnownAnalyses& analyses, Monitor monitor);

private:
    /// Nothing where elimination must, or had better, do it.
    std::optional<Result<Vector>> solve_pinned(std::span<const Index> pins, const Eigen::Ref<const Vector>& values,
                                               const Points& positions, KnownAnalyses& analyses, Monitor monitor);

    std::shared_ptr<const OperatorMatrices> matrices_;
    bool grounds_;  ///< Whether a PinnedProblem may be tried.
    std::optional<PinnedProblem> pinned_;
    std::vector<Index> fixed_;
    std::optional<DirichletProblem> eliminated_;  ///< Of fixed_.
};

}  // namespace polylap

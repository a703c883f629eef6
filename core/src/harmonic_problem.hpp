#pragma once

#include <cstdint>
#include <functional>
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
          keeps_constants_(constants_in_kernel),
          grounds_(constants_in_kernel && matrices_->structure == Structure::positive_semidefinite) {}

    /// u = above + base. Where S 1 = 0, the base is of the size of the values, and what lies above it has the precision
    /// of their differences; elsewhere it is 0.
    struct Solution {
        Vector above;
        double base;
    };
    /// What a solution may need from outside.
    struct Resources {
        const Points& positions;  ///< V×3, for orderings
        KnownAnalyses& analyses;
        std::function<void()> make_room;  ///< Called before there is another factor.
    };
    /// @return and @error as of DirichletProblem, with one value per pin
    Result<Solution> solve(std::span<const Index> pins, const Eigen::Ref<const Vector>& values,
                           const Resources& resources, Monitor monitor);

    /// Of memory for the factor's numbers, and what was solved with them.
    std::int64_t bytes() const noexcept {
        return (pinned_ ? pinned_->bytes() : 0) + (eliminated_ ? eliminated_->bytes() : 0);
    }

private:
    /// Nothing where elimination must, or had better, do it.
    std::optional<Result<Vector>> solve_pinned(std::span<const Index> pins, const Eigen::Ref<const Vector>& values,
                                               const Resources& resources, Monitor monitor);
    Result<Solution> solve_eliminated(const Eigen::Ref<const Vector>& values);
    std::optional<Result<Solution>> move_one(const Eigen::Ref<const Vector>& values);
    double base_of(const Eigen::Ref<const Vector>& values) const;

    std::shared_ptr<const OperatorMatrices> matrices_;
    bool keeps_constants_;
    bool grounds_;  ///< Whether a PinnedProblem may be tried.
    std::optional<PinnedProblem> pinned_;

    std::vector<Index> fixed_;
    std::optional<DirichletProblem> eliminated_;  ///< Of fixed_.
    /// An answer of it, and the response to the value that moved since, so that dragging a value solves once.
    struct Answer {
        Vector values;
        Solution solution;
        Eigen::Index moved = -1;
        Vector response;
    };
    std::optional<Answer> answer_;
};

}  // namespace polylap

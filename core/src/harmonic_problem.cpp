#include "harmonic_problem.hpp"

#include <algorithm>
#include <utility>

namespace polylap {

Result<Vector> HarmonicProblem::solve(std::span<const Index> pins, const Eigen::Ref<const Vector>& values,
                                      const Points& positions, KnownAnalyses& analyses, Monitor monitor) {
    const bool known = eliminated_ && std::equal(pins.begin(), pins.end(), fixed_.begin(), fixed_.end());
    if (!known) {
        if (auto u = solve_pinned(pins, values, positions, analyses, monitor); u) return *std::move(u);
        pinned_.reset();
        eliminated_.reset();  // before the next needs memory
        auto created = DirichletProblem::create(matrices_->stiffness, pins, matrices_->structure, positions, monitor);
        if (!created) return created.error();
        eliminated_ = *std::move(created);
        fixed_.assign(pins.begin(), pins.end());
    }
    const auto u = eliminated_->solve(values);
    if (!u) return u.error();
    return Vector(u->col(0));
}

std::optional<Result<Vector>> HarmonicProblem::solve_pinned(std::span<const Index> pins,
                                                            const Eigen::Ref<const Vector>& values,
                                                            const Points& positions, KnownAnalyses& analyses,
                                                            Monitor monitor) {
    if (!grounds_) return std::nullopt;
    if (!pinned_) {
        if (!PinnedProblem::may_pay(pins.size(), matrices_->stiffness.rows())) return std::nullopt;
        Stretch analysing{monitor, 0, 0.2};
        auto created = PinnedProblem::create(matrices_->stiffness, positions, analyses.kept(), analysing.monitor());
        if (!created) return created.error();
        pinned_ = *std::move(created);
        analyses.keep(pinned_->analysis());
    }
    if (!pinned_->pays(pins)) return std::nullopt;
    eliminated_.reset();
    Stretch solving{monitor, 0.2, 1};
    auto u = pinned_->solve(pins, values, solving.monitor());
    if (!u && u.error().code == ErrorCode::not_positive_definite) {
        grounds_ = false;
    } else if (u || u.error().code != ErrorCode::not_converged) {
        return u;
    }
    return std::nullopt;
}

}  // namespace polylap

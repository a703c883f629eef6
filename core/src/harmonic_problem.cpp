#include "harmonic_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polylap {
namespace {

/// How far a value may move, relative to what counts, before its rounding would show.
constexpr double farthest_move = 1e3;

/// The width of the values, infinite where they are not finite.
double width_of(const Eigen::Ref<const Vector>& values) {
    if (values.size() == 0) return 0;
    return values.allFinite() ? values.maxCoeff() - values.minCoeff() : std::numeric_limits<double>::infinity();
}

}  // namespace

Result<HarmonicProblem::Solution> HarmonicProblem::solve(std::span<const Index> pins,
                                                         const Eigen::Ref<const Vector>& values,
                                                         const Resources& resources, Monitor monitor) {
    const bool known = eliminated_ && std::equal(pins.begin(), pins.end(), fixed_.begin(), fixed_.end());
    if (!known) {
        const double base = base_of(values);
        const Vector above = values.array() - base;
        if (auto u = solve_pinned(pins, above, resources, monitor); u) {
            if (!*u) return u->error();
            return Solution{**std::move(u), base};
        }
        pinned_.reset();
        answer_.reset();
        eliminated_.reset();  // before the next needs memory
        resources.make_room();
        auto created =
            DirichletProblem::create(matrices_->stiffness, pins, matrices_->structure, resources.positions, monitor);
        if (!created) return created.error();
        eliminated_ = *std::move(created);
        fixed_.assign(pins.begin(), pins.end());
    }
    return solve_eliminated(values);
}

double HarmonicProblem::base_of(const Eigen::Ref<const Vector>& values) const {
    return keeps_constants_ && values.size() > 0 && std::isfinite(width_of(values)) ? values.minCoeff() : 0;
}

Result<HarmonicProblem::Solution> HarmonicProblem::solve_eliminated(const Eigen::Ref<const Vector>& values) {
    if (auto moved = move_one(values); moved) return *std::move(moved);
    const double base = base_of(values);
    auto above = eliminated_->solve(Vector(values.array() - base));
    if (!above) return above.error();
    answer_ = {values, {above->col(0), base}, -1, {}};
    return answer_->solution;
}

/// Nothing where more than one value moved, or that too far.
std::optional<Result<HarmonicProblem::Solution>> HarmonicProblem::move_one(const Eigen::Ref<const Vector>& values) {
    const double size = keeps_constants_ || values.size() == 0 ? width_of(values) : values.cwiseAbs().maxCoeff();
    if (!answer_ || values.size() != answer_->values.size() || !std::isfinite(size)) return std::nullopt;
    Eigen::Index place = 0;
    if (((values - answer_->values).array() != 0).count() > 1) return std::nullopt;
    if (values.size() > 0) (values - answer_->values).cwiseAbs().maxCoeff(&place);
    const double by = values.size() > 0 ? values[place] - answer_->values[place] : 0;
    if (by == 0) return answer_->solution;
    if (!(std::abs(by) <= farthest_move * size)) return std::nullopt;
    if (answer_->moved != place) {
        auto response = eliminated_->solve(Vector::Unit(values.size(), place));
        if (!response) return response.error();
        answer_->response = response->col(0);
        answer_->moved = place;
    }
    Solution solution{answer_->solution.above + by * answer_->response, answer_->solution.base};
    if (solution.above.array().isInf().any()) return std::nullopt;
    return solution;
}

std::optional<Result<Vector>> HarmonicProblem::solve_pinned(std::span<const Index> pins,
                                                            const Eigen::Ref<const Vector>& values,
                                                            const Resources& resources, Monitor monitor) {
    if (!grounds_) return std::nullopt;
    if (!pinned_) {
        if (!PinnedProblem::may_pay(pins.size(), matrices_->stiffness.rows())) return std::nullopt;
        Stretch analysing{monitor, 0, 0.2};
        auto created = PinnedProblem::create(matrices_->stiffness, resources.positions, resources.analyses.kept(),
                                             analysing.monitor());
        if (!created) return created.error();
        pinned_ = *std::move(created);
        resources.analyses.keep(pinned_->analysis());
    }
    if (!pinned_->pays(pins)) return std::nullopt;
    eliminated_.reset();
    if (pinned_->bytes() == 0) resources.make_room();
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

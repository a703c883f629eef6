// The smoothing flows of a session.
#include <limits>

#include "polylap/apply/rescaling.hpp"
#include "session_impl.hpp"

namespace polylap {
namespace {

Error no_volume_to_keep(Error error) {
    error.message = "there is no volume to keep: " + error.message;
    return error;
}

}  // namespace

Result<std::shared_ptr<const OperatorMatrices>> Session::Impl::take(const PolygonMesh& surface, const MatricesKey& key,
                                                                    Monitor monitor) {
    if (auto kept = matrices.take(key); kept != nullptr) return kept;
    auto made = build_operator(surface, key.spec, monitor);
    if (!made) return made.error();
    return std::make_shared<const OperatorMatrices>(*std::move(made));
}

Result<std::shared_ptr<const OperatorMatrices>> Session::Impl::take_conformalised(const SideState& moved,
                                                                                  Monitor monitor) {
    Stretch loading{monitor, 0, 0.5};
    Stretch moving{monitor, 0.5, 1};
    auto first = build(loaded, {0, moved.spec}, loading.monitor());
    if (!first || moved.version == 0) return first;
    auto now = build_operator(moved.surface, moved.spec, moving.monitor());
    if (!now) return now.error();
    now->stiffness = (*first)->stiffness;
    return std::make_shared<const OperatorMatrices>(*std::move(now));
}

Result<SmoothingStep> Session::Impl::step_explicitly(const SideState& moved, const SmoothOptions& options,
                                                     Monitor monitor) {
    Stretch building{monitor, 0, 0.5};
    Stretch stepping{monitor, 0.5, 1};
    const auto built = options.rebuild ? take(moved.surface, moved.key(), building.monitor())
                                       : build(loaded, {0, moved.spec}, building.monitor());
    if (!built) return built.error();
    return explicit_step(**built, options.time, moved.surface.positions(), fixed(options), stepping.monitor());
}

Result<SmoothingStep> Session::Impl::step_implicitly(Side which, const SideState& moved, const SmoothOptions& options,
                                                     int steps_to_come, Monitor monitor) {
    SmootherSlot& slot = smoother(which);
    slot.last_use = ++uses;
    const bool conformalised = options.flow == Flow::conformalised;
    const std::int64_t newest = conformalised || options.rebuild ? moved.version : 0;
    const SystemKey system{{conformalised ? 0 : newest, moved.spec}, newest, options.time, !fixed(options).empty()};
    Stretch building{monitor, 0, 0.3};
    Stretch stepping{monitor, 0.3, 1};
    if (slot.key != system) {
        const auto built = conformalised
                               ? take_conformalised(moved, building.monitor())
                               : take(newest == 0 ? loaded : moved.surface, system.stiffness, building.monitor());
        if (!built) return built.error();
        const SmootherOptions serving{.steps = conformalised || options.rebuild ? 1 : steps_to_come,
                                      .positions = &loaded.positions(),
                                      .known = analyses.kept(),
                                      .fixed = fixed(options)};
        if (Status status = slot.prepare(system, **built, serving); !status) return status.error();
    }
    if (slot.smoother->needs_factor()) make_room(&slot);
    auto points = slot.smoother->step(moved.surface.positions(), stepping.monitor());
    if (!points) return points.error();
    analyses.keep(slot.smoother->analysis());
    return SmoothingStep{*std::move(points), slot.smoother->last_solve()};
}

Status Session::smooth(Side side, const SmoothOptions& options, Monitor monitor) {
    return guard_memory([&]() -> Status {
        SideState& state = impl_->side(side);
        if (options.steps < 0 || options.steps > std::numeric_limits<int>::max() - state.steps) {
            return Error{ErrorCode::bad_argument, "the number of steps must not be negative, nor beyond counting"};
        }
        const auto loaded_volume = options.keep_volume ? enclosed_volume(impl_->loaded, impl_->topology) : 0.0;
        if (!loaded_volume) return no_volume_to_keep(loaded_volume.error());
        const bool keeps_area =
            options.flow == Flow::conformalised && !options.keep_volume && impl_->fixed(options).empty();
        const double loaded_area = keeps_area ? surface_area(impl_->loaded) : 0;

        SideState moved = state;
        for (int k = 0; k < options.steps; ++k) {
            const auto at = [&](double part) { return (k + part) / options.steps; };
            if (!monitor.proceed(at(0))) return Error{ErrorCode::cancelled, "cancelled"};
            Stretch stretch{monitor, at(0), at(1)};
            const bool explicitly = options.flow == Flow::explicit_step;
            auto step = explicitly ? impl_->step_explicitly(moved, options, stretch.monitor())
                                   : impl_->step_implicitly(side, moved, options, options.steps - k, stretch.monitor());
            if (!step) return step.error();
            auto surface = moved.surface.with_positions(std::move(step->points));
            if (surface && options.keep_volume) surface = scaled_to_volume(*surface, impl_->topology, *loaded_volume);
            if (surface && keeps_area) surface = scaled_to_area(*surface, loaded_area);
            if (!surface) return surface.error();
            moved.surface = *std::move(surface);
            moved.version = ++impl_->last_version;
            moved.solve = step->solve;
            ++moved.steps;
        }
        if (!monitor.proceed(1)) return Error{ErrorCode::cancelled, "cancelled"};
        state = std::move(moved);
        return Done{};
    });
}

Result<Stability> Session::stability(Side side, const SmoothOptions& options, Monitor monitor) {
    return guard_memory([&]() -> Result<Stability> {
        const SideState& state = impl_->side(side);
        const std::span<const Index> fixed = impl_->fixed(options);
        const MatricesKey key = options.rebuild ? state.key() : MatricesKey{0, state.spec};
        StabilitySlot& slot = impl_->stabilities[static_cast<std::size_t>(side)];
        if (slot.matrices == key && slot.fixes_boundary == !fixed.empty()) return slot.value;
        Stretch building{monitor, 0, 0.1};
        Stretch searching{monitor, 0.1, 1};
        const auto built = impl_->build(options.rebuild ? state.surface : impl_->loaded, key, building.monitor());
        if (!built) return built.error();
        auto found = explicit_stability(**built, fixed, searching.monitor());
        if (found) slot = {key, !fixed.empty(), *found};
        return found;
    });
}

}  // namespace polylap

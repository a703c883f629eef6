#pragma once

namespace polylap {

/// Progress and cancellation of long work: the core calls `tick` now and then.
struct Monitor {
    /// `fraction` in [0, 1] is how much of the call is done; returning false stops it with ErrorCode::cancelled.
    bool (*tick)(void* user, double fraction) = nullptr;
    void* user = nullptr;

    bool proceed(double fraction) const { return tick == nullptr || tick(user, fraction); }
};

/// The stretch [from, to] of a call's progress as a monitor of its own, for a part of the work.
struct Stretch {
    Monitor whole;
    double from = 0;
    double to = 1;

    Monitor monitor() { return {tick, this}; }
    static bool tick(void* user, double fraction) {
        const auto& stretch = *static_cast<const Stretch*>(user);
        return stretch.whole.proceed(stretch.from + fraction * (stretch.to - stretch.from));
    }
};

}  // namespace polylap

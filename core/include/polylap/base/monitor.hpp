#pragma once

namespace polylap {

/// Progress and cancellation of long work: the core calls `tick` now and then.
struct Monitor {
    /// `fraction` in [0, 1] is how much of the call is done; returning false stops it with ErrorCode::cancelled.
    bool (*tick)(void* user, double fraction) = nullptr;
    void* user = nullptr;

    bool proceed(double fraction) const { return tick == nullptr || tick(user, fraction); }
};

}  // namespace polylap

#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include "polylap/base/result.hpp"

namespace polylap {

/// A value that is made when first asked for, and shared from then on. Several threads may ask.
template <class T>
class Once {
public:
    /// @param make returns a Result<std::shared_ptr<const T>>; errors are not kept
    template <class Make>
    Result<std::shared_ptr<const T>> get(Make&& make) const {
        const std::lock_guard lock(mutex_);
        if (value_ == nullptr) {
            auto made = std::forward<Make>(make)();
            if (!made) return made;
            value_ = *std::move(made);
        }
        return value_;
    }

private:
    mutable std::mutex mutex_;
    mutable std::shared_ptr<const T> value_;
};

}  // namespace polylap

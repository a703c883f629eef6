#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "polylap/base/result.hpp"

namespace polylap {

/// The last `capacity` values by key; the one used longest ago leaves first. Errors are not kept.
template <class Key, class Value, std::size_t capacity>
class Cache {
public:
    /// The value of `key`, made by `make` (which returns a Result<Value>) if it is not there.
    template <class Make>
    Result<std::shared_ptr<const Value>> get(const Key& key, Make&& make) {
        const auto found =
            std::find_if(entries_.begin(), entries_.end(), [&](const auto& e) { return e && e->first == key; });
        if (found == entries_.end()) {
            Result<Value> made = make();
            if (!made) return made.error();
            entries_.back().emplace(key, std::make_shared<const Value>(*std::move(made)));
            std::rotate(entries_.begin(), entries_.end() - 1, entries_.end());
        } else {
            std::rotate(entries_.begin(), found, found + 1);
        }
        return entries_.front()->second;
    }

private:
    std::array<std::optional<std::pair<Key, std::shared_ptr<const Value>>>, capacity> entries_;
};

}  // namespace polylap

#pragma once

#include <algorithm>
#include <cstdint>
#include <list>
#include <memory>
#include <utility>

#include "polylap/base/result.hpp"

namespace polylap {

/// Values by key: the one used last, and those used before it as long as all together are at most `capacity` and take
/// at most `most_bytes`. Errors are not kept.
template <class Key, class Value, std::size_t capacity, std::int64_t (*bytes_of)(const Value&)>
class Cache {
public:
    using Pointer = std::shared_ptr<const Value>;

    explicit Cache(std::int64_t most_bytes) : most_bytes_(most_bytes) {}

    /// The value of `key`, made by `make` (which returns a Result<Value>) if it is not there.
    template <class Make>
    Result<Pointer> get(const Key& key, Make&& make) {
        const auto found = find(key);
        if (found == entries_.end()) {
            Result<Value> made = make();
            if (!made) return made.error();
            entries_.emplace_front(key, std::make_shared<const Value>(*std::move(made)));
            shrink();
        } else {
            entries_.splice(entries_.begin(), entries_, found);
        }
        return entries_.front().second;
    }

    /// The value of `key`, which is no longer kept; null if it is not there.
    Pointer take(const Key& key) {
        const auto found = find(key);
        if (found == entries_.end()) return nullptr;
        Pointer value = std::move(found->second);
        entries_.erase(found);
        return value;
    }

private:
    using Entries = std::list<std::pair<Key, Pointer>>;

    typename Entries::iterator find(const Key& key) {
        return std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) { return entry.first == key; });
    }

    void shrink() {
        std::int64_t bytes = 0;
        std::size_t count = 0;
        std::erase_if(entries_, [&](const auto& entry) {
            bytes += bytes_of(*entry.second);
            return ++count > 1 && (count > capacity || bytes > most_bytes_);
        });
    }

    std::int64_t most_bytes_;
    Entries entries_;  ///< The one used last comes first.
};

}  // namespace polylap

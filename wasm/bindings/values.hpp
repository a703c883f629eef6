// What crosses to JavaScript: fresh arrays (never views of the heap, which moves when it grows) and plain objects.
// Every call returns {ok: value} or {error: {code, message, element, line}}.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <emscripten/val.h>

#include "polylap/base/monitor.hpp"
#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"
#include "polylap/operators/operator.hpp"

namespace polylap::js {

using emscripten::val;

template <class... Entries>
val object(Entries&&... entries) {
    val result = val::object();
    (result.set(entries.first, entries.second), ...);
    return result;
}

template <class T>
std::pair<const char*, T> entry(const char* key, T value) {
    return {key, std::move(value)};
}

val failure(std::string_view code, const std::string& message, std::int64_t element = -1, std::int64_t line = -1);

/// The one place where C++ ends: `work` returns a Result<val>, and nothing it throws gets past here.
template <class Work>
val guarded(Work&& work) {
    try {
        const Result<val> result = guard_memory([&]() -> Result<val> { return work(); });
        if (!result) {
            const Error& error = result.error();
            return failure(error_code_name(error.code), error.message, error.element, error.line);
        }
        return object(entry("ok", *result));
    } catch (const std::exception& exception) {
        return failure("internal", exception.what());
    } catch (...) {
        return failure("internal", "an exception of unknown type");
    }
}

/// The Result of work without a value.
Result<val> nothing(const Status& status);

template <class T>
val array(const T* data, std::size_t size) {
    return val(emscripten::typed_memory_view(size, data)).template call<val>("slice");
}

template <class T>
val array(const std::vector<T>& values) {
    return array(values.data(), values.size());
}

/// A JavaScript array of a function of each item.
template <class Range, class Function>
val list(const Range& range, Function&& function) {
    val result = val::array();
    for (const auto& item : range)
        result.call<void>("push", function(item));
    return result;
}

val triple(const Vector3& v);
/// @param coordinates a Float64Array   @error bad_argument (not in threes)
Result<Points> points_of(const val& coordinates);
val sparse(SparseMatrix matrix);

/// A callback of JavaScript, (fraction) => boolean, as Monitor.
class Tick {
public:
    explicit Tick(val callback) : callback_(std::move(callback)) {}

    Monitor monitor() {
        if (callback_.isUndefined()) return {};
        return {[](void* user, double fraction) { return static_cast<Tick*>(user)->callback_(fraction).as<bool>(); },
                this};
    }

private:
    val callback_;
};

/// {parameter: number or text, …} as the texts that the core reads; what is undefined takes its default.
std::vector<std::pair<std::string, std::string>> settings_of(const val& settings);

/// @param vertex_weights a Float64Array, or undefined
Result<OperatorSpec> spec_of(const std::string& id, const val& settings, const val& vertex_weights);

}  // namespace polylap::js

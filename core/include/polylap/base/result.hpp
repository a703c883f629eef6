#pragma once

#include <cstdint>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace polylap {

enum class ErrorCode : std::uint16_t {
    bad_argument,
    parse_error,
    bad_mesh,
    non_manifold_edge,
    open_mesh,
    degenerate_face,
    unknown_operator,
    parameter_out_of_range,
    mass_not_positive,
    not_positive_definite,
    unconstrained_component,
    not_converged,
    cancelled,
    out_of_memory,
    not_included,
};

/// The name of a code in kebab case, e.g. "degenerate-face": what JavaScript and the command line show.
std::string_view error_code_name(ErrorCode code) noexcept;

/// What went wrong, and where.
struct Error {
    ErrorCode code = ErrorCode::bad_argument;
    std::string message;        ///< One sentence for people; names the element or the line.
    std::int64_t element = -1;  ///< Face, edge or vertex (the message says which), counted from 0; -1: none.
    std::int64_t line = -1;     ///< Line of the file, counted from 1; -1: not from a file.
};

/// A value or an Error. Nothing throws across polylap's public headers, but for std::bad_alloc out of functions that
/// return no Result.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
    Result(Error error) : content_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

    bool ok() const noexcept { return std::holds_alternative<T>(content_); }
    explicit operator bool() const noexcept { return ok(); }

    /// The value. Ends the program when there is none: check ok() first.
    T& value() & { return *required(std::get_if<T>(&content_)); }
    const T& value() const& { return *required(std::get_if<T>(&content_)); }
    T&& value() && { return std::move(*required(std::get_if<T>(&content_))); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    /// The error. Ends the program when there is none.
    const Error& error() const { return *required(std::get_if<Error>(&content_)); }

private:
    template <class Content>
    static Content* required(Content* content) {
        if (content == nullptr) std::abort();
        return content;
    }

    std::variant<T, Error> content_;
};

/// Success without a value.
struct Done {};
using Status = Result<Done>;

/// Runs `work` (which returns a Result) and turns an exhausted memory into `out_of_memory`, whose message is short
/// enough to need none.
template <class Work>
auto guard_memory(Work&& work) -> decltype(work()) {
    try {
        return std::forward<Work>(work)();
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_memory, "out of memory", -1, -1};
    } catch (const std::length_error&) {  // what std::vector throws past its largest size, first on 32-bit targets
        return Error{ErrorCode::out_of_memory, "out of memory", -1, -1};
    }
}

}  // namespace polylap

#include "polylap/base/parameter.hpp"

#include <algorithm>
#include <cmath>

#include <fast_float/fast_float.h>

namespace polylap {
namespace {

/// Shortest text of a bound or step of a table, which are all short decimals.
std::string number_text(double x) {
    std::string text = std::to_string(x);
    text.erase(text.find_last_not_of('0') + 1);
    if (!text.empty() && (text.back() == '.' || text.back() == ',')) text.pop_back();
    return text;
}

Result<double> parse_value(const Parameter& parameter, const std::string& text) {
    if (parameter.kind == Parameter::Kind::choice) {
        const auto at = std::find(parameter.choices.begin(), parameter.choices.end(), std::string_view(text));
        if (at != parameter.choices.end()) return static_cast<double>(at - parameter.choices.begin());
        std::string message = std::string(parameter.id) + " must be one of";
        for (const char* choice : parameter.choices) {
            message += std::string(choice == parameter.choices.front() ? " " : ", ") + choice;
        }
        return Error{ErrorCode::bad_argument, message + ", not '" + text + "'"};
    }
    double value = 0;
    const char* end = text.data() + text.size();
    const auto parsed = fast_float::from_chars(text.data(), end, value);
    if (parsed.ec != std::errc() || parsed.ptr != end || !std::isfinite(value)) {
        return Error{ErrorCode::bad_argument, std::string(parameter.id) + " must be a number, not '" + text + "'"};
    }
    return value;
}

Status check_range(const Parameter& parameter, double value) {
    const bool real = parameter.kind == Parameter::Kind::real;
    if (value >= parameter.min && value <= parameter.max && (real || value == std::floor(value))) return Done{};
    return Error{ErrorCode::parameter_out_of_range,
                 std::string(parameter.id) + (real ? " must lie between " : " must be a whole number between ") +
                     number_text(parameter.min) + " and " + number_text(parameter.max)};
}

}  // namespace

Result<std::vector<double>> parse_settings(std::string_view owner, std::span<const Parameter> parameters,
                                           Settings settings) {
    return guard_memory([&]() -> Result<std::vector<double>> {
        std::vector<double> values;
        for (const Parameter& p : parameters) {
            values.push_back(p.initial);
        }
        for (const auto& [name, text] : settings) {
            const auto at = std::find_if(parameters.begin(), parameters.end(),
                                         [&n = name](const Parameter& p) { return n == p.id; });
            if (at == parameters.end()) {
                return Error{ErrorCode::bad_argument, std::string(owner) + " has no parameter '" + name + "'"};
            }
            const auto value = parse_value(*at, text);
            if (!value) return value.error();
            values[static_cast<std::size_t>(at - parameters.begin())] = *value;
        }
        return complete_values(owner, parameters, std::move(values));
    });
}

Result<std::vector<double>> complete_values(std::string_view owner, std::span<const Parameter> parameters,
                                            std::vector<double> values) {
    return guard_memory([&]() -> Result<std::vector<double>> {
        if (values.size() > parameters.size()) {
            return Error{ErrorCode::bad_argument, std::string(owner) + " has " + std::to_string(parameters.size()) +
                                                      " parameters, but " + std::to_string(values.size()) +
                                                      " values were given"};
        }
        for (std::size_t k = 0; k < parameters.size(); ++k) {
            if (k == values.size()) values.push_back(parameters[k].initial);
            if (auto status = check_range(parameters[k], values[k]); !status) return status.error();
        }
        return values;
    });
}

}  // namespace polylap

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "polylap/base/result.hpp"

namespace polylap {

/// One parameter of an operator, a shape or a conversion. A choice has the values 0, 1, … in the order of `choices`.
struct Parameter {
    enum class Kind : std::uint8_t { real, integer, choice };
    const char* id;
    const char* label;  ///< What the page shows, e.g. "λ".
    Kind kind;
    double min, max;    ///< What is allowed.
    double slider_max;  ///< Where a slider ends (it starts at min): the span worth exploring.
    double step;
    double initial;
    std::span<const char* const> choices = {};
    const char* hint = "";  ///< One short sentence beside the control.
};

/// A choice, without the numbers that follow from its list.
constexpr Parameter choice_parameter(const char* id, const char* label, std::span<const char* const> choices,
                                     const char* hint, double initial = 0) {
    const double last = static_cast<double>(choices.size()) - 1;
    return {.id = id,
            .label = label,
            .kind = Parameter::Kind::choice,
            .min = 0,
            .max = last,
            .slider_max = last,
            .step = 1,
            .initial = initial,
            .choices = choices,
            .hint = hint};
}

/// Parameters by name, as text, e.g. {{"lambda", "0.5"}}; choices by their name.
using Settings = std::span<const std::pair<std::string, std::string>>;

/// One value per parameter: the settings', else the initial one; all in range.
/// @param owner whose parameters they are, for messages, e.g. "operator 'planar'"
/// @error bad_argument (no such parameter, not a number, no such choice), parameter_out_of_range, out_of_memory
Result<std::vector<double>> parse_settings(std::string_view owner, std::span<const Parameter> parameters,
                                           Settings settings);

/// The same from numbers: missing ones take their initial value.
/// @error bad_argument (too many values), parameter_out_of_range, out_of_memory
Result<std::vector<double>> complete_values(std::string_view owner, std::span<const Parameter> parameters,
                                            std::vector<double> values);

}  // namespace polylap

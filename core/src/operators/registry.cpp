#include <algorithm>
#include <array>
#include <cmath>

#include <fast_float/fast_float.h>

#include "polylap/operators/alexa_wardetzky.hpp"
#include "polylap/operators/planar.hpp"

namespace polylap {

// THE operator table: one line per operator, in the order of the menus.
std::span<const OperatorInfo* const> operators() noexcept {
    static constexpr std::array table{
        &alexa_wardetzky_info,
        &planar_info,
    };
    return table;
}

namespace {

std::string quoted(std::string_view text) {
    return "'" + std::string(text) + "'";
}

/// Shortest text of a bound or step of the table, which are all short decimals.
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
        return Error{ErrorCode::bad_argument, message + ", not " + quoted(text)};
    }
    double value = 0;
    const char* end = text.data() + text.size();
    const auto parsed = fast_float::from_chars(text.data(), end, value);
    if (parsed.ec != std::errc() || parsed.ptr != end || !std::isfinite(value)) {
        return Error{ErrorCode::bad_argument, std::string(parameter.id) + " must be a number, not " + quoted(text)};
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

std::string_view claim_name(Claim claim) noexcept {
    switch (claim) {
        case Claim::yes:
            return "yes";
        case Claim::planar:
            return "planar";
        case Claim::triangles:
            return "triangles";
        case Claim::no:
            return "no";
    }
    return "unknown";
}

Result<const OperatorInfo*> find_operator(std::string_view id) {
    return guard_memory([&]() -> Result<const OperatorInfo*> {
        std::string known;
        for (const OperatorInfo* info : operators()) {
            if (id == info->id) return info;
            known += (known.empty() ? "" : ", ") + std::string(info->id);
        }
        return Error{ErrorCode::unknown_operator, "there is no operator " + quoted(id) + "; known are " + known};
    });
}

Result<OperatorSpec> make_spec(std::string_view id, std::span<const std::pair<std::string, std::string>> settings) {
    return guard_memory([&]() -> Result<OperatorSpec> {
        const auto info = find_operator(id);
        if (!info) return info.error();
        const auto parameters = (*info)->parameters;
        OperatorSpec spec{.id = std::string(id), .values = {}};
        for (const Parameter& p : parameters) {
            spec.values.push_back(p.initial);
        }
        for (const auto& [name, text] : settings) {
            const auto at = std::find_if(parameters.begin(), parameters.end(),
                                         [&n = name](const Parameter& p) { return n == p.id; });
            if (at == parameters.end()) {
                return Error{ErrorCode::bad_argument, "operator " + quoted(id) + " has no parameter " + quoted(name)};
            }
            const auto value = parse_value(*at, text);
            if (!value) return value.error();
            spec.values[static_cast<std::size_t>(at - parameters.begin())] = *value;
        }
        return complete_spec(std::move(spec));
    });
}

Result<OperatorSpec> complete_spec(OperatorSpec spec) {
    return guard_memory([&]() -> Result<OperatorSpec> {
        const auto info = find_operator(spec.id);
        if (!info) return info.error();
        const auto parameters = (*info)->parameters;
        if (spec.values.size() > parameters.size()) {
            return Error{ErrorCode::bad_argument, "operator " + quoted(spec.id) + " has " +
                                                      std::to_string(parameters.size()) + " parameters, but " +
                                                      std::to_string(spec.values.size()) + " values were given"};
        }
        for (std::size_t k = 0; k < parameters.size(); ++k) {
            if (k == spec.values.size()) spec.values.push_back(parameters[k].initial);
            if (auto status = check_range(parameters[k], spec.values[k]); !status) return status.error();
        }
        return spec;
    });
}

Result<OperatorMatrices> build_operator(const PolygonMesh& mesh, const OperatorSpec& spec, Monitor monitor) {
    return guard_memory([&]() -> Result<OperatorMatrices> {
        const auto complete = complete_spec(spec);
        if (!complete) return complete.error();
        return (*find_operator(complete->id))->build(mesh, complete->values, complete->mass, monitor);
    });
}

}  // namespace polylap

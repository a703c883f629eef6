// The tables: operators, properties, shapes, conversions, error codes.
#include <emscripten/bind.h>

#include "polylap/apply/conversions.hpp"
#include "polylap/mesh/shapes.hpp"
#include "values.hpp"

namespace polylap::js {
namespace {

val parameter_of(const Parameter& parameter) {
    const bool choice = parameter.kind == Parameter::Kind::choice;
    val result = object(entry("id", std::string(parameter.id)), entry("label", std::string(parameter.label)),
                        entry("hint", std::string(parameter.hint)));
    if (choice) {
        const auto text = [](const char* name) { return std::string(name); };
        result.set("kind", "choice");
        result.set("choices", list(parameter.choices, text));
        result.set("initial", text(parameter.choices[static_cast<std::size_t>(parameter.initial)]));
    } else {
        result.set("kind", parameter.kind == Parameter::Kind::integer ? "integer" : "real");
        result.set("min", parameter.min);
        result.set("max", parameter.max);
        result.set("sliderMax", parameter.slider_max);
        result.set("step", parameter.step);
        result.set("initial", parameter.initial);
    }
    return result;
}

val operator_of(const OperatorInfo* info) {
    val claims = val::object();
    for (const PropertyInfo& property : properties()) {
        const PropertyClaim& claim = info->claims.*property.claim;
        claims.set(property.id,
                   object(entry("where", std::string(claim_name(claim.where))), entry("why", std::string(claim.why))));
    }
    return object(entry("id", std::string(info->id)), entry("label", std::string(info->label)),
                  entry("summary", std::string(info->summary)), entry("formulaLatex", std::string(info->formula_latex)),
                  entry("citation", std::string(info->citation)), entry("bibtex", std::string(info->bibtex)),
                  entry("parameters", list(info->parameters, parameter_of)),
                  entry("takesVertexWeights", info->takes_vertex_weights), entry("claims", claims));
}

val property_of(const PropertyInfo& info) {
    return object(entry("id", std::string(info.id)), entry("label", std::string(info.label)),
                  entry("meaning", std::string(info.meaning)));
}

/// A shape or a conversion.
template <class Info>
val maker_of(const Info* info) {
    return object(entry("id", std::string(info->id)), entry("label", std::string(info->label)),
                  entry("summary", std::string(info->summary)),
                  entry("parameters", list(info->parameters, parameter_of)));
}

val operator_table() {
    return guarded([]() -> Result<val> { return list(operators(), operator_of); });
}

val property_table() {
    return guarded([]() -> Result<val> { return list(properties(), property_of); });
}

val shape_table() {
    return guarded([]() -> Result<val> { return list(shapes(), maker_of<ShapeInfo>); });
}

val conversion_table() {
    return guarded([]() -> Result<val> { return list(conversions(), maker_of<ConversionInfo>); });
}

val error_codes() {
    return guarded([]() -> Result<val> {
        val names = val::array();
        for (int code = 0; code <= static_cast<int>(ErrorCode::not_included); ++code) {
            names.call<void>("push", std::string(error_code_name(static_cast<ErrorCode>(code))));
        }
        return names;
    });
}

}  // namespace
}  // namespace polylap::js

EMSCRIPTEN_BINDINGS(polylap_tables) {
    using emscripten::function;
    using namespace polylap::js;

    function("operators", &operator_table);
    function("properties", &property_table);
    function("shapes", &shape_table);
    function("conversions", &conversion_table);
    function("errorCodes", &error_codes);
}

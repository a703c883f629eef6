#include "values.hpp"

namespace polylap::js {

val failure(std::string_view code, const std::string& message, std::int64_t element, std::int64_t line) {
    return object(entry(
        "error", object(entry("code", std::string(code)), entry("message", message),
                        entry("element", static_cast<double>(element)), entry("line", static_cast<double>(line)))));
}

Result<val> nothing(const Status& status) {
    if (!status) return status.error();
    return val::undefined();
}

val triple(const Vector3& v) {
    val result = val::array();
    for (int k = 0; k < 3; ++k)
        result.set(k, v[k]);
    return result;
}

Result<Points> points_of(const val& coordinates) {
    const auto size = coordinates["length"].as<std::size_t>();
    if (size % 3 != 0) return Error{ErrorCode::bad_argument, "coordinates must come in threes"};
    Points points(static_cast<Eigen::Index>(size / 3), 3);
    val(emscripten::typed_memory_view(size, points.data())).call<void>("set", coordinates);
    return points;
}

val sparse(SparseMatrix matrix) {
    // A zero off the diagonal is no coupling: its vertices only share a face.
    matrix.prune([](Eigen::Index row, Eigen::Index column, double value) { return row == column || value != 0; });
    const auto entries = static_cast<std::size_t>(matrix.nonZeros());
    return object(entry("rows", static_cast<double>(matrix.rows())), entry("cols", static_cast<double>(matrix.cols())),
                  entry("colStarts", array(matrix.outerIndexPtr(), static_cast<std::size_t>(matrix.outerSize()) + 1)),
                  entry("rowIndices", array(matrix.innerIndexPtr(), entries)),
                  entry("values", array(matrix.valuePtr(), entries)));
}

std::vector<std::pair<std::string, std::string>> settings_of(const val& settings) {
    std::vector<std::pair<std::string, std::string>> result;
    const val text = val::global("String");
    for (const val& key : emscripten::vecFromJSArray<val>(val::global("Object").call<val>("keys", settings))) {
        const val value = settings[key];
        if (!value.isUndefined()) result.emplace_back(key.as<std::string>(), text(value).as<std::string>());
    }
    return result;
}

Result<OperatorSpec> spec_of(const std::string& id, const val& settings, const val& vertex_weights) {
    auto spec = make_spec(id, settings_of(settings));
    if (spec && !vertex_weights.isUndefined())
        spec->vertex_weights = emscripten::convertJSArrayToNumberVector<double>(vertex_weights);
    return spec;
}

}  // namespace polylap::js

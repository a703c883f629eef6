// Session for JavaScript. No algorithms: arguments come in, fresh JavaScript arrays go out (never views of the heap,
// which moves when it grows), and every call returns {ok: value} or {error: {code, message, element, line}}.

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include "polylap/apply/noise.hpp"
#include "polylap/mesh/mesh_io.hpp"
#include "polylap/mesh/shapes.hpp"
#include "polylap/session.hpp"

namespace {

using namespace polylap;
using emscripten::val;
using Side = Session::Side;

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

val failure(std::string_view code, const std::string& message, std::int64_t element = -1, std::int64_t line = -1) {
    return object(entry(
        "error", object(entry("code", std::string(code)), entry("message", message),
                        entry("element", static_cast<double>(element)), entry("line", static_cast<double>(line)))));
}

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
Result<val> nothing(const Status& status) {
    if (!status) return status.error();
    return val::undefined();
}

template <class T>
val array(const T* data, std::size_t size) {
    return val(emscripten::typed_memory_view(size, data)).template call<val>("slice");
}

template <class T>
val array(const std::vector<T>& values) {
    return array(values.data(), values.size());
}

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

val measures_of(const Session::Shape& shape) {
    return object(entry("area", shape.measures.area), entry("volume", shape.volume ? val(*shape.volume) : val::null()),
                  entry("noVolume", shape.no_volume), entry("meanNonPlanarity", shape.measures.mean_non_planarity),
                  entry("meanSquaredEdge", shape.measures.mean_squared_edge));
}

val triple(const Vector3& v) {
    val result = val::array();
    for (int k = 0; k < 3; ++k)
        result.set(k, v[k]);
    return result;
}

// ---- Making a session ----

Result<val> owned(Result<Session> session) {
    if (!session) return session.error();
    return val(std::make_shared<Session>(std::move(*session)));
}

val open(const val& bytes, const std::string& name, val callback) {
    return guarded([&] {
        const auto data = emscripten::convertJSArrayToNumberVector<std::uint8_t>(bytes);
        Tick tick(std::move(callback));
        return owned(Session::open(std::as_bytes(std::span(data)), name, tick.monitor()));
    });
}

Result<val> noisy(Result<PolygonMesh> mesh, double noise, std::uint32_t seed) {
    if (mesh && noise != 0) mesh = add_normal_noise(*mesh, noise, seed);
    if (!mesh) return mesh.error();
    return owned(Session::from_mesh(std::move(*mesh)));
}

val make_torus_session(Index nu, Index nv, double major, double minor, double noise, std::uint32_t seed) {
    return guarded([&] { return noisy(make_torus(nu, nv, major, minor), noise, seed); });
}

val make_grid_session(Index nx, Index ny, double width, double height, double noise, std::uint32_t seed) {
    return guarded([&] { return noisy(make_grid(nx, ny, width, height), noise, seed); });
}

val make_saddle_session(Index n, double height, double noise, std::uint32_t seed) {
    return guarded([&] { return noisy(make_saddle(n, height), noise, seed); });
}

// ---- Reading a session ----

val info(const Session& session) {
    return guarded([&]() -> Result<val> {
        const PolygonMesh& mesh = session.mesh();
        const Topology& topology = session.topology();
        Index fewest = mesh.vertex_count(), most = 0;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            const auto corners = static_cast<Index>(mesh.face(f).size());
            fewest = std::min(fewest, corners);
            most = std::max(most, corners);
        }
        val issues = val::array();
        for (const MeshIssue& issue : find_issues(topology)) {
            issues.call<void>("push", object(entry("kind", std::string(issue_name(issue.kind))),
                                             entry("count", issue.count), entry("message", issue.message)));
        }
        return object(entry("vertices", mesh.vertex_count()), entry("faces", mesh.face_count()),
                      entry("edges", static_cast<double>(topology.edges.size())),
                      entry("components", topology.component_count), entry("minCorners", fewest),
                      entry("maxCorners", most),
                      entry("meanSquaredEdge", measure_shape(mesh, topology).mean_squared_edge),
                      entry("boundary", array(topology.boundary_vertices)), entry("issues", issues));
    });
}

/// Of the surface of side a: the loaded mesh, as long as nothing has smoothed it.
val geometry(const Session& session) {
    return guarded([&]() -> Result<val> {
        const Connectivity& connectivity = *session.mesh().connectivity();
        const DisplayTriangles& display = session.display();
        static_assert(sizeof(display.triangles[0]) == 3 * sizeof(Index));
        return object(
            entry("origin", triple(session.origin())), entry("positions", array(session.float_positions(Side::a))),
            entry("offsets", array(connectivity.offsets)), entry("corners", array(connectivity.corners)),
            entry("triangles",
                  array(reinterpret_cast<const Index*>(display.triangles.data()), 3 * display.triangles.size())),
            entry("triangleEdges", array(display.edges)), entry("triangleFaces", array(display.face)));
    });
}

val surface(const Session& session, Side side) {
    return guarded([&]() -> Result<val> {
        const Points& points = session.surface(side).positions();
        return object(entry("step", session.step_count(side)), entry("positions", array(session.float_positions(side))),
                      entry("coordinates", array(points.data(), static_cast<std::size_t>(points.size()))),
                      entry("stats", measures_of(session.shape(side))));
    });
}

val shape(const Session& session, Side side) {
    return guarded([&]() -> Result<val> { return measures_of(session.shape(side)); });
}

val obj(const Session& session, Side side) {
    return guarded([&]() -> Result<val> {
        const auto text = write_obj(session.surface(side));
        if (!text) return text.error();
        return val(*text);
    });
}

// ---- Working on a session ----

/// {id, parameter: value, …}: numbers and choices become the texts that make_spec reads.
Result<OperatorSpec> spec_of(const val& spec) {
    std::string id;
    std::vector<std::pair<std::string, std::string>> settings;
    const val text = val::global("String");
    for (const val& key : emscripten::vecFromJSArray<val>(val::global("Object").call<val>("keys", spec))) {
        const val value = spec[key];
        if (value.isUndefined()) continue;
        auto setting = std::pair(key.as<std::string>(), text(value).as<std::string>());
        if (setting.first == "id") {
            id = std::move(setting.second);
        } else {
            settings.push_back(std::move(setting));
        }
    }
    return make_spec(id, settings);
}

val set_operator(Session& session, Side side, const val& spec) {
    return guarded([&]() -> Result<val> {
        auto parsed = spec_of(spec);
        if (!parsed) return parsed.error();
        return nothing(session.set_operator(side, std::move(*parsed)));
    });
}

val weights(Session& session, Side side, val callback) {
    return guarded([&]() -> Result<val> {
        Tick tick(std::move(callback));
        const auto weights = session.weights(side, tick.monitor());
        if (!weights) return weights.error();
        const WeightSummary& summary = weights->summary;
        std::vector<Index> pairs;
        std::vector<double> values;
        pairs.reserve(2 * summary.negative.size());
        values.reserve(summary.negative.size());
        for (const Weight& weight : summary.negative) {
            pairs.insert(pairs.end(), {weight.i, weight.j});
            values.push_back(weight.value);
        }
        return object(entry("negativeOrdered", summary.negative_ordered),
                      entry("nonzeroOrdered", summary.nonzero_ordered), entry("smallest", summary.smallest),
                      entry("largest", summary.largest), entry("pairs", array(pairs)), entry("values", array(values)),
                      entry("segments", array(weights->segments)),
                      entry("segmentStarts", array(weights->segment_starts)),
                      entry("segmentPairs", array(weights->segment_pairs)));
    });
}

val smooth(Session& session, Side side, double time, int steps, bool rebuild, val callback) {
    return guarded([&] {
        Tick tick(std::move(callback));
        return nothing(session.smooth(side, {.time = time, .steps = steps, .rebuild = rebuild}, tick.monitor()));
    });
}

val harmonic(Session& session, Side side, const val& vertices, const val& values, val callback) {
    return guarded([&]() -> Result<val> {
        Tick tick(std::move(callback));
        const auto fixed = emscripten::convertJSArrayToNumberVector<Index>(vertices);
        const auto given = emscripten::convertJSArrayToNumberVector<double>(values);
        const auto harmonic = session.harmonic(side, fixed, given, tick.monitor());
        if (!harmonic) return harmonic.error();
        return object(
            entry("values", array(harmonic->values.data(), static_cast<std::size_t>(harmonic->values.size()))),
            entry("min", harmonic->min), entry("max", harmonic->max), entry("fixedMin", harmonic->fixed_min),
            entry("fixedMax", harmonic->fixed_max), entry("outside", array(harmonic->outside)));
    });
}

val sparse(SparseMatrix matrix) {
    matrix.makeCompressed();
    const auto entries = static_cast<std::size_t>(matrix.nonZeros());
    return object(entry("rows", static_cast<double>(matrix.rows())), entry("cols", static_cast<double>(matrix.cols())),
                  entry("colStarts", array(matrix.outerIndexPtr(), static_cast<std::size_t>(matrix.outerSize()) + 1)),
                  entry("rowIndices", array(matrix.innerIndexPtr(), entries)),
                  entry("values", array(matrix.valuePtr(), entries)));
}

val matrices(Session& session, Side side, val callback) {
    return guarded([&]() -> Result<val> {
        Tick tick(std::move(callback));
        const auto matrices = session.matrices(side, tick.monitor());
        if (!matrices) return matrices.error();
        return object(entry("stiffness", sparse((*matrices)->stiffness)), entry("mass", sparse((*matrices)->mass)));
    });
}

val reset(Session& session, Side side) {
    return guarded([&]() -> Result<val> {
        session.reset(side);
        return val::undefined();
    });
}

val restore(Session& session, Side side, const val& coordinates, int steps) {
    return guarded([&]() -> Result<val> {
        const auto data = emscripten::convertJSArrayToNumberVector<double>(coordinates);
        if (data.size() % 3 != 0) return Error{ErrorCode::bad_argument, "coordinates must come in threes"};
        return nothing(session.restore(
            side, Eigen::Map<const Points>(data.data(), static_cast<Eigen::Index>(data.size() / 3), 3), steps));
    });
}

// ---- Tables ----

val parameter_of(const Parameter& parameter) {
    val result = object(entry("id", std::string(parameter.id)), entry("label", std::string(parameter.label)),
                        entry("hint", std::string(parameter.hint)));
    if (parameter.kind == Parameter::Kind::choice) {
        val choices = val::array();
        for (const char* choice : parameter.choices)
            choices.call<void>("push", std::string(choice));
        result.set("kind", "choice");
        result.set("choices", choices);
        result.set("initial", std::string(parameter.choices[static_cast<std::size_t>(parameter.initial)]));
    } else {
        result.set("kind", "real");
        result.set("min", parameter.min);
        result.set("max", parameter.max);
        result.set("sliderMax", parameter.slider_max);
        result.set("step", parameter.step);
        result.set("initial", parameter.initial);
    }
    return result;
}

val operator_table() {
    return guarded([]() -> Result<val> {
        val table = val::array();
        for (const OperatorInfo* info : operators()) {
            val parameters = val::array();
            for (const Parameter& parameter : info->parameters)
                parameters.call<void>("push", parameter_of(parameter));
            val claims = val::object();
            for (const PropertyInfo& property : properties()) {
                const PropertyClaim& claim = info->claims.*property.claim;
                claims.set(property.id, object(entry("where", std::string(claim_name(claim.where))),
                                               entry("why", std::string(claim.why))));
            }
            table.call<void>("push",
                             object(entry("id", std::string(info->id)), entry("label", std::string(info->label)),
                                    entry("summary", std::string(info->summary)),
                                    entry("formulaLatex", std::string(info->formula_latex)),
                                    entry("citation", std::string(info->citation)), entry("parameters", parameters),
                                    entry("takesVertexWeights", info->takes_vertex_weights), entry("claims", claims)));
        }
        return table;
    });
}

val property_table() {
    return guarded([]() -> Result<val> {
        val table = val::array();
        for (const PropertyInfo& property : properties())
            table.call<void>("push",
                             object(entry("id", std::string(property.id)), entry("label", std::string(property.label)),
                                    entry("meaning", std::string(property.meaning))));
        return table;
    });
}

val error_codes() {
    return guarded([]() -> Result<val> {
        val names = val::array();
        for (int code = 0; code <= static_cast<int>(ErrorCode::out_of_memory); ++code) {
            names.call<void>("push", std::string(error_code_name(static_cast<ErrorCode>(code))));
        }
        return names;
    });
}

}  // namespace

EMSCRIPTEN_BINDINGS(polylap) {
    using emscripten::class_;
    using emscripten::function;

    emscripten::enum_<Side>("Side").value("a", Side::a).value("b", Side::b);

    class_<Session>("Session")
        .smart_ptr<std::shared_ptr<Session>>("SharedSession")
        .function("info", &info)
        .function("geometry", &geometry)
        .function("surface", &surface)
        .function("shape", &shape)
        .function("obj", &obj)
        .function("setOperator", &set_operator)
        .function("weights", &weights)
        .function("smooth", &smooth)
        .function("harmonic", &harmonic)
        .function("matrices", &matrices)
        .function("reset", &reset)
        .function("restore", &restore);

    function("open", &open);
    function("makeTorus", &make_torus_session);
    function("makeGrid", &make_grid_session);
    function("makeSaddle", &make_saddle_session);
    function("operators", &operator_table);
    function("properties", &property_table);
    function("errorCodes", &error_codes);
}

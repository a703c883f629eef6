// Session for JavaScript. No algorithms: arguments come in, JavaScript values go out (see values.hpp).

#include <algorithm>

#include <emscripten/bind.h>

#include "polylap/apply/noise.hpp"
#include "polylap/mesh/shapes.hpp"
#include "results.hpp"

namespace polylap::js {
namespace {

using Side = Session::Side;

// ---- Making a session ----

val from_arrays(const val& coordinates, const val& offsets, const val& corners, val callback) {
    return guarded([&]() -> Result<val> {
        auto points = points_of(coordinates);
        if (!points) return points.error();
        using emscripten::convertJSArrayToNumberVector;
        auto mesh = PolygonMesh::create(*std::move(points), convertJSArrayToNumberVector<Index>(offsets),
                                        convertJSArrayToNumberVector<Index>(corners));
        if (!mesh) return mesh.error();
        Tick tick(std::move(callback));
        return owned(Session::from_mesh(*std::move(mesh), tick.monitor()));
    });
}

bool is_seed(std::string_view name) {
    return name == "seed";
}

val make(const std::string& id, const val& settings, double noise, std::uint32_t seed) {
    return guarded([&]() -> Result<val> {
        const auto info = find_shape(id);
        if (!info) return info.error();
        auto given = settings_of(settings);
        // The seed is the noise's, and that of the shape itself where it has one.
        const auto& parameters = (*info)->parameters;
        if (std::none_of(parameters.begin(), parameters.end(), [](const Parameter& p) { return is_seed(p.id); }))
            std::erase_if(given, [](const auto& setting) { return is_seed(setting.first); });
        auto mesh = make_shape(id, given);
        if (mesh && noise != 0) mesh = add_normal_noise(*mesh, noise, seed);
        if (!mesh) return mesh.error();
        return owned(Session::from_mesh(*std::move(mesh)));
    });
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
        const auto told_issue = [](const MeshIssue& issue) {
            return object(entry("kind", std::string(issue_name(issue.kind))), entry("count", issue.count),
                          entry("message", issue.message));
        };
        return object(entry("vertices", mesh.vertex_count()), entry("faces", mesh.face_count()),
                      entry("edges", static_cast<double>(topology.edges.size())),
                      entry("components", topology.component_count), entry("minCorners", fewest),
                      entry("maxCorners", most),
                      entry("meanSquaredEdge", measure_shape(mesh, topology).mean_squared_edge),
                      entry("boundary", array(topology.boundary_vertices)),
                      entry("issues", list(find_issues(topology), told_issue)),
                      entry("notes", list(session.notes(), [](const std::string& note) { return note; })),
                      entry("repairs", told(session.repairs())));
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

val coordinates(const Session& session) {
    return guarded([&]() -> Result<val> {
        const Points& points = session.mesh().positions();
        return array(points.data(), static_cast<std::size_t>(points.size()));
    });
}

val surface(const Session& session, Side side) {
    return guarded([&]() -> Result<val> {
        const Points& points = session.surface(side).positions();
        return object(entry("step", session.step_count(side)), entry("positions", array(session.float_positions(side))),
                      entry("coordinates", array(points.data(), static_cast<std::size_t>(points.size()))),
                      entry("stats", told(session.shape(side))), entry("solve", told(session.last_solve(side))));
    });
}

val shape(const Session& session, Side side) {
    return guarded([&]() -> Result<val> { return told(session.shape(side)); });
}

// ---- Working on a session ----

val set_operator(Session& session, Side side, const std::string& id, const val& settings, const val& vertex_weights) {
    return guarded([&]() -> Result<val> {
        auto spec = spec_of(id, settings, vertex_weights);
        if (!spec) return spec.error();
        return nothing(session.set_operator(side, *std::move(spec)));
    });
}

val weights(Session& session, Side side, val callback) {
    return guarded([&]() -> Result<val> {
        Tick tick(std::move(callback));
        const auto weights = session.weights(side, tick.monitor());
        if (!weights) return weights.error();
        return told(*weights);
    });
}

val row(Session& session, Side side, Index vertex, val callback) {
    return guarded([&]() -> Result<val> {
        Tick tick(std::move(callback));
        const auto row = session.row(side, vertex, tick.monitor());
        if (!row) return row.error();
        return told(*row);
    });
}

val energy(Session& session, Side side, val callback) {
    return guarded([&]() -> Result<val> {
        Tick tick(std::move(callback));
        const auto energy = session.energy(side, tick.monitor());
        if (!energy) return energy.error();
        return val(*energy);
    });
}

val face(const Session& session, Side side, Index number) {
    return guarded([&]() -> Result<val> {
        const auto face = session.face(side, number);
        if (!face) return face.error();
        return told(*face);
    });
}

/// What session.ts makes of SmoothOptions: all of them, checked.
Result<Session::SmoothOptions> flow_of(const val& options) {
    const auto flow = find_flow(options["flow"].as<std::string>());
    if (!flow) return flow.error();
    return Session::SmoothOptions{.time = options["time"].as<double>(),
                                  .steps = options["steps"].as<int>(),
                                  .flow = *flow,
                                  .rebuild = options["rebuild"].as<bool>(),
                                  .keep_volume = options["keepVolume"].as<bool>(),
                                  .fix_boundary = options["fixBoundary"].as<bool>()};
}

val smooth(Session& session, Side side, const val& options, val callback) {
    return guarded([&]() -> Result<val> {
        const auto flow = flow_of(options);
        if (!flow) return flow.error();
        Tick tick(std::move(callback));
        return nothing(session.smooth(side, *flow, tick.monitor()));
    });
}

val stability(Session& session, Side side, const val& options, val callback) {
    return guarded([&]() -> Result<val> {
        const auto flow = flow_of(options);
        if (!flow) return flow.error();
        Tick tick(std::move(callback));
        const auto stability = session.stability(side, *flow, tick.monitor());
        if (!stability) return stability.error();
        return object(entry("largest", stability->largest), entry("smallest", stability->smallest),
                      entry("limit", stability->limit()));
    });
}

val harmonic(Session& session, Side side, const val& vertices, const val& values, val callback) {
    return guarded([&]() -> Result<val> {
        Tick tick(std::move(callback));
        const auto fixed = emscripten::convertJSArrayToNumberVector<Index>(vertices);
        const auto given = emscripten::convertJSArrayToNumberVector<double>(values);
        const auto harmonic = session.harmonic(side, fixed, given, tick.monitor());
        if (!harmonic) return harmonic.error();
        return told(*harmonic);
    });
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
        auto points = points_of(coordinates);
        if (!points) return points.error();
        return nothing(session.restore(side, *std::move(points), steps));
    });
}

// ---- The operator table ----

val operator_ids() {
    return guarded([]() -> Result<val> {
        return list(operators(), [](const OperatorInfo* info) { return std::string(info->id); });
    });
}

}  // namespace
}  // namespace polylap::js

EMSCRIPTEN_BINDINGS(polylap_session) {
    using emscripten::class_;
    using emscripten::function;
    using namespace polylap::js;
    using polylap::Session;

    emscripten::enum_<Session::Side>("Side").value("a", Session::Side::a).value("b", Session::Side::b);

    class_<Session>("Session")
        .smart_ptr<std::shared_ptr<Session>>("SharedSession")
        .function("info", &info)
        .function("geometry", &geometry)
        .function("coordinates", &coordinates)
        .function("surface", &surface)
        .function("shape", &shape)
        .function("setOperator", &set_operator)
        .function("weights", &weights)
        .function("row", &row)
        .function("face", &face)
        .function("energy", &energy)
        .function("smooth", &smooth)
        .function("stability", &stability)
        .function("harmonic", &harmonic)
        .function("matrices", &matrices)
        .function("reset", &reset)
        .function("restore", &restore);

    function("operatorIds", &operator_ids);
    function("fromArrays", &from_arrays);
    function("make", &make);
}

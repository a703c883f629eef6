#include "polylap/session.hpp"

#include <algorithm>
#include <cmath>

#include "polylap/mesh/mesh_io.hpp"
#include "session_impl.hpp"

namespace polylap {
namespace {

/// Lines as floats, into an answer that has fields for them.
template <class Answer>
void keep_lines(SurfaceLines lines, const Vector3& origin, Answer& answer) {
    for (const auto& segment : lines.segments)
        for (const Vector3& end : segment)
            for (int k = 0; k < 3; ++k)
                answer.segments.push_back(static_cast<float>(end[k] - origin[k]));
    answer.segment_starts.assign(lines.start.begin(), lines.start.end());
    answer.segment_pairs = std::move(lines.pair);
}

}  // namespace

Session::Session(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

Result<Session> Session::from_mesh(PolygonMesh mesh, Monitor monitor) {
    return guard_memory([&]() -> Result<Session> {
        auto triangles = triangulate_for_display(mesh, monitor);
        if (!triangles) return triangles.error();
        return Session(std::make_unique<Impl>(std::move(mesh), *std::move(triangles)));
    });
}

Result<Session> Session::open(std::span<const std::byte> bytes, std::string_view name, Monitor monitor) {
    return open(bytes, name, {}, monitor);
}

Result<Session> Session::open(std::span<const std::byte> bytes, std::string_view name, const OpenOptions& options,
                              Monitor monitor) {
    return guard_memory([&]() -> Result<Session> {
        const auto format = format_of(name);
        if (!format) return format.error();
        if (!options.repair) {
            Stretch reading{monitor, 0, 0.8};
            Stretch cutting{monitor, 0.8, 1};
            auto read = read_mesh_with_notes(bytes, *format, reading.monitor());
            if (!read) return read.error();
            auto session = from_mesh(std::move(read->mesh), cutting.monitor());
            if (session) session->impl_->notes = std::move(read->notes);
            return session;
        }
        Stretch reading{monitor, 0, 0.4};
        Stretch repairing{monitor, 0.4, 0.8};
        Stretch cutting{monitor, 0.8, 1};
        auto raw = read_raw(bytes, *format, reading.monitor());
        if (!raw) return raw.error();
        auto repaired = repair(*raw, options.repair_options, repairing.monitor());
        if (!repaired) return repaired.error();
        auto session = from_mesh(std::move(repaired->mesh), cutting.monitor());
        if (session) {
            session->impl_->notes = std::move(raw->notes);
            session->impl_->repairs = {std::move(repaired->changes), std::move(repaired->original_vertices),
                                       std::move(repaired->original_faces)};
        }
        return session;
    });
}

const PolygonMesh& Session::mesh() const noexcept {
    return impl_->loaded;
}
const Topology& Session::topology() const noexcept {
    return impl_->topology;
}
const DisplayTriangles& Session::display() const noexcept {
    return impl_->display;
}
const Session::Repairs& Session::repairs() const noexcept {
    return impl_->repairs;
}
const std::vector<std::string>& Session::notes() const noexcept {
    return impl_->notes;
}
const Vector3& Session::origin() const noexcept {
    return impl_->origin;
}

Status Session::set_operator(Side side, OperatorSpec spec) {
    return guard_memory([&]() -> Status {
        auto complete = complete_spec(std::move(spec));
        if (!complete) return complete.error();
        impl_->side(side).spec = *std::move(complete);
        return Done{};
    });
}

const OperatorSpec& Session::spec(Side side) const noexcept {
    return impl_->side(side).spec;
}
const PolygonMesh& Session::surface(Side side) const noexcept {
    return impl_->side(side).surface;
}
int Session::step_count(Side side) const noexcept {
    return impl_->side(side).steps;
}
const std::optional<SmoothingSolve>& Session::last_solve(Side side) const noexcept {
    return impl_->side(side).solve;
}

std::vector<float> Session::float_positions(Side side) const {
    return impl_->to_float(impl_->side(side).surface.positions());
}

Result<const OperatorMatrices*> Session::matrices(Side side, Monitor monitor) {
    return guard_memory([&]() -> Result<const OperatorMatrices*> {
        const SideState& state = impl_->side(side);
        auto built = impl_->build(state.surface, state.key(), monitor);
        if (!built) return built.error();
        return built->get();  // the cache holds it until a later call
    });
}

Result<Session::Weights> Session::weights(Side side, Monitor monitor) {
    const auto built = matrices(side, monitor);
    if (!built) return built.error();
    return guard_memory([&]() -> Result<Weights> {
        Weights weights;
        weights.summary = summarise_weights((*built)->stiffness);
        keep_lines(drape_pairs(surface(side), impl_->display, weights.summary.negative, most_segments), impl_->origin,
                   weights);
        return weights;
    });
}

Result<Session::Row> Session::row(Side side, Index vertex, Monitor monitor) {
    if (vertex < 0 || vertex >= mesh().vertex_count()) {
        return Error{ErrorCode::bad_argument, "there is no vertex " + std::to_string(vertex) + ": the mesh has " +
                                                  std::to_string(mesh().vertex_count()) + " (counted from 0)"};
    }
    const auto built = matrices(side, monitor);
    if (!built) return built.error();
    return guard_memory([&]() -> Result<Row> {
        Row row;
        row.entries = row_of(**built, vertex);
        std::vector<Weight> spokes;
        std::vector<Index> entry;
        for (std::size_t k = 0; k < row.entries.columns.size(); ++k) {
            if (row.entries.columns[k] == vertex) continue;
            spokes.push_back({vertex, row.entries.columns[k], -row.entries.values[k]});
            entry.push_back(static_cast<Index>(k));
        }
        keep_lines(drape_pairs(surface(side), impl_->display, spokes), impl_->origin, row);
        for (Index& pair : row.segment_pairs)
            pair = entry[static_cast<std::size_t>(pair)];
        return row;
    });
}

Result<FaceReport> Session::face(Side side, Index face) const {
    return inspect_face(surface(side), spec(side), face);
}

Session::Shape Session::shape(Side side) const {
    Shape shape;
    shape.measures = measure_shape(surface(side), impl_->topology);
    if (const auto volume = enclosed_volume(surface(side), impl_->topology); volume) {
        shape.volume = *volume;
    } else {
        shape.no_volume = volume.error().message;
    }
    return shape;
}

Result<Session::Harmonic> Session::harmonic(Side side, std::span<const Index> vertices, std::span<const double> values,
                                            Monitor monitor) {
    if (vertices.size() != values.size()) {
        return Error{ErrorCode::bad_argument, std::to_string(vertices.size()) + " vertices are fixed, but " +
                                                  std::to_string(values.size()) + " values were given"};
    }
    return guard_memory([&]() -> Result<Harmonic> {
        const SideState& state = impl_->side(side);
        const bool keeps_constants = (*find_operator(state.spec.id))->claims.constants_in_kernel.where == Claim::yes;
        HarmonicSlot& slot = impl_->harmonic(side);
        if (slot.matrices != state.key()) {
            slot = {};  // before the next needs memory
            Stretch building{monitor, 0, 0.3};
            const auto built = impl_->build(state.surface, state.key(), building.monitor());
            if (!built) return built.error();
            slot.problem.emplace(*built, keeps_constants);
            slot.matrices = state.key();
        }
        if (!monitor.proceed(0.3)) return Error{ErrorCode::cancelled, "cancelled"};

        const Eigen::Map<const Vector> given(values.data(), static_cast<Eigen::Index>(values.size()));
        Stretch solving{monitor, 0.3, 1};
        slot.last_use = ++impl_->uses;
        const HarmonicProblem::Resources resources{state.surface.positions(), impl_->analyses,
                                                   [&] { impl_->make_room(&slot); }};
        auto solution = slot.problem->solve(vertices, given, resources, solving.monitor());
        if (!solution) return solution.error();
        if (!monitor.proceed(1)) return Error{ErrorCode::cancelled, "cancelled"};

        // Rounding scales with the width of the range, not with where it lies.
        const double base = solution->base;
        Harmonic harmonic;
        if (given.size() > 0) {
            harmonic.fixed_min = harmonic.min = given.minCoeff();
            harmonic.fixed_max = harmonic.max = given.maxCoeff();
        }
        harmonic.values = std::move(solution->above);
        const double width = harmonic.fixed_max - harmonic.fixed_min;
        const double size = std::max(std::abs(harmonic.fixed_min), std::abs(harmonic.fixed_max));
        const double slack = outside_tolerance * (keeps_constants ? width : size);
        const double lowest = harmonic.fixed_min - base - slack;
        const double highest = harmonic.fixed_max - base + slack;
        for (Index v = 0; v < harmonic.values.size(); ++v) {
            const double u = harmonic.values[v];
            if (u < lowest || u > highest) harmonic.outside.push_back(v);
        }
        harmonic.values.array() += base;
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            harmonic.values[vertices[k]] = values[k];
        }
        for (const double u : harmonic.values) {
            if (std::isnan(u)) continue;
            harmonic.min = std::min(harmonic.min, u);
            harmonic.max = std::max(harmonic.max, u);
        }
        return harmonic;
    });
}

Result<const PropertyReport*> Session::check(Side side, Monitor monitor) {
    return guard_memory([&]() -> Result<const PropertyReport*> {
        const SideState& state = impl_->side(side);
        const auto report = impl_->reports.get(state.key(), [&]() -> Result<PropertyReport> {
            Stretch building{monitor, 0, 0.1};
            Stretch measuring{monitor, 0.1, 1};
            const auto built = impl_->build(state.surface, state.key(), building.monitor());
            if (!built) return built.error();
            return check_properties(state.surface, impl_->topology, **built, measuring.monitor());
        });
        if (!report) return report.error();
        return report->get();  // the cache holds it until a later call
    });
}

Result<Eigenpairs> Session::spectrum(Side side, Index count, Monitor monitor) {
    Stretch building{monitor, 0, 0.1};
    Stretch solving{monitor, 0.1, 1};
    const auto built = matrices(side, building.monitor());
    if (!built) return built.error();
    if ((*built)->structure == Structure::general) {
        return Error{ErrorCode::bad_argument,
                     "the stiffness of '" + spec(side).id +
                         "' is not symmetric: its eigenvalues need not be real, and only those of symmetric operators "
                         "are found"};
    }
    return lowest_eigenpairs((*built)->stiffness, (*built)->mass, count, solving.monitor(), surface(side).positions());
}

Result<double> Session::energy(Side side, Monitor monitor) {
    const auto built = matrices(side, monitor);
    if (!built) return built.error();
    return guard_memory([&]() -> Result<double> {
        // Relative to the middle of the mesh: where constants have no energy, it loses no digits.
        const Points points = surface(side).positions().rowwise() - impl_->origin.transpose();
        const Points weighed = (*built)->stiffness * points;
        return points.cwiseProduct(weighed).sum();
    });
}

Result<OrthogonalDual> Session::dual(Side side, DualOptions options, Monitor monitor) {
    return orthogonal_dual(impl_->side(side).surface, options, monitor);
}

void Session::reset(Side side) {
    SideState& state = impl_->side(side);
    state.surface = impl_->loaded;
    state.version = 0;
    state.steps = 0;
    state.solve.reset();
}

Status Session::restore(Side side, Points positions, int steps) {
    return guard_memory([&]() -> Status {
        if (steps < 0) return Error{ErrorCode::bad_argument, "the number of steps must not be negative"};
        auto surface = impl_->loaded.with_positions(std::move(positions));
        if (!surface) return surface.error();
        SideState& state = impl_->side(side);
        state.surface = *std::move(surface);
        state.version = ++impl_->last_version;
        state.steps = steps;
        state.solve.reset();
        return Done{};
    });
}

}  // namespace polylap

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "cache.hpp"
#include "factor_room.hpp"
#include "harmonic_problem.hpp"
#include "known_analyses.hpp"
#include "polylap/session.hpp"

// What a Session holds: for session*.cpp alone.

namespace polylap {

/// What matrices depend on. Every surface that a session makes gets a new version, the loaded mesh is 0.
struct MatricesKey {
    std::int64_t surface;
    OperatorSpec spec;
    friend bool operator==(const MatricesKey&, const MatricesKey&) = default;
};

inline std::int64_t bytes_of(const SparseMatrix& matrix) {
    return std::int64_t{matrix.nonZeros()} * static_cast<std::int64_t>(sizeof(double) + sizeof(Index));
}
inline std::int64_t bytes_of(const OperatorMatrices& matrices) {
    return bytes_of(matrices.stiffness) + bytes_of(matrices.mass);
}
inline std::int64_t bytes_of(const PropertyReport& report) {
    return std::int64_t{report.kernel_modes.size()} * static_cast<std::int64_t>(sizeof(double));
}

/// Beyond this, only the matrices (the report) that were used last are kept: those of 500 000 vertices, of quads, have
/// half of it. All are made again in a fraction of the time that a factor takes.
inline constexpr std::int64_t most_kept_bytes = std::int64_t{128} << 20;

/// Beyond this, a new factor takes the place of those that were used longest ago. On a quad mesh of a million vertices
/// one has 700 MB.
inline constexpr std::int64_t most_factor_bytes = std::int64_t{768} << 20;

/// What a system M + tS depends on.
struct SystemKey {
    MatricesKey stiffness;
    std::int64_t mass;  ///< The surface that M is built on.
    double time;
    bool fixes_boundary;
    friend bool operator==(const SystemKey&, const SystemKey&) = default;
};

/// The last system of a side, with its factor where there is one.
struct SmootherSlot {
    std::optional<SystemKey> key;
    std::optional<ImplicitSmoother> smoother;
    std::int64_t last_use = 0;

    std::int64_t bytes() const { return smoother ? smoother->bytes() : 0; }

    Status prepare(const SystemKey& system, const OperatorMatrices& built, const SmootherOptions& options) {
        key.reset();
        if (!smoother) smoother.emplace();
        if (Status status = smoother->update_later(built, system.time, options); !status) return status;
        key = system;
        return Done{};
    }
};

/// The last harmonic problem.
struct HarmonicSlot {
    std::optional<MatricesKey> matrices;
    std::optional<HarmonicProblem> problem;
    std::int64_t last_use = 0;

    std::int64_t bytes() const { return problem ? problem->bytes() : 0; }
};

struct SideState {
    OperatorSpec spec;
    PolygonMesh surface;
    std::int64_t version = 0;
    int steps = 0;
    std::optional<SmoothingSolve> solve = {};  ///< Of the step that led to the surface.

    MatricesKey key() const { return {version, spec}; }
};

/// The last bound of a side's explicit steps.
struct StabilitySlot {
    std::optional<MatricesKey> matrices;
    bool fixes_boundary = false;
    Stability value;
};

struct Session::Impl {
    PolygonMesh loaded;
    Repairs repairs;
    std::vector<std::string> notes;
    Topology topology;
    DisplayTriangles display;
    Vector3 origin;
    std::array<SideState, 2> sides;
    std::int64_t last_version = 0;

    // Two sides before and after a step, or two sides with two specs each.
    Cache<MatricesKey, OperatorMatrices, 4, bytes_of> matrices{most_kept_bytes};
    KnownAnalyses analyses;
    std::array<SmootherSlot, 2> smoothers;
    std::array<HarmonicSlot, 2> harmonics;
    Cache<MatricesKey, PropertyReport, 4, bytes_of> reports{most_kept_bytes};
    std::array<StabilitySlot, 2> stabilities;
    std::int64_t uses = 0;

    Impl(PolygonMesh mesh, DisplayTriangles triangles)
        : loaded(std::move(mesh)),
          topology(build_topology(*loaded.connectivity())),
          display(std::move(triangles)),
          origin(0.5 * (loaded.positions().colwise().minCoeff() + loaded.positions().colwise().maxCoeff()).transpose()),
          sides{SideState{default_spec(0), loaded}, SideState{default_spec(1), loaded}} {}

    static OperatorSpec default_spec(std::size_t side) { return *make_spec(opening_pair()[side]->id, {}); }

    SideState& side(Side s) { return sides[static_cast<std::size_t>(s)]; }
    HarmonicSlot& harmonic(Side s) { return harmonics[static_cast<std::size_t>(s)]; }
    SmootherSlot& smoother(Side s) { return smoothers[static_cast<std::size_t>(s)]; }

    Result<std::shared_ptr<const OperatorMatrices>> build(const PolygonMesh& surface, const MatricesKey& key,
                                                          Monitor monitor) {
        return matrices.get(key, [&] { return build_operator(surface, key.spec, monitor); });
    }

    /// Drops factors of other slots until there is room for one in this.
    void make_room(const void* slot) {
        const auto for_slots = [this](auto&& visit) {
            std::size_t k = 0;
            for (SmootherSlot& one : smoothers)
                visit(one, k++);
            for (HarmonicSlot& one : harmonics)
                visit(one, k++);
        };
        for (;;) {
            std::array<KeptFactor, 4> factors;
            std::size_t mine = factors.size();
            for_slots([&](const auto& one, std::size_t k) {
                factors[k] = {one.bytes(), one.last_use};
                if (&one == slot) mine = k;
            });
            const auto dropped = factor_to_drop(factors, mine, most_factor_bytes);
            if (!dropped) return;
            for_slots([&](auto& one, std::size_t k) {
                if (k == dropped) one = {};
            });
        }
    }

    /// The vertices that a step leaves where they are.
    std::span<const Index> fixed(const SmoothOptions& options) const {
        if (!options.fix_boundary) return {};
        return topology.boundary_vertices;
    }

    /// S and M of a surface that the step leaves: no need to have them beside a factor.
    Result<std::shared_ptr<const OperatorMatrices>> take(const PolygonMesh& surface, const MatricesKey& key,
                                                         Monitor monitor);
    /// S of the loaded mesh, M of the moved one.
    Result<std::shared_ptr<const OperatorMatrices>> take_conformalised(const SideState& moved, Monitor monitor);
    Result<SmoothingStep> step_explicitly(const SideState& moved, const SmoothOptions& options, Monitor monitor);
    /// @param steps_to_come with this one
    Result<SmoothingStep> step_implicitly(Side which, const SideState& moved, const SmoothOptions& options,
                                          int steps_to_come, Monitor monitor);

    std::vector<float> to_float(const Points& points) const {
        std::vector<float> out(static_cast<std::size_t>(points.size()));
        Eigen::Map<Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>>(out.data(), points.rows(), 3) =
            (points.rowwise() - origin.transpose()).cast<float>();
        return out;
    }
};

}  // namespace polylap

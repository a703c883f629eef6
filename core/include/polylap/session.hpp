#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polylap/apply/diagnostics.hpp"
#include "polylap/apply/display.hpp"
#include "polylap/apply/explicit_step.hpp"
#include "polylap/apply/flow.hpp"
#include "polylap/apply/inspect.hpp"
#include "polylap/apply/properties.hpp"
#include "polylap/apply/smoothing.hpp"
#include "polylap/mesh/repair.hpp"
#include "polylap/mesh/topology.hpp"
#include "polylap/operators/dual_vertices.hpp"
#include "polylap/operators/operator.hpp"
#include "polylap/solve/eigenpairs.hpp"

namespace polylap {

/// One mesh, two sides that each have an operator and a surface of their own, and caches: the facade behind the page.
///
/// Both sides start on the loaded mesh. Smoothing moves a side's surface; weights and harmonic functions are those of
/// the surface as it stands. What was built is kept for as long as surface, whole spec and problem stay the same. A
/// call that fails changes nothing.
class Session {
public:
    enum class Side : std::uint8_t { a, b };

    struct OpenOptions {
        bool repair = false;  ///< Repair what can be, see repair.hpp; what was changed is in repairs().
        RepairOptions repair_options = {};
    };
    /// Reads a mesh file; the format follows from the ending of `name`, see format_of.
    /// @error bad_argument (unknown ending), parse_error (line), bad_mesh, out_of_memory, cancelled
    static Result<Session> open(std::span<const std::byte> bytes, std::string_view name, Monitor monitor = {});
    static Result<Session> open(std::span<const std::byte> bytes, std::string_view name, const OpenOptions& options,
                                Monitor monitor = {});
    /// @error out_of_memory, cancelled
    static Result<Session> from_mesh(PolygonMesh mesh, Monitor monitor = {});

    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;
    ~Session();

    /// The mesh as loaded.
    const PolygonMesh& mesh() const noexcept;
    const Topology& topology() const noexcept;
    const DisplayTriangles& display() const noexcept;

    /// What repair changed when the mesh was opened, and the file's numbers of its vertices and faces; empty without.
    struct Repairs {
        std::vector<RepairChange> changes;
        std::vector<Index> original_vertices, original_faces;
    };
    const Repairs& repairs() const noexcept;
    /// What reading a file did to its data (see RawMesh::notes).
    const std::vector<std::string>& notes() const noexcept;

    /// Centre of the loaded mesh's bounding box: float outputs are relative to it, so that meshes far from 0 keep their
    /// digits.
    const Vector3& origin() const noexcept;

    /// @error see complete_spec; the side keeps its operator then
    Status set_operator(Side side, OperatorSpec spec);
    const OperatorSpec& spec(Side side) const noexcept;

    /// The side's surface as it stands, and how many smoothing steps led there.
    const PolygonMesh& surface(Side side) const noexcept;
    int step_count(Side side) const noexcept;
    /// How the smoothing step that led to the side's surface was solved; empty where none did, or another session's.
    const std::optional<SmoothingSolve>& last_solve(Side side) const noexcept;
    /// 3V floats: the surface relative to origin().
    std::vector<float> float_positions(Side side) const;

    /// S and M of the side's operator on its surface; valid until the next call.
    /// @error see build_operator
    Result<const OperatorMatrices*> matrices(Side side, Monitor monitor = {});

    struct Weights {
        WeightSummary summary;
        /// 6 a segment: both ends relative to origin(), laid on the surface (see drape_pairs). Where most_segments is
        /// reached, of an even choice of the pairs.
        std::vector<float> segments;
        std::vector<float> segment_starts;  ///< Per segment, length along its line.
        std::vector<Index> segment_pairs;   ///< Per segment, index into summary.negative.
    };
    /// As many lines as a picture can show: a face of n corners has up to n² pairs, each across up to n triangles.
    static constexpr std::size_t most_segments = 400'000;
    Result<Weights> weights(Side side, Monitor monitor = {});

    struct Row {
        MatrixRow entries;
        /// 6 a segment: lines from the vertex to the others of its row, laid on the surface as in Weights.
        std::vector<float> segments;
        std::vector<float> segment_starts;
        std::vector<Index> segment_pairs;  ///< Per segment, index into entries.columns.
    };
    /// The row of a vertex in the matrices of the side's operator on its surface: at once where they are kept.
    /// @error bad_argument (no such vertex), and see build_operator
    Result<Row> row(Side side, Index vertex, Monitor monitor = {});

    /// A face of the side's surface, as its operator sees it.
    /// @error see inspect_face
    Result<FaceReport> face(Side side, Index face) const;

    struct Shape {
        ShapeMeasures measures;
        std::optional<double> volume;  ///< Only of a closed, consistently oriented surface.
        std::string no_volume;         ///< Why there is no volume.
    };
    Shape shape(Side side) const;

    struct SmoothOptions {
        double time = 0;  ///< t, length².
        int steps = 1;
        Flow flow = Flow::implicit_step;
        /// Build S and M anew on the moved surface before each step; otherwise keep those of the loaded mesh. The
        /// conformalised flow has its own rule.
        bool rebuild = true;
        /// After each step, scale the surface about the centroid of its area to the volume of the loaded mesh.
        bool keep_volume = false;
        /// Vertices on the boundary stay (Dirichlet conditions). A closed surface has none. Then the conformalised flow
        /// does not scale.
        bool fix_boundary = false;
    };
    /// Smooths the side's surface. Stops between steps when the monitor says so, and leaves the surface as it was.
    /// @error bad_argument, degenerate_face (element = face), mass_not_positive, not_positive_definite (element =
    /// vertex), open_mesh, non_manifold_edge (element = edge: no volume to keep), not_converged (an explicit step takes
    /// a vertex beyond largest_coordinate; the volume cannot be kept), out_of_memory, cancelled
    Status smooth(Side side, const SmoothOptions& options, Monitor monitor = {});

    /// What bounds the explicit step that `options` describe, whatever their flow: of S and M on the side's surface, or
    /// on the loaded mesh where they are not rebuilt.
    /// @error see explicit_stability and build_operator
    Result<Stability> stability(Side side, const SmoothOptions& options, Monitor monitor = {});

    struct Harmonic {
        Vector values;            ///< V; NaN at unreferenced vertices.
        double min = 0, max = 0;  ///< Over the finite values.
        double fixed_min = 0, fixed_max = 0;
        std::vector<Index>
            outside;  ///< Vertices beyond the fixed range by more than outside_tolerance: the maximum principle fails.
    };
    /// Relative to the width of the fixed range (of operators that do not keep constants: to the largest fixed value).
    static constexpr double outside_tolerance = 1e-9;
    /// The harmonic function of the side's operator on its surface with the given values at the given vertices.
    /// @error bad_argument (lengths differ, vertex out of range or twice, value not finite), unconstrained_component,
    /// not_positive_definite (element = vertex), …
    Result<Harmonic> harmonic(Side side, std::span<const Index> vertices, std::span<const double> values,
                              Monitor monitor = {});

    /// The properties of the side's operator on its surface; valid until the next call.
    /// @error see build_operator
    Result<const PropertyReport*> check(Side side, Monitor monitor = {});

    /// The lowest eigenpairs of S x = μ M x of the side's operator on its surface, see lowest_eigenpairs.
    /// @error bad_argument (S is not symmetric or M not diagonal), see build_operator and lowest_eigenpairs
    Result<Eigenpairs> spectrum(Side side, Index count, Monitor monitor = {});

    /// Dirichlet energy of the side's surface: Σ xᵀ S x over its coordinates x about origin(), length²; of linear
    /// finite elements twice the area.
    /// @error see build_operator
    Result<double> energy(Side side, Monitor monitor = {});

    /// The orthogonal dual of the side's surface.
    /// @error see orthogonal_dual
    Result<OrthogonalDual> dual(Side side, DualOptions options = {}, Monitor monitor = {});

    /// Back to the loaded mesh.
    void reset(Side side);
    /// Puts a side onto given positions, as after `steps` smoothing steps: takes up work where another session left it.
    /// @error bad_argument, bad_mesh
    Status restore(Side side, Points positions, int steps);

private:
    struct Impl;
    explicit Session(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace polylap

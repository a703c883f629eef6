#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "polylap/base/monitor.hpp"
#include "polylap/base/parameter.hpp"
#include "polylap/face/triangulate.hpp"
#include "polylap/mesh/polygon_mesh.hpp"
#include "polylap/solve/structure.hpp"

namespace polylap {

/// Where a property holds: everywhere, on meshes whose faces are planar, on triangle meshes, everywhere with the
/// initial values of the parameters but not with some others (the reason names them), or nowhere in general.
enum class Claim : std::uint8_t { yes, planar, triangles, some, no };
std::string_view claim_name(Claim claim) noexcept;

/// What an operator claims of a property, and why: one clause for people.
struct PropertyClaim {
    Claim where;
    const char* why;
};

/// The properties of Wardetzky et al. 2007, "Discrete Laplace operators: no free lunch", as an operator claims them for
/// all values of its parameters, unless the claim is `some`.
struct PropertyClaims {
    PropertyClaim symmetric;              ///< S = Sᵀ
    PropertyClaim local;                  ///< S_ij ≠ 0 only where i and j share a face.
    PropertyClaim positive_weights;       ///< w_ij = -S_ij ≥ 0
    PropertyClaim positive_semidefinite;  ///< uᵀ S u ≥ 0
    PropertyClaim constants_in_kernel;    ///< S 1 = 0
    PropertyClaim linear_precision;       ///< (S x)ᵢ = 0 at inner vertices whose surroundings lie in one plane.
    PropertyClaim maximum_principle;      ///< Harmonic functions stay within the range of their boundary values.
    PropertyClaim convergent;             ///< Solutions approach the smooth ones under refinement.
};

/// One line of the property table.
struct PropertyInfo {
    const char* id;       ///< Camel case, as in JSON and JavaScript, e.g. "positiveWeights".
    const char* label;    ///< E.g. "Weights ≥ 0".
    const char* meaning;  ///< One sentence.
    PropertyClaim PropertyClaims::*claim;
};

/// The property table, in the order of PropertyClaims.
std::span<const PropertyInfo> properties() noexcept;

/// Which operator, with which parameters.
struct OperatorSpec {
    std::string id;
    std::vector<double> values;  ///< One per parameter of the table; missing ones take their initial value.
    /// ω, V values, length²; empty: all 0. Only for operators that take them.
    std::vector<double> vertex_weights = {};

    friend bool operator==(const OperatorSpec&, const OperatorSpec&) = default;
};

/// S: V×V, (S u)ᵢ = Σ w_ij (uᵢ - uⱼ), unitless. M: V×V, length², diagonal or (Galerkin) sparse symmetric. Both stored
/// in full.
///
/// Which entries there are depends on the connectivity alone: for an operator that is a sum over faces, those of all
/// pairs of vertices that share a face, be they 0; for one of edges, those of neighbours. Except in faces of more than
/// 32 corners that the operator cuts into triangles: there the sides of these have entries, the diagonals as they fall.
struct OperatorMatrices {
    SparseMatrix stiffness;
    SparseMatrix mass;
    /// What solvers may rely on; follows from the claims.
    Structure structure = Structure::positive_semidefinite;

    OperatorMatrices() = default;
    OperatorMatrices(SparseMatrix s, SparseMatrix m, Structure of = Structure::positive_semidefinite) : structure(of) {
        stiffness.swap(s);
        mass.swap(m);
    }
    ~OperatorMatrices() = default;
    OperatorMatrices(const OperatorMatrices&) = default;
    OperatorMatrices& operator=(const OperatorMatrices&) = default;
    // Eigen 3.4's sparse matrices copy where they are told to move.
    // NOLINTNEXTLINE(performance-noexcept-move-constructor): an empty matrix allocates
    OperatorMatrices(OperatorMatrices&& other) : structure(other.structure) {
        stiffness.swap(other.stiffness);
        mass.swap(other.mass);
    }
    OperatorMatrices& operator=(OperatorMatrices&& other) noexcept {
        structure = other.structure;
        stiffness.swap(other.stiffness);
        mass.swap(other.mass);
        return *this;
    }
};

/// One line of the operator table.
struct OperatorInfo {
    const char* id;  ///< Kebab case.
    const char* label;
    const char* formula_latex;  ///< For people, of the face or of the weight.
    const char* citation;
    const char* bibtex;   ///< One entry; those that cite the same work have the same.
    const char* summary;  ///< One sentence.
    std::span<const Parameter> parameters;
    bool takes_vertex_weights = false;
    bool sum_over_faces = false;  ///< S is the sum of what it is on each face alone.
    /// The rule by which it cuts faces into triangles; null where it cuts none.
    /// @param spec complete
    TriangulationRule (*rule)(const OperatorSpec& spec) = nullptr;
    PropertyClaims claims;
    /// @param spec complete: one value per parameter, in range; vertex_weights empty or V finite values
    /// @param out  overwritten but for its structure; memory that is there is used again. Undefined after an error
    Status (*build)(const PolygonMesh& mesh, const OperatorSpec& spec, OperatorMatrices& out, Monitor monitor);
};

/// The operator table, in the order of the menus. Explicit, because self-registration vanishes from a static library.
std::span<const OperatorInfo* const> operators() noexcept;

/// Which two of the table a comparison opens with.
std::array<const OperatorInfo*, 2> opening_pair() noexcept;

/// @error unknown_operator (the message lists the known ones)
Result<const OperatorInfo*> find_operator(std::string_view id);

/// A spec from names and texts, e.g. "alexa-wardetzky", {{"lambda", "0.5"}}; choices by their name.
/// @error unknown_operator, bad_argument (no such parameter, not a number, no such choice), parameter_out_of_range
Result<OperatorSpec> make_spec(std::string_view id, Settings settings);

/// Fills missing values with the table's and checks the ranges.
/// @error unknown_operator, bad_argument (too many values; vertex weights for an operator that takes none, or one that
/// is not finite: element = vertex), parameter_out_of_range
Result<OperatorSpec> complete_spec(OperatorSpec spec);

/// Builds stiffness and mass of an operator on a mesh.
/// @error unknown_operator, bad_argument (another number of vertex weights), parameter_out_of_range, degenerate_face
/// (element = face), out_of_memory, cancelled
Result<OperatorMatrices> build_operator(const PolygonMesh& mesh, const OperatorSpec& spec, Monitor monitor = {});

/// The same into matrices that are there, of any operator on any mesh; those of the same connectivity lend their
/// memory. After an error they are not to be used.
Status rebuild_operator(const PolygonMesh& mesh, const OperatorSpec& spec, OperatorMatrices& matrices,
                        Monitor monitor = {});

}  // namespace polylap

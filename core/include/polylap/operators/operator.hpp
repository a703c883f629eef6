#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "polylap/base/monitor.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// One parameter of an operator. A choice has the values 0, 1, … in the order of `choices`.
struct Parameter {
    enum class Kind : std::uint8_t { real, choice };
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

/// Where a property holds: everywhere, on meshes whose faces are planar, on triangle meshes, or nowhere in general.
enum class Claim : std::uint8_t { yes, planar, triangles, no };
std::string_view claim_name(Claim claim) noexcept;

/// The properties of Wardetzky et al. 2007, "Discrete Laplace operators: no free lunch", as an operator claims them.
struct PropertyClaims {
    Claim symmetric;
    Claim positive_semidefinite;
    Claim constants_in_kernel;  ///< S 1 = 0
    Claim linear_precision;     ///< (S x)ᵢ = 0 at inner vertices whose surroundings lie in one plane.
    Claim positive_weights;     ///< w_ij = -S_ij ≥ 0
};

/// Diagonal masses: each face gives each of its n corners |a| / n.
enum class Mass : std::uint8_t { lumped };

/// Which operator, with which parameters.
struct OperatorSpec {
    std::string id;
    std::vector<double> values;  ///< One per parameter of the table; missing ones take their initial value.
    Mass mass = Mass::lumped;

    friend bool operator==(const OperatorSpec&, const OperatorSpec&) = default;
};

/// S: V×V, (S u)ᵢ = Σ w_ij (uᵢ - uⱼ), unitless. M: V×V, length². Both stored in full.
struct OperatorMatrices {
    SparseMatrix stiffness;
    SparseMatrix mass;
};

/// One line of the operator table.
struct OperatorInfo {
    const char* id;  ///< Kebab case.
    const char* label;
    const char* formula_latex;  ///< For people, of the face or of the weight.
    const char* citation;
    const char* summary;  ///< One sentence.
    std::span<const Parameter> parameters;
    PropertyClaims claims;
    /// @param values one per parameter, in range
    Result<OperatorMatrices> (*build)(const PolygonMesh& mesh, std::span<const double> values, Mass mass,
                                      Monitor monitor);
};

/// The operator table, in the order of the menus. Explicit, because self-registration vanishes from a static library.
std::span<const OperatorInfo* const> operators() noexcept;

/// @error unknown_operator (the message lists the known ones)
Result<const OperatorInfo*> find_operator(std::string_view id);

/// A spec from names and texts, e.g. "alexa-wardetzky", {{"lambda", "0.5"}}; choices by their name.
/// @error unknown_operator, bad_argument (no such parameter, not a number, no such choice), parameter_out_of_range
Result<OperatorSpec> make_spec(std::string_view id, std::span<const std::pair<std::string, std::string>> settings);

/// Fills missing values with the table's and checks the ranges.
/// @error unknown_operator, bad_argument (too many values), parameter_out_of_range
Result<OperatorSpec> complete_spec(OperatorSpec spec);

/// Builds stiffness and mass of an operator on a mesh.
/// @error unknown_operator, parameter_out_of_range, degenerate_face (element = face), out_of_memory, cancelled
Result<OperatorMatrices> build_operator(const PolygonMesh& mesh, const OperatorSpec& spec, Monitor monitor = {});

}  // namespace polylap

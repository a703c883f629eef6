#pragma once

#include <array>
#include <span>

#include "polylap/face/triangulate_mesh.hpp"
#include "polylap/operators/mass.hpp"

namespace polylap {

/// What the operators on triangulated faces share: parameters `rule` and `mass`, in this order.
inline constexpr std::array triangulated_parameters{
    choice_parameter("rule", "rule", triangulation_rule_names, "how faces are cut into triangles"),
    choice_parameter("mass", "mass", mass_rule_names, "how much area each vertex gets")};

inline TriangulationRule triangulated_rule(const OperatorSpec& spec) {
    return static_cast<TriangulationRule>(static_cast<int>(spec.values[0]));
}

/// Cotan stiffness of the triangles that the faces are cut into (diagonals found in projection, cotangents in space),
/// with weights of the vertices, and the mass: S += ½ cot γ_k + ((1-s) ω_i + s ω_j - ω_k) / 4A for the edge ij opposite
/// of corner k, x_i + s(x_j - x_i) being the foot of its height. That is Glickenstein's weight [Herholz 2012, eq. 3.24]
/// in a form whose symmetry rounding keeps.
/// @param weights ω, V values or none
/// @error bad_argument, degenerate_face (element = face), out_of_memory, cancelled
Status triangulated_operator(const PolygonMesh& mesh, std::span<const double> weights, TriangulationRule rule,
                             MassRule mass, OperatorMatrices& out, Monitor monitor);

}  // namespace polylap

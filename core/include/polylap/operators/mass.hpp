#pragma once

#include <array>

#include "polylap/operators/operator.hpp"

namespace polylap {

/// The lumped mass of a mesh: diagonal, M_ii = Σ |a_f| / n_f over the faces at i (Alexa & Wardetzky 2011), length².
/// Zero at unreferenced vertices.
/// @error out_of_memory
Result<SparseMatrix> lumped_mass(const PolygonMesh& mesh);

/// The mass of a triangulated surface.
enum class MassRule : std::uint8_t {
    lumped,       ///< M_ii = Σ |a_f| / n_f over the uncut faces: lumped_mass.
    barycentric,  ///< M_ii = ⅓ Σ A over the triangles at i.
    ring,  ///< M_ii = 2 Σ A, so that M⁻¹S has the weights (cot γ_ij + cot γ_ji) / (4 Σ A) of Desbrun, Meyer,
           ///< Schröder & Barr 1999 [Herholz 2012, eq. 3.12]. Six times the barycentric mass.
    circumcentric,  ///< Signed circumcentric cells of discrete exterior calculus [Herholz 2012, eq. 3.13]: M_ii = ⅛ Σ
                    ///< (|e_ij|² cot γ_ij + |e_ik|² cot γ_ik). Zero or negative ones stay as they are.
    mixed_voronoi,  ///< Meyer, Desbrun, Schröder & Barr 2003: circumcentric in triangles that are not obtuse; ½ A to
                    ///< the obtuse corner and ¼ A to the others elsewhere. Positive.
    galerkin,       ///< ∫ φ_i φ_j of the linear hat functions: A/6 on the diagonal, A/12 beside it. Not diagonal.
};

/// The names of the masses, in the order of MassRule.
inline constexpr std::array mass_rule_names{"lumped",        "barycentric",   "ring",
                                            "circumcentric", "mixed-voronoi", "galerkin"};

/// @param mesh      the polygons, for `lumped`
/// @param triangles their triangulation, same vertices; all faces have three corners
/// @return M V×V symmetric, length²; rows of unreferenced vertices are 0
/// @error bad_argument (a face that is no triangle), out_of_memory
Result<SparseMatrix> surface_mass(const PolygonMesh& mesh, const PolygonMesh& triangles, MassRule rule);

}  // namespace polylap

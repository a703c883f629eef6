#pragma once

#include "polylap/face/vector_area.hpp"
#include "polylap/operators/operator.hpp"

namespace polylap {

extern const OperatorInfo alexa_wardetzky_weighted_info;

struct AlexaWardetzkyWeightedOptions {
    double lambda = 1;  ///< ≥ 0, dimensionless: the stabiliser of the unweighted operator.
};

/// Stiffness of Alexa & Wardetzky with weighted vertices [Herholz 2012, Lemma 4]: S_f = δᵀ( B (Bʷ)ᵀ/|a| + λ CCᵀ )δ,
/// bʷᵢ = xᵢ + d eᵢ/|eᵢ|, d = (|eᵢ|² + ωᵢ - ωᵢ₊₁) / (2|eᵢ|) [eq. 3.25, 4.31]. The weights only move the points on the
/// edges; the λ term is that of the unweighted operator, symmetric and blind to linear functions.
/// ω = 0 is the unweighted operator; on triangles it is Glickenstein's weighted cotan operator, whatever λ.
/// On other faces it is neither symmetric nor linearly precise in general: only Sᵀ is precise there.
/// @param mesh    faces may be non-planar or concave, not of zero vector area
/// @param weights ω, V finite values, length²; empty: all 0
/// @return S V×V, unitless
/// @error bad_argument (another number of weights, or one not finite: element = vertex), degenerate_face (element =
/// face; also for an edge of no length between different weights), parameter_out_of_range, out_of_memory, cancelled.
/// Cost O(Σ n_f²)
Result<SparseMatrix> alexa_wardetzky_weighted_stiffness(const PolygonMesh& mesh, std::span<const double> weights,
                                                        AlexaWardetzkyWeightedOptions options = {},
                                                        Monitor monitor = {});

/// The matrix of one face for free points on its edges: S_f with bʷᵢ = xᵢ + dᵢ eᵢ/|eᵢ|.
/// @param corners   n ≥ 3, not of zero vector area
/// @param distances n: dᵢ, length, from corner i along the edge to corner i + 1
/// @return n×n
/// @error bad_argument (fewer than three corners, another number of distances, a number not finite), degenerate_face
/// (no vector area, an edge without length), parameter_out_of_range, out_of_memory
Result<Matrix> alexa_wardetzky_weighted_face(Corners corners, std::span<const double> distances,
                                             AlexaWardetzkyWeightedOptions options = {});

}  // namespace polylap

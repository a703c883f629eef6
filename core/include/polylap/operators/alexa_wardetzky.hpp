#pragma once

#include "polylap/operators/operator.hpp"

namespace polylap {

extern const OperatorInfo alexa_wardetzky_info;

struct AlexaWardetzkyOptions {
    double lambda = 1;  ///< ≥ 0, dimensionless; larger = stiffer in the modes that the face gradient cannot see; 0
                        ///< leaves those in the kernel.
};

/// Stiffness of Alexa & Wardetzky, "Discrete Laplacians on general polygonal meshes" 2011 [Herholz 2012, eq. 4.29]:
/// S_f = δᵀ(BBᵀ/|a| + λ CCᵀ)δ, C an orthonormal basis of ker Ēᵀ; in closed form, CCᵀ = I - QQᵀ.
/// @param mesh faces may be non-planar or concave, not of zero vector area
/// @return S V×V symmetric PSD, unitless
/// @error degenerate_face (element = face), parameter_out_of_range, out_of_memory, cancelled.   Cost O(Σ n_f²)
Result<SparseMatrix> alexa_wardetzky_stiffness(const PolygonMesh& mesh, AlexaWardetzkyOptions options = {},
                                               Monitor monitor = {});

}  // namespace polylap

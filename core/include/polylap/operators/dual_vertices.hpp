#pragma once

#include <vector>

#include "polylap/base/monitor.hpp"
#include "polylap/mesh/topology.hpp"

namespace polylap {

struct DualOptions {
    /// 0: exact orthogonality, nearest to the barycentres. > 0: the compromise min Σ|v - b|² + μ Σ⟨v_k - v_l, e/|e|⟩²,
    /// dimensionless.
    double mu = 0;
};

/// An edge of the mesh and what the dual makes of it.
struct DualEdge {
    Index v0 = 0, v1 = 0;             ///< v0 < v1, in the order of Topology::edges.
    Index face0 = -1, face1 = -1;     ///< face0 runs v0 → v1, face1 back; -1: none.
    Vector3 point = Vector3::Zero();  ///< Where the dual edge crosses: v0 + s (v1 - v0); the mean of both faces' s.
    double length0 = 0;  ///< Signed distance of each face's dual vertex from the edge, length; + on its side.
    double length1 = 0;
    double weight = 0;  ///< (length0 + length1) / |e|
};

/// Dual vertices v_k whose edges are orthogonal to those of the mesh [Herholz 2012, section 4.1].
struct OrthogonalDual {
    Points vertices;              ///< F×3: v_k
    std::vector<DualEdge> edges;  ///< As Topology::edges.
    Index constraints = 0;        ///< Inner edges.
    Index rank = 0;               ///< Of the constraint matrix, numerically.
    Index null_space = 0;         ///< 3F - rank
    double residual = 0;          ///< Largest |⟨v_k - v_l, e⟩| over the largest |e|².
    Index worst_edge = -1;        ///< Where.
    double largest_shift = 0;     ///< Largest |v_k - b_k| / √|a_k|, b the means of the corners.
    Index worst_face = -1;        ///< Where.
    bool usable = false;          ///< largest_shift ≤ usable_shift: the dual looks like one of this mesh.
};

/// Beyond this many √area a dual vertex lies faces away from its own.
inline constexpr double usable_shift = 1;

/// @error non_manifold_edge (element = edge; more than two faces, or two of opposite orientation), degenerate_face
/// (element = face), not_converged (the residual stays above 1e-8), out_of_memory, cancelled
Result<OrthogonalDual> orthogonal_dual(const PolygonMesh& mesh, DualOptions options = {}, Monitor monitor = {});

}  // namespace polylap

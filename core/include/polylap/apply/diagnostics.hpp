#pragma once

#include <span>
#include <vector>

#include "polylap/mesh/topology.hpp"
#include "polylap/operators/operator.hpp"

namespace polylap {

/// |S_ij| at most this multiple of the largest diagonal entry has no sign: rounding of an exact zero.
inline constexpr double weight_tolerance = 1e-10;

/// A weight w_ij = -S_ij between two vertices.
struct Weight {
    Index i = 0;
    Index j = 0;
    double value = 0;
};

/// The negative weights of a stiffness matrix.
struct WeightSummary {
    Index negative_ordered = 0;  ///< Negative w_ij over ordered pairs (i, j), as Herholz 2012 counts.
    Index nonzero_ordered = 0;   ///< All off-diagonal w_ij beyond the tolerance, ordered pairs.
    double smallest = 0;         ///< Least w_ij; 0 for a diagonal matrix.
    double largest = 0;          ///< Greatest w_ij.
    std::vector<Weight>
        negative;  ///< Each unordered pair once, i < j, sorted; of a non-symmetric pair the smaller value.
};
WeightSummary summarise_weights(const SparseMatrix& stiffness);

/// RMS distance of a face's corners from their plane over √|a|: 0 = planar, also for a face without vector area.
double non_planarity(std::span<const Vector3> corners);

/// Size and shape of a surface.
struct ShapeMeasures {
    double area = 0;                ///< Σ |a_f|, length².
    double mean_non_planarity = 0;  ///< Over faces, see non_planarity.
    double mean_squared_edge = 0;   ///< h²: mean squared length over edges, length².
};
ShapeMeasures measure_shape(const PolygonMesh& mesh, const Topology& topology);

/// Volume enclosed by a closed surface, length³: ⅓ Σ a_f · c_f, each face closed by a fan around the mean c_f of its
/// corners.
/// @error open_mesh, non_manifold_edge (element = edge; the message names its vertices)
Result<double> enclosed_volume(const PolygonMesh& mesh, const Topology& topology);

}  // namespace polylap

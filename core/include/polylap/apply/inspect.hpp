#pragma once

#include <optional>
#include <vector>

#include "polylap/face/triangulate.hpp"
#include "polylap/operators/operator.hpp"

namespace polylap {

/// The row of a vertex in S, and its mass.
struct MatrixRow {
    std::vector<Index> columns;  ///< Ascending; the vertex itself is always among them.
    std::vector<double> values;  ///< S_ij; none off the diagonal is 0.
    double mass = 0;             ///< M_ii, length².
};
/// @param vertex in [0, V)
/// Cost O(k log k) for k entries: S has an entry at (i, j) wherever it has one at (j, i).
MatrixRow row_of(const OperatorMatrices& matrices, Index vertex);

/// Faces of more corners are told without a matrix.
inline constexpr Index most_inspected_corners = 256;

/// One face, as an operator sees it.
struct FaceReport {
    std::vector<Index> corners;              ///< n vertices.
    Vector3 vector_area = Vector3::Zero();   ///< length²
    Vector3 normal = Vector3::Zero();        ///< Unit vector area; 0 where that is zero.
    double non_planarity = 0;                ///< RMS distance of the corners from their plane over √|a|.
    std::vector<Eigen::Vector2d> projected;  ///< n corners along the vector area, from the first; none where it is 0.
    std::vector<Triangle> triangles;         ///< Into which the operator cuts the face; none where it cuts no faces.
    std::optional<Matrix> stiffness;         ///< n×n, what the face adds to S.
    std::string no_stiffness;                ///< Why there is none.
};

/// @error bad_argument (no such face, another number of vertex weights), unknown_operator, parameter_out_of_range,
/// out_of_memory
Result<FaceReport> inspect_face(const PolygonMesh& mesh, const OperatorSpec& spec, Index face);

}  // namespace polylap

#pragma once

#include <cstdint>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace polylap {

/// Vertices, faces, edges and corners count from 0.
using Index = std::int32_t;

using Vector3 = Eigen::Vector3d;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

/// V×3, one position a row.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

}  // namespace polylap

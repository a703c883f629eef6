#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "polylap/mesh/polygon_mesh.hpp"

/// The definitions, written as plainly and slowly as they read: what the library is compared with.
namespace polylap::test::naive {

using Polygon = std::vector<Eigen::Vector2d>;
using Triangle = std::array<Index, 3>;
using Triangulation = std::vector<Triangle>;

inline const Eigen::Vector2d& at(std::span<const Eigen::Vector2d> p, Index i) {
    return p[static_cast<std::size_t>(i)];
}

/// Twice the signed area of a triangle.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

inline double area(std::span<const Eigen::Vector2d> p) {
    double twice = 0;
    for (std::size_t k = 1; k + 1 < p.size(); ++k) {
        twice += cross(p[0], p[k], p[k + 1]);
    }
    return twice / 2;
}

/// Segments that cross in their interiors.
inline bool cross_properly(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                           const Eigen::Vector2d& d) {
    return cross(a, b, c) * cross(a, b, d) < 0 && cross(c, d, a) * cross(c, d, b) < 0;
}

/// Is the diagonal i–j strictly inside a simple polygon in general position?
inline bool is_inside_diagonal(std::span<const Eigen::Vector2d> p, Index i, Index j) {
    const auto n = static_cast<Index>(p.size());
    if (i == j || (i + 1) % n == j || (j + 1) % n == i) return false;
    const Eigen::Vector2d middle = (at(p, i) + at(p, j)) / 2;
    bool inside = false;
    for (Index k = 0; k < n; ++k) {
        const auto& a = at(p, k);
        const auto& b = at(p, (k + 1) % n);
        if (cross_properly(at(p, i), at(p, j), a, b)) return false;
        if ((a.y() > middle.y()) != (b.y() > middle.y()) &&
            middle.x() < (b.x() - a.x()) * (middle.y() - a.y()) / (b.y() - a.y()) + a.x()) {
            inside = !inside;
        }
    }
    return inside;
}

/// All triangulations of a simple polygon in general position.
inline std::vector<Triangulation> triangulations(std::span<const Eigen::Vector2d> p, Index i, Index j) {
    if (j == i + 1) return {{}};
    std::vector<Triangulation> all;
    if (!(i == 0 && j + 1 == static_cast<Index>(p.size())) && !is_inside_diagonal(p, i, j)) return all;
    for (Index m = i + 1; m < j; ++m) {
        if (cross(at(p, i), at(p, m), at(p, j)) <= 0) continue;
        const auto right = triangulations(p, m, j);
        for (const auto& l : triangulations(p, i, m)) {
            for (const auto& r : right) {
                Triangulation t = l;
                t.insert(t.end(), r.begin(), r.end());
                t.push_back({i, m, j});
                all.push_back(t);
            }
        }
    }
    return all;
}
inline std::vector<Triangulation> triangulations(std::span<const Eigen::Vector2d> p) {
    return triangulations(p, 0, static_cast<Index>(p.size()) - 1);
}

/// Σ over triangles of the cotan matrix of Pinkall & Polthier: the edge opposite of angle γ gets ½ cot γ.
inline Matrix cotan(std::span<const Vector3> p, std::span<const Triangle> triangles) {
    Matrix s = Matrix::Zero(static_cast<Eigen::Index>(p.size()), static_cast<Eigen::Index>(p.size()));
    for (const Triangle& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = t[k];
            const Index b = t[(k + 1) % 3];
            const Index c = t[(k + 2) % 3];
            const Vector3 u = p[static_cast<std::size_t>(b)] - p[static_cast<std::size_t>(a)];
            const Vector3 v = p[static_cast<std::size_t>(c)] - p[static_cast<std::size_t>(a)];
            const double w = u.dot(v) / u.cross(v).norm() / 2;
            s(b, b) += w;
            s(c, c) += w;
            s(b, c) -= w;
            s(c, b) -= w;
        }
    }
    return s;
}
inline Matrix cotan(std::span<const Eigen::Vector2d> p, std::span<const Triangle> triangles) {
    std::vector<Vector3> lifted;
    for (const auto& q : p) {
        lifted.emplace_back(q.x(), q.y(), 0);
    }
    return cotan(std::span<const Vector3>(lifted), triangles);
}
inline Matrix cotan(const PolygonMesh& triangle_mesh) {
    std::vector<Vector3> points;
    Triangulation triangles;
    for (Index v = 0; v < triangle_mesh.vertex_count(); ++v) {
        points.push_back(triangle_mesh.position(v));
    }
    for (Index f = 0; f < triangle_mesh.face_count(); ++f) {
        const auto face = triangle_mesh.face(f);
        triangles.push_back({face[0], face[1], face[2]});
    }
    return cotan(std::span<const Vector3>(points), triangles);
}

/// All angles of a triangulation, the largest first.
inline std::vector<double> sorted_angles(std::span<const Eigen::Vector2d> p, std::span<const Triangle> triangles) {
    std::vector<double> angles;
    for (const Triangle& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& a = at(p, t[k]);
            const auto& b = at(p, t[(k + 1) % 3]);
            const auto& c = at(p, t[(k + 2) % 3]);
            angles.push_back(std::atan2(cross(a, b, c), (b - a).dot(c - a)));
        }
    }
    std::sort(angles.rbegin(), angles.rend());
    return angles;
}

inline bool angles_less(const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (std::abs(a[k] - b[k]) > 1e-9) return a[k] < b[k];
    }
    return false;
}

/// The stiffness of one face after Alexa & Wardetzky, C from a singular value decomposition as in the thesis' listing
/// A.1.
inline Matrix alexa_wardetzky(const std::vector<Vector3>& p, double lambda) {
    const auto n = static_cast<Eigen::Index>(p.size());
    Matrix x(n, 3);
    Matrix d = Matrix::Zero(n, n);
    Matrix mean = Matrix::Zero(n, n);
    Vector3 a = Vector3::Zero();
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Index next = (i + 1) % n;
        x.row(i) = (p[static_cast<std::size_t>(i)] - p[0]).transpose();
        d(i, i) = -1;
        d(i, next) = 1;
        mean(i, i) = mean(i, next) = 0.5;
        a += (p[static_cast<std::size_t>(i)] - p[0]).cross(p[static_cast<std::size_t>(next)] - p[0]) / 2;
    }
    const Vector3 u = a.normalized();
    const Matrix e = d * x;
    const Matrix b = mean * x;
    const Eigen::JacobiSVD<Matrix> svd(e - (e * u) * u.transpose(), Eigen::ComputeFullU);
    const Matrix c = svd.matrixU().rightCols(n - 2);
    return d.transpose() * (b * b.transpose() / a.norm() + lambda * c * c.transpose()) * d;
}

}  // namespace polylap::test::naive

#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "face/quad_cut.hpp"
#include "operators/assemble_faces.hpp"
#include "operators/corner_masses.hpp"
#include "polylap/face/triangulate.hpp"

namespace polylap {

/// A triangle of a face.
struct FaceTriangle {
    std::span<const Index> vertices;          ///< Of the face.
    Corners x;                                ///< In space.
    std::span<const Eigen::Vector2d> points;  ///< In the plane that the face was projected to.
    Triangle corners;                         ///< Of the triangle, in these.
};

/// The Laplacian of a triangle: the side opposite of corner k has weight w_k.
inline Eigen::Matrix3d triangle_laplacian(const Vector3& w) {
    Eigen::Matrix3d s;
    s << w[1] + w[2], -w[2], -w[1],  //
        -w[2], w[2] + w[0], -w[0],   //
        -w[1], -w[0], w[0] + w[1];
    return s;
}

/// The kernel of assemble_triangles, and its parts for faces that are too large for one.
template <class Local>
class TriangleSum {
public:
    TriangleSum(TriangulationRule rule, MassRule mass, Local local)
        : rule_(rule), mass_(mass), local_(std::move(local)) {}

    template <std::size_t n>
    Status operator()(const Face<n>& face, LocalMatrix<n>& s, std::span<double, n> masses) {
        PerCorner<Eigen::Vector2d, n> points(points_);
        points.resize(face.x.size());
        project_along(face.x, face.vector_area / face.area, *points);
        if (mass_ != MassRule::lumped) std::fill(masses.begin(), masses.end(), 0.0);
        if constexpr (n == 4) {  // without the detour over vectors
            const QuadCut cut = rule_ == TriangulationRule::delaunay ? cut_convex_quad(*points) : QuadCut::unclear;
            if (cut == QuadCut::at_02) {
                add(face, *points, cut_at_02, s, masses);
                return Done{};
            }
            if (cut == QuadCut::at_13) {
                add(face, *points, cut_at_13, s, masses);
                return Done{};
            }
        }
        if (Status status = triangulate_polygon(*points, rule_, triangles_); !status) return status;
        add(face, *points, triangles_, s, masses);
        return Done{};
    }

private:
    template <std::size_t n, class Points, class Triangles>
    inline void add(const Face<n>& face, const Points& points, const Triangles& triangles, LocalMatrix<n>& s,
                    std::span<double> masses) {
        for (const Triangle& t : triangles) {
            const FaceTriangle triangle{face.vertices, face.x, points, t};
            const Eigen::Matrix3d local = local_(triangle);
            for (Eigen::Index j = 0; j < 3; ++j) {
                for (Eigen::Index i = 0; i < 3; ++i) {
                    s(t[static_cast<std::size_t>(i)], t[static_cast<std::size_t>(j)]) += local(i, j);
                }
            }
            add_masses(triangle, masses);
        }
    }

    void add_masses(const FaceTriangle& triangle, std::span<double> masses) const {
        if (mass_ == MassRule::lumped) return;
        const Vector3 shares = corner_masses(triangle.x, triangle.corners, mass_);
        for (int k = 0; k < 3; ++k) {
            masses[static_cast<std::size_t>(triangle.corners[static_cast<std::size_t>(k)])] += shares[k];
        }
    }

    TriangulationRule rule_;
    MassRule mass_;
    Local local_;
    std::vector<Eigen::Vector2d> points_;
    std::vector<Triangle> triangles_;
};

/// Sums what each of the triangles that the faces are cut into (on their maximal projection) adds, and the mass.
/// @param local  Eigen::Matrix3d local(const FaceTriangle&)
/// @error as assemble_faces, and those of triangulate_polygon with the face
template <class Local>
Status assemble_triangles(const PolygonMesh& mesh, TriangulationRule rule, MassRule mass, Local local,
                          OperatorMatrices& out, Monitor monitor) {
    return assemble_faces(mesh, TriangleSum(rule, mass, std::move(local)), out, monitor);
}

}  // namespace polylap

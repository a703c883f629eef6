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
        if constexpr (n == 3) {  // here and below without the detour over vectors
            if (clearly_convex<3>(*points)) {
                s = add({face.vertices, face.x, *points, {0, 1, 2}}, masses);
                return Done{};
            }
        }
        if constexpr (n == 4) {
            if (rule_ == TriangulationRule::delaunay && clearly_convex<4>(*points)) {
                if (cut_convex_quad(*points) == QuadCut::at_02)
                    add_quad<0>(face, *points, s, masses);
                else
                    add_quad<1>(face, *points, s, masses);
                return Done{};
            }
        }
        if (Status status = triangulate_polygon(*points, rule_, triangles_); !status) return status;
        add(face, *points, triangles_, s, masses);
        return Done{};
    }

    /// For FaceSum::add_in_parts.
    void begin(const Face<std::dynamic_extent>& face, std::span<double> masses) {
        points_.resize(face.x.size());
        project_along(face.x, face.vector_area / face.area, points_);
        if (mass_ != MassRule::lumped) std::fill(masses.begin(), masses.end(), 0.0);
    }
    Eigen::Matrix3d part(const Face<std::dynamic_extent>& face, const Triangle& t, std::span<double> masses) const {
        return add({face.vertices, face.x, points_, t}, masses);
    }

private:
    template <std::size_t n, class Points, class Triangles>
    inline void add(const Face<n>& face, const Points& points, const Triangles& triangles, LocalMatrix<n>& s,
                    std::span<double> masses) const {
        for (const Triangle& t : triangles) {
            const Eigen::Matrix3d local = add({face.vertices, face.x, points, t}, masses);
            for (Eigen::Index j = 0; j < 3; ++j) {
                for (Eigen::Index i = 0; i < 3; ++i) {
                    s(t[static_cast<std::size_t>(i)], t[static_cast<std::size_t>(j)]) += local(i, j);
                }
            }
        }
    }

    /// Cut from corner k to k + 2.
    template <Index k>
    inline void add_quad(const Face<4>& face, std::span<const Eigen::Vector2d, 4> points, LocalMatrix<4>& s,
                         std::span<double> masses) const {
        constexpr Index k1 = k + 1;
        constexpr Index k2 = k + 2;
        constexpr Index k3 = (k + 3) % 4;
        const Eigen::Matrix3d a = add({face.vertices, face.x, points, {k, k1, k2}}, masses);
        const Eigen::Matrix3d b = add({face.vertices, face.x, points, {k, k2, k3}}, masses);
        s(k, k) = a(0, 0) + b(0, 0);
        s(k1, k1) = a(1, 1);
        s(k2, k2) = a(2, 2) + b(1, 1);
        s(k3, k3) = b(2, 2);
        s(k, k1) = a(0, 1);
        s(k1, k) = a(1, 0);
        s(k1, k2) = a(1, 2);
        s(k2, k1) = a(2, 1);
        s(k2, k3) = b(1, 2);
        s(k3, k2) = b(2, 1);
        s(k3, k) = b(2, 0);
        s(k, k3) = b(0, 2);
        s(k, k2) = a(0, 2) + b(0, 1);
        s(k2, k) = a(2, 0) + b(1, 0);
    }

    /// Adds the masses of a triangle, and returns its matrix.
    inline Eigen::Matrix3d add(const FaceTriangle& triangle, std::span<double> masses) const {
        if (mass_ != MassRule::lumped) {
            const Vector3 shares = corner_masses(triangle.x, triangle.corners, mass_);
            for (std::size_t k = 0; k < 3; ++k) {
                masses[static_cast<std::size_t>(triangle.corners[k])] += shares[static_cast<Eigen::Index>(k)];
            }
        }
        return local_(triangle);
    }

    TriangulationRule rule_;
    MassRule mass_;
    Local local_;
    std::vector<Eigen::Vector2d> points_;
    std::vector<Triangle> triangles_;
};

/// A mesh whose faces of more than largest_whole_face corners are cut into triangles.
struct CutFaces {
    std::vector<Index> offsets, corners;  ///< As in Connectivity.
    std::vector<Triangle> triangles;      ///< Of the faces that are cut, in the numbers of their corners.
};

/// Beyond, a block of all pairs of corners costs more than the same pattern on moved positions saves.
inline constexpr std::size_t largest_whole_face = 32;

/// @error degenerate_face (element = face), out_of_memory, cancelled
Result<CutFaces> cut_large_faces(const PolygonMesh& mesh, TriangulationRule rule, Monitor monitor);

/// Sums what each of the triangles that the faces are cut into (on their maximal projection) adds, and the mass. The
/// pattern is that of assemble_faces, but for faces of more than largest_whole_face corners: there only the sides of
/// triangles have entries.
/// @param local  Eigen::Matrix3d local(const FaceTriangle&)
/// @error as assemble_faces, and those of triangulate_polygon with the face
template <class Local>
Status assemble_triangles(const PolygonMesh& mesh, TriangulationRule rule, MassRule mass, Local local,
                          OperatorMatrices& out, Monitor monitor) {
    TriangleSum kernel(rule, mass, std::move(local));
    if (largest_face(*mesh.connectivity()) <= largest_whole_face) return assemble_faces(mesh, kernel, out, monitor);
    return guard_memory([&]() -> Status {
        Stretch cutting{monitor, 0, 0.6};
        Stretch pairing{monitor, 0.6, 0.8};
        Stretch summing{monitor, 0.8, 1};
        const auto cut = cut_large_faces(mesh, rule, cutting.monitor());
        if (!cut) return cut.error();
        const auto pairs = pair_corners(mesh.vertex_count(), cut->offsets, cut->corners, pairing.monitor());
        if (!pairs) return pairs.error();
        set_pattern(**pairs, out.stiffness);
        set_diagonal(mesh.vertex_count(), out.mass);
        FaceSum<TriangleSum<Local>> sum(mesh, **pairs, kernel, out);
        auto triangle = std::span(cut->triangles);
        return for_faces(mesh, summing.monitor(), [&](Index f) {
            const auto face = mesh.face(f);
            if (face.size() <= largest_whole_face) return sum.add(face);
            const auto parts = triangle.first(face.size() - 2);
            triangle = triangle.subspan(parts.size());
            return sum.add_in_parts(face, parts);
        });
    });
}

}  // namespace polylap

// The masses of triangulated surfaces, each from its definition.

#include "polylap/operators/mass.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "operator_cases.hpp"
#include "polylap/face/triangulate_mesh.hpp"
#include "polylap/face/vector_area.hpp"
#include "polylap/operators/cotan.hpp"

namespace polylap::test {
namespace {

using Corner = std::array<Vector3, 3>;

/// The zoo, cut into triangles; only what the rule can cut.
std::vector<Specimen> triangle_zoo() {
    std::vector<Specimen> cut;
    for (const auto& [name, mesh] : zoo()) {
        auto triangles = triangulate_mesh(mesh, TriangulationRule::delaunay);
        if (triangles) cut.push_back({name, *std::move(triangles)});
    }
    return cut;
}

Corner corners_of(const PolygonMesh& mesh, Index f) {
    const auto face = mesh.face(f);
    return {mesh.position(face[0]), mesh.position(face[1]), mesh.position(face[2])};
}

double area_of(const Corner& x) {
    return 0.5 * (x[1] - x[0]).cross(x[2] - x[0]).norm();
}

/// Equally far from all corners: by the linear equations of the perpendicular bisectors, in the plane.
Vector3 circumcentre(const Corner& x) {
    Eigen::Matrix3d a;
    Vector3 b;
    a << (x[1] - x[0]).transpose(), (x[2] - x[0]).transpose(), (x[1] - x[0]).cross(x[2] - x[0]).transpose();
    b << (x[1] - x[0]).squaredNorm() / 2, (x[2] - x[0]).squaredNorm() / 2, 0;
    return x[0] + a.fullPivLu().solve(b);
}

double signed_area(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& normal) {
    return 0.5 * (b - a).cross(c - a).dot(normal);
}

Matrix mass_of(const PolygonMesh& triangles, MassRule rule) {
    return get(surface_mass(triangles, triangles, rule));
}

template <class Local>
Matrix sum_of(const PolygonMesh& triangles, Local&& local) {
    Matrix m = Matrix::Zero(triangles.vertex_count(), triangles.vertex_count());
    for (Index f = 0; f < triangles.face_count(); ++f) {
        const Eigen::Matrix3d part = local(corners_of(triangles, f));
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                m(triangles.face(f)[static_cast<std::size_t>(i)], triangles.face(f)[static_cast<std::size_t>(j)]) +=
                    part(i, j);
            }
        }
    }
    return m;
}

/// The cell of each corner inside the triangle: corner, middle of an edge, centre, middle of the other edge.
Eigen::Matrix3d cells_around(const Vector3& centre, const Corner& x) {
    const Vector3 normal = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 3; ++i) {
        const auto& p = x[static_cast<std::size_t>(i)];
        const Vector3 next = (p + x[static_cast<std::size_t>((i + 1) % 3)]) / 2;
        const Vector3 before = (p + x[static_cast<std::size_t>((i + 2) % 3)]) / 2;
        m(i, i) = signed_area(p, next, centre, normal) + signed_area(p, centre, before, normal);
    }
    return m;
}
Eigen::Matrix3d barycentric(const Corner& x) {
    return cells_around((x[0] + x[1] + x[2]) / 3, x);
}
Eigen::Matrix3d circumcentric(const Corner& x) {
    return cells_around(circumcentre(x), x);
}

Eigen::Matrix3d mixed(const Corner& x) {
    for (int i = 0; i < 3; ++i) {
        const auto& p = x[static_cast<std::size_t>(i)];
        const auto& q = x[static_cast<std::size_t>((i + 1) % 3)];
        const auto& r = x[static_cast<std::size_t>((i + 2) % 3)];
        if ((q - p).dot(r - p) >= -1e-9 * (q - r).squaredNorm()) continue;
        Vector3 shares(0.25, 0.25, 0.25);
        shares[i] = 0.5;
        return Vector3(area_of(x) * shares).asDiagonal();
    }
    return circumcentric(x);
}

/// Exact for quadratic functions: the mean over the middles of the edges.
Eigen::Matrix3d galerkin(const Corner& x) {
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 3; ++k) {
        Vector3 hats(0.5, 0.5, 0.5);
        hats[k] = 0;
        m += area_of(x) / 3 * hats * hats.transpose();
    }
    return m;
}

TEST(Mass, EqualsItsDefinition) {
    const auto meshes = triangle_zoo();
    ASSERT_GE(meshes.size(), 40u);
    for (const auto& [name, mesh] : meshes) {
        if (mesh.vertex_count() > 200) continue;
        const std::pair<MassRule, Eigen::Matrix3d (*)(const Corner&)> rules[] = {
            {MassRule::barycentric, barycentric},
            {MassRule::circumcentric, circumcentric},
            {MassRule::mixed_voronoi, mixed},
            {MassRule::galerkin, galerkin},
            {MassRule::ring, [](const Corner& x) -> Eigen::Matrix3d {
                 return Eigen::Matrix3d(2 * area_of(x) * Eigen::Matrix3d::Identity());
             }}};
        for (const auto& [rule, local] : rules) {
            const Matrix expected = sum_of(mesh, local);
            EXPECT_LE((mass_of(mesh, rule) - expected).cwiseAbs().maxCoeff(), 1e-11 * expected.cwiseAbs().maxCoeff())
                << name << ", " << mass_rule_names[static_cast<std::size_t>(rule)];
        }
    }
}

TEST(Mass, SumsToTheArea) {
    for (const auto& [name, mesh] : triangle_zoo()) {
        double area = 0;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            area += area_of(corners_of(mesh, f));
        }
        for (const MassRule rule : {MassRule::lumped, MassRule::barycentric, MassRule::circumcentric,
                                    MassRule::mixed_voronoi, MassRule::galerkin}) {
            EXPECT_NEAR(get(surface_mass(mesh, mesh, rule)).sum(), area, 1e-12 * area) << name;
        }
        EXPECT_NEAR(get(surface_mass(mesh, mesh, MassRule::ring)).sum(), 6 * area, 1e-11 * area) << name;
        const SparseMatrix mixed_mass = get(surface_mass(mesh, mesh, MassRule::mixed_voronoi));
        EXPECT_GE(Vector(mixed_mass.diagonal()).minCoeff(), 0) << name;
    }
}

// Triangle (0,0) (3,0) (1,0.4): the circumcentre lies below the long side. Squared edges 9, 4.16, 1.16; cot γ₀ =
// 3/1.2 = 2.5, cot γ₁ = 6/1.2 = 5, cot γ₂ = -1.84/1.2 (edges (-1,-0.4) and (2,-0.4): dot -1.84, cross 1.2). The edges'
// shares ½ cot γ |e|² are 5.2, 2.9, -6.9 (sum 1.2 = 2 areas), so the cells are ¼ (2.9 - 6.9) = -1, ¼ (5.2 - 6.9) =
// -0.425, ¼ · 8.1 = 2.025.
TEST(Mass, CircumcentricCellsKeepTheirSign) {
    const auto mesh = make_face({{0, 0, 0}, {3, 0, 0}, {1, 0.4, 0}});
    const Vector cells = mass_of(mesh, MassRule::circumcentric).diagonal();
    EXPECT_NEAR(cells[0], -1, 1e-14);
    EXPECT_NEAR(cells[1], -0.425, 1e-14);
    EXPECT_NEAR(cells[2], 2.025, 1e-14);
    const Vector mixed_cells = mass_of(mesh, MassRule::mixed_voronoi).diagonal();
    EXPECT_NEAR((mixed_cells - Vector3(0.15, 0.15, 0.3)).norm(), 0, 1e-15);
}

// Right isosceles: the circumcentre is the middle of the long side, where the rule for obtuse triangles begins.
TEST(Mass, ARightAngleIsNoJump) {
    for (const double bend : {-1e-12, 0.0, 1e-12}) {
        const auto mesh = make_face({{0, 0, 0}, {1, bend, 0}, {bend, 1, 0}});
        EXPECT_LE((mass_of(mesh, MassRule::mixed_voronoi).diagonal() - Vector3(0.25, 0.125, 0.125)).norm(), 1e-11);
    }
}

// Desbrun et al.: M⁻¹S has the weights (cot γ_ij + cot γ_ji) / (4 A_ring).
TEST(Mass, RingGivesDesbrunsWeights) {
    const auto& mesh = specimen("triangle-sphere-2");
    const auto m = get(cotan_matrices(mesh, {.mass = MassRule::ring}));
    Vector ring = Vector::Zero(mesh.vertex_count());
    Matrix cotangents = Matrix::Zero(mesh.vertex_count(), mesh.vertex_count());
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const Corner x = corners_of(mesh, f);
        const auto face = mesh.face(f);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = (k + 1) % 3;
            const auto j = (k + 2) % 3;
            ring[face[k]] += area_of(x);
            cotangents(face[i], face[j]) +=
                1 / std::tan(std::acos((x[i] - x[k]).normalized().dot((x[j] - x[k]).normalized())));
        }
    }
    const Matrix symmetric = cotangents + cotangents.transpose();
    const Matrix normalised = Vector(m.mass.diagonal()).cwiseInverse().asDiagonal() * Matrix(m.stiffness);
    for (Index i = 0; i < mesh.vertex_count(); ++i) {
        for (Index j = 0; j < mesh.vertex_count(); ++j) {
            if (i == j) continue;
            EXPECT_NEAR(-normalised(i, j), symmetric(i, j) / (4 * ring[i]), 1e-11);
        }
    }
}

TEST(Mass, LumpedIsOfTheUncutFaces) {
    for (const auto& [name, mesh] : zoo()) {
        const auto cut = triangulate_mesh(mesh, TriangulationRule::delaunay);
        if (!cut) continue;
        EXPECT_EQ(difference(get(surface_mass(mesh, *cut, MassRule::lumped)), get(lumped_mass(mesh))), 0) << name;
    }
}

TEST(Mass, NeedsTriangles) {
    const auto& mesh = specimen("grid-2x2");
    const auto refused = surface_mass(mesh, mesh, MassRule::barycentric);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::bad_argument);
    EXPECT_EQ(refused.error().element, 0);
}

// Lemma 1: dual over primal lengths, |⋆e|/|e| from circumcentres, are the cotan weights.
TEST(Dec, WeightsFromCircumcentresAreTheCotanWeights) {
    for (const auto& [name, mesh] : triangle_zoo()) {
        if (mesh.vertex_count() > 200) continue;
        const Matrix expected = sum_of(mesh, [](const Corner& x) {
            const Vector3 centre = circumcentre(x);
            const Vector3 normal = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
            Eigen::Matrix3d s = Eigen::Matrix3d::Zero();
            for (int i = 0; i < 3; ++i) {
                const int j = (i + 1) % 3;
                const Vector3 edge = x[static_cast<std::size_t>(j)] - x[static_cast<std::size_t>(i)];
                const Vector3 middle = (x[static_cast<std::size_t>(i)] + x[static_cast<std::size_t>(j)]) / 2;
                // Signed: + where the centre lies on the triangle's side of the edge.
                const double dual = (centre - middle).dot(normal.cross(edge).normalized());
                const double w = dual / edge.norm();
                s(i, i) += w;
                s(j, j) += w;
                s(i, j) -= w;
                s(j, i) -= w;
            }
            return s;
        });
        const SparseMatrix s = get(cotan_matrices(mesh)).stiffness;
        EXPECT_LE((Matrix(s) - expected).cwiseAbs().maxCoeff(), 1e-11 * largest(s)) << name;
    }
}

}  // namespace
}  // namespace polylap::test

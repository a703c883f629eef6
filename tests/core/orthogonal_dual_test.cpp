// The orthogonal dual: figures of an independent computation (tests/data/orthogonal_dual.json), the definition by dense
// singular values, and the properties that follow from it.

#include "polylap/operators/orthogonal_dual.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <nlohmann/json.hpp>

#include "polylap/apply/noise.hpp"
#include "polylap/face/vector_area.hpp"
#include "polylap/mesh/shapes.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using nlohmann::json;

const json& reference() {
    static const json all = [] {
        const auto bytes = read_bytes("orthogonal_dual.json");
        const auto* text = reinterpret_cast<const char*>(bytes.data());
        return json::parse(text, text + bytes.size());
    }();
    return all;
}

Points barycentres(const PolygonMesh& mesh) {
    Points b = Points::Zero(mesh.face_count(), 3);
    for (Index f = 0; f < mesh.face_count(); ++f) {
        for (const Index v : mesh.face(f)) {
            b.row(f) += mesh.positions().row(v) / static_cast<double>(mesh.face(f).size());
        }
    }
    return b;
}

double longest_edge(const PolygonMesh& mesh) {
    double longest = 0;
    for (const Edge& e : build_topology(*mesh.connectivity()).edges) {
        longest = std::max(longest, (mesh.position(e.v1) - mesh.position(e.v0)).norm());
    }
    return longest;
}

bool inner(const DualEdge& e) {
    return e.face0 >= 0 && e.face1 >= 0;
}

/// Rings of quads between two fans of triangles: the radial edges at a pole nearly depend on each other.
PolygonMesh uv_sphere(int around, int down) {
    std::vector<Vector3> points{{0, 0, 1}};
    std::vector<std::vector<Index>> faces;
    for (int j = 1; j < down; ++j) {
        const double t = std::numbers::pi * j / down;
        for (int i = 0; i < around; ++i) {
            const double p = 2 * std::numbers::pi * i / around;
            points.emplace_back(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t));
        }
    }
    points.emplace_back(0, 0, -1);
    const auto at = [around](int j, int i) { return 1 + (j - 1) * around + i % around; };
    for (int i = 0; i < around; ++i) {
        faces.push_back({0, at(1, i), at(1, i + 1)});
        for (int j = 1; j + 1 < down; ++j) {
            faces.push_back({at(j, i), at(j + 1, i), at(j + 1, i + 1), at(j, i + 1)});
        }
        faces.push_back({at(down - 1, i), static_cast<Index>(points.size()) - 1, at(down - 1, i + 1)});
    }
    return make_mesh(points, faces);
}

/// With coordinates of a few digits, as in a file: exact dependences of constraints become near ones.
PolygonMesh rounded(const PolygonMesh& mesh, double unit) {
    const Points p = (mesh.positions() / unit).array().round() * unit;
    return get(mesh.with_positions(p));
}

TEST(OrthogonalDual, HasTheReferenceFigures) {
    ASSERT_EQ(reference().size(), 8u);
    for (const auto& [name, figures] : reference().items()) {
        SCOPED_TRACE(name);
        const PolygonMesh mesh = load_mesh(name);
        const OrthogonalDual dual = get(orthogonal_dual(mesh));
        EXPECT_EQ(dual.constraints, figures["constraints"].get<Index>());
        EXPECT_EQ(3 * mesh.face_count(), figures["unknowns"].get<Index>());
        EXPECT_EQ(dual.rank, figures["rank"].get<Index>());
        EXPECT_EQ(dual.null_space, figures["null_space"].get<Index>());
        EXPECT_LE(dual.residual, 1e-12);
        const double shift = figures["max_shift_over_sqrt_area"];
        EXPECT_NEAR(dual.largest_shift, shift, 1e-9 * (shift + 1e-4));
        EXPECT_EQ(dual.usable, shift <= 1);
        const double distance = figures["squared_distance_to_barycentres"];
        EXPECT_NEAR((dual.vertices - barycentres(mesh)).squaredNorm(), distance, 1e-10 * distance + 1e-24);
        for (Index k = 0; k < 3; ++k) {
            for (Index c = 0; c < 3; ++c) {
                const double expected =
                    figures["first_dual_vertices"][static_cast<std::size_t>(k)][static_cast<std::size_t>(c)];
                EXPECT_NEAR(dual.vertices(k, c), expected, 1e-11);
            }
        }
    }
}

// The projection by singular values, and the compromise by dense normal equations, on every mesh small enough.
TEST(OrthogonalDual, EqualsItsPlainDefinition) {
    int compared = 0;
    for (const auto& [name, mesh] : oriented_zoo()) {
        if (mesh.face_count() > 160) continue;
        SCOPED_TRACE(name);
        ++compared;
        const OrthogonalDual dual = get(orthogonal_dual(mesh));
        Matrix k = Matrix::Zero(dual.constraints, 3 * mesh.face_count());
        Index row = 0;
        for (const DualEdge& e : dual.edges) {
            if (!inner(e)) continue;
            const Vector3 unit = (mesh.position(e.v1) - mesh.position(e.v0)).normalized();
            k.row(row).segment<3>(3 * e.face0) += unit.transpose();
            k.row(row++).segment<3>(3 * e.face1) -= unit.transpose();
        }
        ASSERT_EQ(row, dual.constraints);
        const Points b = barycentres(mesh);
        const Eigen::Map<const Vector> flat(b.data(), b.size());
        const double size = longest_edge(mesh);
        Vector expected = flat;
        Index rank = 0;
        if (row > 0) {
            const Eigen::JacobiSVD<Matrix> svd(k, Eigen::ComputeThinU | Eigen::ComputeThinV);
            for (Eigen::Index m = 0; m < svd.singularValues().size(); ++m) {
                if (svd.singularValues()[m] < 1e-6) continue;
                ++rank;
                expected -= svd.matrixV().col(m) * svd.matrixV().col(m).dot(flat);
            }
        }
        const Eigen::Map<const Vector> found(dual.vertices.data(), dual.vertices.size());
        EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), 1e-9 * size);
        EXPECT_EQ(dual.rank, rank);
        EXPECT_EQ(dual.null_space, 3 * mesh.face_count() - rank);
        for (const double mu : {1e-3, 1.0, 1e3, 1e6}) {
            const OrthogonalDual soft = get(orthogonal_dual(mesh, {.mu = mu}));
            const Matrix normal = Matrix::Identity(k.cols(), k.cols()) + mu * k.transpose() * k;
            const Vector compromise = normal.ldlt().solve(flat);
            const Eigen::Map<const Vector> found_soft(soft.vertices.data(), soft.vertices.size());
            // The normal equations lose μ times the rounding.
            EXPECT_LE((found_soft - compromise).cwiseAbs().maxCoeff(), (1e-11 + 1e-14 * mu) * size) << mu;
            EXPECT_EQ(soft.rank, rank);
        }
    }
    EXPECT_GE(compared, 25);
}

TEST(OrthogonalDual, EdgesAreWhatTheySay) {
    for (const auto& [name, mesh] : oriented_zoo()) {
        SCOPED_TRACE(name);
        const Topology topology = build_topology(*mesh.connectivity());
        const OrthogonalDual dual = get(orthogonal_dual(mesh));
        const double size = longest_edge(mesh);
        ASSERT_EQ(dual.edges.size(), topology.edges.size());
        Index constraints = 0;
        double residual = 0;
        for (std::size_t k = 0; k < dual.edges.size(); ++k) {
            const DualEdge& edge = dual.edges[k];
            EXPECT_EQ(edge.v0, topology.edges[k].v0);
            EXPECT_EQ(edge.v1, topology.edges[k].v1);
            EXPECT_EQ(edge.face0 >= 0, topology.edges[k].forward == 1);
            EXPECT_EQ(edge.face1 >= 0, topology.edges[k].backward == 1);
            const Vector3 e = mesh.position(edge.v1) - mesh.position(edge.v0);
            EXPECT_LE((edge.point - mesh.position(edge.v0)).cross(e).norm(),
                      1e-11 * size * (size + (edge.point - mesh.position(edge.v0)).norm()));
            double lengths = 0;
            const auto expect_length = [&](Index face, double length, double direction) {
                if (face < 0) {
                    EXPECT_EQ(length, 0);
                    return;
                }
                const Vector3 v = dual.vertices.row(face).transpose();
                const Vector3 across = v - edge.point;
                std::vector<Vector3> corners;
                gather_corners(mesh, face, corners);
                const double side = direction * vector_area(corners).cross(e).dot(across);
                EXPECT_NEAR(std::abs(length), across.norm(), 1e-9 * size);
                if (std::abs(length) > 1e-9 * size) {
                    EXPECT_EQ(length > 0, side > 0);
                }
                lengths += length;
            };
            expect_length(edge.face0, edge.length0, 1);
            expect_length(edge.face1, edge.length1, -1);
            EXPECT_NEAR(edge.weight * e.norm(), lengths, 1e-12 * size * (1 + std::abs(lengths)));
            if (!inner(edge)) continue;
            ++constraints;
            residual =
                std::max(residual, std::abs((dual.vertices.row(edge.face0) - dual.vertices.row(edge.face1)).dot(e)) /
                                       size / size);
        }
        EXPECT_EQ(dual.constraints, constraints);
        EXPECT_LE(residual, 1e-10);
        EXPECT_LE(dual.residual, 1e-10);
        if (constraints == 0) {
            EXPECT_EQ(dual.worst_edge, -1);
        } else {
            EXPECT_TRUE(inner(dual.edges[static_cast<std::size_t>(dual.worst_edge)]));
        }
        EXPECT_GE(dual.worst_face, 0);
        EXPECT_LT(dual.worst_face, mesh.face_count());
        EXPECT_EQ(dual.usable, dual.largest_shift <= usable_shift);
    }
}

TEST(OrthogonalDual, OfOneFaceIsItsBarycentre) {
    const auto mesh = make_face({{0, 0, 0}, {3, 0, 0}, {1, 0.4, 0}});
    const OrthogonalDual dual = get(orthogonal_dual(mesh));
    EXPECT_EQ(dual.constraints, 0);
    EXPECT_EQ(dual.rank, 0);
    EXPECT_EQ(dual.null_space, 3);
    EXPECT_EQ(dual.largest_shift, 0);
    EXPECT_TRUE(dual.usable);
    EXPECT_EQ(dual.worst_edge, -1);
    EXPECT_LE((dual.vertices.row(0) - Eigen::RowVector3d(4.0 / 3, 0.4 / 3, 0)).norm(), 1e-15);
    // The distance of the barycentre from a side is a third of the height over it.
    ASSERT_EQ(dual.edges.size(), 3u);
    for (const DualEdge& e : dual.edges) {
        const double length = (mesh.position(e.v1) - mesh.position(e.v0)).norm();
        EXPECT_NEAR(e.length0 + e.length1, 2 * 0.6 / length / 3, 1e-15);
        EXPECT_NEAR(e.weight, 2 * 0.6 / length / length / 3, 1e-15);
    }
}

// Two unit squares side by side, one sheared by s: moving both dual vertices alike along the shared edge is nearest.
TEST(OrthogonalDual, OfTwoFacesMeetsHalfway) {
    for (const double s : {0.0, 0.4, -1.0}) {
        const auto mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {2, s, 0}, {2, 1 + s, 0}, {1, 1, 0}, {0, 1, 0}},
                                    {{0, 1, 4, 5}, {1, 2, 3, 4}});
        const OrthogonalDual dual = get(orthogonal_dual(mesh));
        EXPECT_LE((dual.vertices.row(0) - Eigen::RowVector3d(0.5, 0.5 + s / 4, 0)).norm(), 1e-15);
        EXPECT_LE((dual.vertices.row(1) - Eigen::RowVector3d(1.5, 0.5 + s / 4, 0)).norm(), 1e-15);
        EXPECT_EQ(dual.rank, 1);
        EXPECT_NEAR(dual.largest_shift, std::abs(s) / 4, 1e-15);
        for (const DualEdge& e : dual.edges) {
            if (!inner(e)) continue;
            EXPECT_LE((e.point - Vector3(1, 0.5 + s / 4, 0)).norm(), 1e-15);
            EXPECT_NEAR(e.weight, 1, 1e-15);
        }
        // With μ the gap s/2 shrinks to s/2 / (1 + 2μ).
        const OrthogonalDual soft = get(orthogonal_dual(mesh, {.mu = 2}));
        EXPECT_NEAR(soft.residual, std::abs(s) / 2 / 5 / std::pow(longest_edge(mesh), 2), 1e-15);
        EXPECT_TRUE(inner(dual.edges[static_cast<std::size_t>(soft.worst_edge)]));
    }
}

TEST(OrthogonalDual, CompromiseLiesBetween) {
    for (const char* name : {"concave-hexagons-6", "grid-8x8-skew", "hexagon-sphere-2"}) {
        double last_residual = std::numeric_limits<double>::infinity();
        double last_distance = 0;
        const PolygonMesh& mesh = specimen(name);
        for (const double mu : {1e-3, 0.1, 10.0, 1e3, 1e6, 1e15, 0.0}) {
            const OrthogonalDual dual = get(orthogonal_dual(mesh, {.mu = mu}));
            const double distance = (dual.vertices - barycentres(mesh)).norm();
            EXPECT_LT(dual.residual, last_residual * (1 + 1e-6) + 1e-12) << name << ", " << mu;
            EXPECT_GE(distance, last_distance * (1 - 1e-9)) << name << ", " << mu;
            last_residual = dual.residual;
            last_distance = distance;
        }
    }
    EXPECT_FALSE(get(orthogonal_dual(specimen("concave-hexagons-6"))).usable);
    EXPECT_TRUE(get(orthogonal_dual(specimen("concave-hexagons-6"), {.mu = 1})).usable);
}

// Also where singular values go down to the rounding of coordinates, as those of a file with few digits.
TEST(OrthogonalDual, StandsNearlyDependentConstraints) {
    std::vector<Specimen> hard{{"UV sphere", uv_sphere(48, 24)},
                               {"noisy UV sphere", get(add_normal_noise(uv_sphere(48, 24), 0.1, 4))},
                               {"thin fans", get(add_normal_noise(uv_sphere(400, 6), 0.3, 4))},
                               {"noisy torus", get(add_normal_noise(get(make_torus(40, 20)), 0.2, 7))},
                               {"saddle", get(make_saddle(30, 1.7))},
                               {"concave hexagons", specimen("concave-hexagons-6")}};
    for (const double unit : {1e-9, 1e-7, 1e-5, 1e-3}) {
        hard.push_back({"rounded hexagon sphere", rounded(specimen("hexagon-sphere-2"), unit)});
        hard.push_back({"rounded UV sphere", rounded(uv_sphere(48, 24), unit)});
    }
    for (const auto& [name, mesh] : hard) {
        SCOPED_TRACE(name);
        const OrthogonalDual dual = get(orthogonal_dual(mesh));
        EXPECT_LE(dual.residual, 1e-10);
        EXPECT_LE(dual.rank, dual.constraints);
        EXPECT_GE(dual.rank, dual.constraints - 60);
    }
}

TEST(OrthogonalDual, TreatsComponentsApart) {
    const PolygonMesh& mesh = specimen("two-components");  // a flat grid and a single face
    const OrthogonalDual dual = get(orthogonal_dual(mesh));
    EXPECT_LE((dual.vertices - barycentres(mesh)).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(dual.edges.size(), 22u);
    EXPECT_EQ(get(orthogonal_dual(specimen("unreferenced-vertices"))).vertices.rows(), 1);
}

// Equilateral triangles: circumcentres are barycentres, so the weights are cotangents.
TEST(OrthogonalDual, IsTheCotanLaplacianOnEquilateralTriangles) {
    std::vector<Vector3> points;
    std::vector<std::vector<Index>> faces;
    for (int j = 0; j < 5; ++j) {
        for (int i = 0; i < 5; ++i) {
            points.emplace_back(i + 0.5 * j, std::sqrt(0.75) * j, 0);
            if (i == 4 || j == 4) continue;
            const Index v = 5 * j + i;
            faces.push_back({v, v + 1, v + 5});
            faces.push_back({v + 1, v + 6, v + 5});
        }
    }
    for (const DualEdge& e : get(orthogonal_dual(make_mesh(points, faces))).edges) {
        EXPECT_NEAR(e.weight, (inner(e) ? 1 : 0.5) / std::sqrt(3.0), 1e-13);
    }
}

}  // namespace
}  // namespace polylap::test

// The two operators with weighted vertices: Glickenstein's on triangles, Lemma 4 on polygons.

#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "operator_cases.hpp"
#include "polylap/face/triangulate_mesh.hpp"
#include "polylap/operators/alexa_wardetzky.hpp"
#include "polylap/operators/alexa_wardetzky_weighted.hpp"
#include "polylap/operators/cotan.hpp"
#include "polylap/operators/weighted_cotan.hpp"

namespace polylap::test {
namespace {

/// Eq. 3.24 and 3.25 as they read, for triangles.
Matrix glickenstein(const PolygonMesh& mesh, const std::vector<double>& omega) {
    Matrix s = Matrix::Zero(mesh.vertex_count(), mesh.vertex_count());
    for (Index f = 0; f < mesh.face_count(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
            for (const int turn : {1, 2}) {
                const Index i = mesh.face(f)[k];
                const Index j = mesh.face(f)[(k + static_cast<std::size_t>(turn)) % 3];
                const Index l = mesh.face(f)[(k + static_cast<std::size_t>(3 - turn)) % 3];
                const auto d = [&](Index a, Index b) {
                    const double e = (mesh.position(b) - mesh.position(a)).norm();
                    return (e * e + omega[static_cast<std::size_t>(a)] - omega[static_cast<std::size_t>(b)]) / (2 * e);
                };
                const Vector3 to_j = mesh.position(j) - mesh.position(i);
                const Vector3 to_l = mesh.position(l) - mesh.position(i);
                const double gamma = std::atan2(to_j.cross(to_l).norm(), to_j.dot(to_l));
                const double w = (d(i, l) - d(i, j) * std::cos(gamma)) / (to_j.norm() * std::sin(gamma));
                s(i, j) -= w;
                s(i, i) += w;
            }
        }
    }
    return s;
}

TEST(WeightedCotan, EqualsGlickensteinsFormula) {
    int compared = 0;
    for (const auto& [name, mesh] : zoo()) {
        if (!only_triangles(mesh)) continue;
        ++compared;
        const auto omega = random_weights(mesh, 21);
        const SparseMatrix s = get(weighted_cotan_matrices(mesh, omega)).stiffness;
        EXPECT_LE((Matrix(s) - glickenstein(mesh, omega)).cwiseAbs().maxCoeff(), 1e-11 * largest(s)) << name;
    }
    EXPECT_GE(compared, 4);
}

TEST(WeightedCotan, WithoutWeightsOrWithOneForAllIsCotan) {
    for (const auto& [name, mesh] : zoo()) {
        const auto expected = cotan_matrices(mesh);
        ASSERT_TRUE(expected.ok()) << name;
        const std::vector<double> zeros(static_cast<std::size_t>(mesh.vertex_count()), 0.0);
        const std::vector<double> fives(static_cast<std::size_t>(mesh.vertex_count()), 5.0);
        for (const std::span<const double> weights : {std::span<const double>(), std::span(zeros), std::span(fives)}) {
            const auto m = get(weighted_cotan_matrices(mesh, weights));
            EXPECT_EQ(difference(m.stiffness, expected->stiffness), 0) << name;
            EXPECT_EQ(difference(m.mass, expected->mass), 0) << name;
        }
    }
}

// Linear functions have no Laplacian at inner vertices of flat meshes, whatever the weights; on curved ones S stays
// symmetric.
TEST(WeightedCotan, IsLinearlyPreciseAndSymmetricForAllWeights) {
    for (const char* name : {"obtuse-fan", "grid-8x8-skew", "zigzag", "triangle-sphere-2", "saddle-12x12"}) {
        const auto mesh = get(triangulate_mesh(specimen(name), TriangulationRule::fan));
        for (const std::uint32_t seed : {1U, 2U, 3U}) {
            const SparseMatrix s = get(weighted_cotan_matrices(mesh, random_weights(mesh, seed))).stiffness;
            EXPECT_EQ(difference(s, s.transpose()), 0) << name;
            EXPECT_GT(difference(s, get(cotan_matrices(mesh)).stiffness), 0.01) << "the weights do something";
            const Points sx = s * mesh.positions();
            for (const Index v : flat_inner_vertices(mesh)) {
                EXPECT_LE(sx.row(v).norm(), 1e-12 * largest(s) * bounding_size(mesh)) << name << ", " << v;
            }
        }
    }
    EXPECT_FALSE(flat_inner_vertices(specimen("obtuse-fan")).empty());
}

// Lemma 4.
TEST(AlexaWardetzkyWeighted, IsGlickensteinsOperatorOnTriangles) {
    int compared = 0;
    for (const auto& [name, mesh] : zoo()) {
        if (!only_triangles(mesh)) continue;
        ++compared;
        const auto omega = random_weights(mesh, 4);
        const SparseMatrix expected = get(weighted_cotan_matrices(mesh, omega)).stiffness;
        for (const double lambda : {0.0, 1.0, 3.0}) {
            const SparseMatrix s = get(alexa_wardetzky_weighted_stiffness(mesh, omega, {lambda}));
            EXPECT_LE(difference(s, expected), 1e-11 * largest(expected)) << name << ", λ = " << lambda;
        }
    }
    EXPECT_GE(compared, 4);
}

TEST(AlexaWardetzkyWeighted, WithoutWeightsOrWithOneForAllIsUnweighted) {
    for (const auto& [name, mesh] : zoo()) {
        const std::vector<double> fives(static_cast<std::size_t>(mesh.vertex_count()), 5.0);
        for (const double lambda : {0.0, 1.0}) {
            const SparseMatrix expected = get(alexa_wardetzky_stiffness(mesh, {lambda}));
            for (const std::span<const double> weights : {std::span<const double>(), std::span(fives)}) {
                const SparseMatrix s = get(alexa_wardetzky_weighted_stiffness(mesh, weights, {lambda}));
                EXPECT_EQ(difference(s, expected), 0) << name;
            }
        }
    }
}

TEST(AlexaWardetzkyWeighted, TheTransposeIsLinearlyPreciseOnPolygons) {
    for (const char* name : {"grid-8x8-skew", "zigzag", "cube-3"}) {
        const auto& mesh = specimen(name);
        const SparseMatrix s = get(alexa_wardetzky_weighted_stiffness(mesh, random_weights(mesh, 9)));
        const Points forth = s * mesh.positions();
        const Points back = s.transpose() * mesh.positions();
        double worst = 0;
        for (const Index v : flat_inner_vertices(mesh)) {
            EXPECT_LE(back.row(v).norm(), 1e-12 * largest(s) * bounding_size(mesh)) << name << ", " << v;
            worst = std::max(worst, forth.row(v).norm());
        }
        EXPECT_GT(worst, 1e-3) << name;
    }
}

const std::vector<Vector3> trapezium{{-2, 0, 0}, {2, 0, 0}, {1, 1, 0}, {-1, 1, 0}};

Matrix trapezium_matrix(const Eigen::Vector4d& t, double lambda) {
    std::vector<double> distances;
    for (std::size_t i = 0; i < 4; ++i) {
        distances.push_back(t[static_cast<Eigen::Index>(i)] * (trapezium[(i + 1) % 4] - trapezium[i]).norm());
    }
    return get(alexa_wardetzky_weighted_face(trapezium, distances, {lambda}));
}
Vector asymmetry(const Matrix& s) {
    return (s - s.transpose()).reshaped();
}

// Table 4.1: with edge points at fractions t of the edges, the trapezium is symmetric exactly for t₁₂ = 2 - 3 t₀₁,
// t₂₃ = 1 - t₀₁, t₃₀ = 2 - 3 t₀₁. S is affine in t, so its asymmetry is zero on an affine set: of dimension one.
TEST(AlexaWardetzkyWeighted, TheTrapeziumIsSymmetricOnOneFamily) {
    for (const double lambda : {0.0, 1.0}) {
        for (const double t : {-1.0, 0.0, 0.25, 0.5, 0.8, 2.0}) {
            const Eigen::Vector4d family(t, 2 - 3 * t, 1 - t, 2 - 3 * t);
            EXPECT_LE(asymmetry(trapezium_matrix(family, lambda)).norm(), 1e-13) << t;
            for (int k = 0; k < 4; ++k) {
                EXPECT_GT(asymmetry(trapezium_matrix(family + 0.01 * Eigen::Vector4d::Unit(k), lambda)).norm(), 1e-3)
                    << t << ", edge " << k;
            }
        }
        Matrix derivative(16, 4);
        const Vector origin = asymmetry(trapezium_matrix(Eigen::Vector4d::Zero(), lambda));
        for (int k = 0; k < 4; ++k) {
            derivative.col(k) = asymmetry(trapezium_matrix(Eigen::Vector4d::Unit(k), lambda)) - origin;
        }
        Eigen::FullPivLU<Matrix> lu(derivative);
        lu.setThreshold(1e-10);
        EXPECT_EQ(lu.rank(), 3);
    }
}

TEST(AlexaWardetzkyWeighted, OneFaceIsTheMeshOfOneFace) {
    const std::vector<double> omega{0.3, -1.1, 0.7, 0.2};
    std::vector<double> distances;
    for (std::size_t i = 0; i < 4; ++i) {
        const double e = (trapezium[(i + 1) % 4] - trapezium[i]).norm();
        distances.push_back((e * e + omega[i] - omega[(i + 1) % 4]) / (2 * e));
    }
    for (const double lambda : {0.0, 1.0}) {
        const Matrix face = get(alexa_wardetzky_weighted_face(trapezium, distances, {lambda}));
        const Matrix mesh(get(alexa_wardetzky_weighted_stiffness(make_face(trapezium), omega, {lambda})));
        EXPECT_LE((face - mesh).cwiseAbs().maxCoeff(), 1e-14);
    }
}

template <class T>
void expect_error(const Result<T>& result, ErrorCode code, const char* word) {
    ASSERT_FALSE(result.ok()) << word;
    EXPECT_EQ(result.error().code, code) << result.error().message;
    EXPECT_NE(result.error().message.find(word), std::string::npos) << result.error().message;
}

TEST(AlexaWardetzkyWeighted, Refuses) {
    const double nan = std::nan("");
    const std::vector<double> ones(4, 1.0);
    const std::vector<double> broken{1, 1, nan, 1};
    const auto face = [](const std::vector<Vector3>& x, const std::vector<double>& d, double lambda = 1) {
        return alexa_wardetzky_weighted_face(x, d, {lambda});
    };
    expect_error(face(trapezium, {1, 1}), ErrorCode::bad_argument, "one distance");
    expect_error(face({{0, 0, 0}, {1, 0, 0}}, {1, 1}), ErrorCode::bad_argument, "three corners");
    expect_error(face(trapezium, broken), ErrorCode::bad_argument, "distances");
    expect_error(face({{0, 0, 0}, {1, 0, 0}, {1, nan, 0}, {0, 1, 0}}, ones), ErrorCode::bad_argument, "corners");
    expect_error(face(trapezium, ones, -1), ErrorCode::parameter_out_of_range, "lambda");
    const std::vector<Vector3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    expect_error(face(line, ones), ErrorCode::degenerate_face, "vector area");
    const std::vector<Vector3> pinched{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    expect_error(face(pinched, ones), ErrorCode::degenerate_face, "corners 1 and 2");

    const auto mesh = make_face(pinched);
    expect_error(alexa_wardetzky_weighted_stiffness(mesh, std::vector<double>{0, 0, 1, 0}), ErrorCode::degenerate_face,
                 "face 0");
    EXPECT_TRUE(alexa_wardetzky_weighted_stiffness(mesh, std::vector<double>{0, 1, 1, 0}).ok())
        << "equal weights leave the point of an edge in its middle";
    expect_error(alexa_wardetzky_weighted_stiffness(mesh, {}, {-1}), ErrorCode::parameter_out_of_range, "lambda");
    expect_error(alexa_wardetzky_weighted_stiffness(mesh, std::vector<double>(3)), ErrorCode::bad_argument, "3 vertex");
    expect_error(alexa_wardetzky_weighted_stiffness(mesh, broken), ErrorCode::bad_argument, "vertex 2");
    expect_error(weighted_cotan_matrices(mesh, broken), ErrorCode::bad_argument, "vertex 2");
    expect_error(weighted_cotan_matrices(mesh, std::vector<double>(3)), ErrorCode::bad_argument, "3 vertex");
}

}  // namespace
}  // namespace polylap::test

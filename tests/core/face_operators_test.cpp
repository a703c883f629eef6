// The operators that are finite elements of faces, and what only they promise.

#include <cmath>
#include <random>

#include <Eigen/Eigenvalues>

#include "naive.hpp"
#include "operator_cases.hpp"
#include "polylap/apply/diagnostics.hpp"
#include "polylap/face/vector_area.hpp"
#include "polylap/mesh/shapes.hpp"
#include "polylap/operators/alexa_wardetzky.hpp"
#include "polylap/operators/planar.hpp"

namespace polylap::test {
namespace {

template <class Visit>
void for_face_operators(Visit&& visit) {
    for_all([&](const Specimen& s, const OperatorSpec& spec, const OperatorMatrices& m, double scale) {
        const bool of_faces = spec.id == "alexa-wardetzky" || spec.id == "planar" || spec.id == "cotan" ||
                              spec.id == "weighted-cotan" || spec.id == "alexa-wardetzky-weighted";
        if (of_faces && spec.vertex_weights.empty()) visit(s, m, scale);
    });
}

// The linear functions of a flat mesh have the gradient 1, so their energy is the area: that fixes the factor of S.
TEST(FaceOperators, EnergyOfLinearFunctionsIsTheArea) {
    for_face_operators([](const Specimen& s, const OperatorMatrices& m, double scale) {
        if (!planar_faces(s.mesh) || s.mesh.positions().col(2).cwiseAbs().maxCoeff() > 0) return;
        const Topology topology = build_topology(*s.mesh.connectivity());
        const double area = measure_shape(s.mesh, topology).area;
        for (const double t : {0.0, 0.7, 2.0}) {
            const Vector u = std::cos(t) * s.mesh.positions().col(0) + std::sin(t) * s.mesh.positions().col(1);
            EXPECT_NEAR(u.dot(m.stiffness * u), area, 1e-12 * scale * std::pow(bounding_size(s.mesh), 2));
        }
    });
}

TEST(FaceOperators, AreTheCotanLaplacianOnTriangles) {
    int compared = 0;
    for_face_operators([&](const Specimen& s, const OperatorMatrices& m, double scale) {
        if (!only_triangles(s.mesh)) return;
        ++compared;
        EXPECT_LE((Matrix(m.stiffness) - naive::cotan(s.mesh)).cwiseAbs().maxCoeff(), 1e-12 * scale);
    });
    EXPECT_GE(compared, 80);
}

// Regular polygons, torus quads and squares have several best triangulations; in the plane all have one matrix, at any
// scale and wherever the face begins.
TEST(FaceOperators, TiesDoNotChangeThePlanarMatrix) {
    for (const auto& [name, mesh] : zoo()) {
        if (mesh.vertex_count() > 330) continue;
        std::vector<Index> corners;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            std::vector<Index> face(mesh.face(f).begin(), mesh.face(f).end());
            std::rotate(face.begin(), face.begin() + 1 + f % static_cast<Index>(face.size() - 1), face.end());
            corners.insert(corners.end(), face.begin(), face.end());
        }
        const auto turned = get(PolygonMesh::create(mesh.positions(), mesh.connectivity()->offsets, corners));
        for (const auto rule :
             {TriangulationRule::delaunay, TriangulationRule::min_max_angle, TriangulationRule::shortest_diagonal}) {
            const SparseMatrix s = get(planar_stiffness(mesh, {rule}));
            const double tolerance = rounding_of(mesh, bounding_size(mesh), largest(s)) * largest(s);
            EXPECT_LE(difference(get(planar_stiffness(turned, {rule})), s), tolerance) << name;
            for (const double factor : {1e-60, 1e-12, 1e-3, 1e3, 1e12, 1e60}) {
                const auto scaled = get(mesh.with_positions(factor * mesh.positions()));
                EXPECT_LE(difference(get(planar_stiffness(scaled, {rule})), s), tolerance) << name << ", " << factor;
            }
        }
    }
}

// The definitions, face by face, by singular values and by looking at all triangulations.
TEST(FaceOperators, EqualTheirPlainDefinitions) {
    for (const auto& [name, mesh] : zoo()) {
        if (mesh.face_count() > 1 || name == "unreferenced-vertices") continue;
        std::vector<Vector3> corners;
        gather_corners(mesh, 0, corners);
        for (const double lambda : {0.0, 0.3, 1.0, 4.0}) {
            const Matrix s(get(alexa_wardetzky_stiffness(mesh, {lambda})));
            EXPECT_LE((s - naive::alexa_wardetzky(corners, lambda)).cwiseAbs().maxCoeff(),
                      1e-12 * s.diagonal().maxCoeff())
                << name;
        }
        Projection projection;
        ASSERT_TRUE(project_maximally(corners, projection));
        if (corners.size() > 8 || name == "straight-corners") continue;
        const auto all = naive::triangulations(projection.points);
        std::size_t smoothest = 0;
        std::size_t roundest = 0;
        for (std::size_t k = 1; k < all.size(); ++k) {
            const auto trace = [&](std::size_t m) { return naive::cotan(projection.points, all[m]).trace(); };
            const auto angles = [&](std::size_t m) { return naive::sorted_angles(projection.points, all[m]); };
            if (trace(k) < trace(smoothest)) smoothest = k;
            if (naive::angles_less(angles(k), angles(roundest))) roundest = k;
        }
        const Matrix delaunay(get(planar_stiffness(mesh, {TriangulationRule::delaunay})));
        EXPECT_LE((delaunay - naive::cotan(projection.points, all[smoothest])).cwiseAbs().maxCoeff(),
                  1e-12 * delaunay.maxCoeff())
            << name;
        const Matrix round(get(planar_stiffness(mesh, {TriangulationRule::min_max_angle})));
        EXPECT_LE((round - naive::cotan(projection.points, all[roundest])).cwiseAbs().maxCoeff(),
                  1e-12 * round.maxCoeff())
            << name;
    }
}

TEST(Unstabilised, KernelDimensions) {
    const auto kernel = [](const PolygonMesh& mesh) {
        const Matrix s(get(alexa_wardetzky_stiffness(mesh, {0})));
        const Eigen::SelfAdjointEigenSolver<Matrix> solver(s, Eigen::EigenvaluesOnly);
        return (solver.eigenvalues().array() < 1e-9 * solver.eigenvalues().maxCoeff()).count();
    };
    EXPECT_EQ(kernel(get(make_grid(8, 8))), 2);
    EXPECT_EQ(kernel(get(make_torus(16, 8))), 2);
    EXPECT_EQ(kernel(get(make_torus(15, 9))), 1);
}

}  // namespace
}  // namespace polylap::test

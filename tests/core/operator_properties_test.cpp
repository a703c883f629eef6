// Every line of the operator table, at all its choices and several values of its parameters, on the whole zoo. Nothing
// here knows an operator.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "naive.hpp"
#include "polylap/apply/diagnostics.hpp"
#include "polylap/face/vector_area.hpp"
#include "polylap/mesh/shapes.hpp"
#include "polylap/operators/alexa_wardetzky.hpp"
#include "polylap/operators/mass.hpp"
#include "polylap/operators/planar.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

/// The matrices, or nothing where the operator refuses a face.
std::optional<OperatorMatrices> try_build(const PolygonMesh& mesh, const OperatorSpec& spec) {
    auto result = build_operator(mesh, spec);
    if (result) return *std::move(result);
    const Error& error = result.error();
    if (error.code != ErrorCode::degenerate_face) throw std::runtime_error(error.message);
    EXPECT_GE(error.element, 0);
    EXPECT_LT(error.element, mesh.face_count());
    EXPECT_NE(error.message.find("face " + std::to_string(error.element)), std::string::npos) << error.message;
    return std::nullopt;
}

/// Calls `visit(specimen, spec, matrices, scale)` for everything that can be built; scale is the largest diagonal entry
/// of S.
template <class Visit>
void for_all(Visit&& visit, Index most_vertices = 1 << 20) {
    for (const OperatorSpec& spec : all_specs()) {
        for (const Specimen& s : zoo()) {
            if (s.mesh.vertex_count() > most_vertices) continue;
            const auto matrices = try_build(s.mesh, spec);
            if (!matrices) continue;
            SCOPED_TRACE(spec_name(spec) + " on " + s.name);
            visit(s, spec, *matrices, matrices->stiffness.diagonal().maxCoeff());
        }
    }
}

double largest(const SparseMatrix& a) {
    return a.nonZeros() == 0 ? 0 : a.coeffs().abs().maxCoeff();
}
double difference(const SparseMatrix& a, const SparseMatrix& b) {
    return largest(SparseMatrix(a - b));
}

// --- the claims: how far each is from holding, relative to the matrix ---

constexpr double holds = 1e-11;  // beyond rounding
constexpr double broken = 1e-6;  // a counter-example that no rounding makes

double asymmetry(const PolygonMesh&, const SparseMatrix& s) {
    return difference(s, s.transpose());
}

double negativity(const PolygonMesh&, const SparseMatrix& s) {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(Matrix((s + SparseMatrix(s.transpose())) / 2),
                                                       Eigen::EigenvaluesOnly);
    return std::max(0.0, -solver.eigenvalues()[0]);
}

double constants(const PolygonMesh&, const SparseMatrix& s) {
    return (s * Vector::Ones(s.cols())).cwiseAbs().maxCoeff();
}

double imprecision(const PolygonMesh& mesh, const SparseMatrix& s) {
    const Points sx = s * (mesh.positions().rowwise() - mesh.positions().row(0));
    double worst = 0;
    for (const Index v : flat_inner_vertices(mesh)) {
        worst = std::max(worst, sx.row(v).norm() / bounding_size(mesh));
    }
    return worst;
}

double negative_weight(const PolygonMesh&, const SparseMatrix& s) {
    double worst = 0;
    for (Index j = 0; j < s.cols(); ++j) {
        for (SparseMatrix::InnerIterator it(s, j); it; ++it) {
            if (it.row() != j) worst = std::max(worst, it.value());
        }
    }
    return worst;
}

struct Property {
    const char* name;
    PropertyClaim PropertyClaims::*claim;
    double (*violation)(const PolygonMesh&, const SparseMatrix&);
    Index most_vertices;
};
constexpr Property checked[] = {{"symmetric", &PropertyClaims::symmetric, asymmetry, 1000},
                                {"positive semidefinite", &PropertyClaims::positive_semidefinite, negativity, 120},
                                {"constants in kernel", &PropertyClaims::constants_in_kernel, constants, 1000},
                                {"linear precision", &PropertyClaims::linear_precision, imprecision, 1000},
                                {"positive weights", &PropertyClaims::positive_weights, negative_weight, 1000}};

bool claimed(Claim claim, const PolygonMesh& mesh) {
    switch (claim) {
        case Claim::yes:
            return true;
        case Claim::planar:
            return planar_faces(mesh);
        case Claim::triangles:
            return only_triangles(mesh);
        case Claim::no:
            return false;
    }
    return false;
}

TEST(Claims, HoldWhereClaimedAndFailWhereNot) {
    for (const OperatorInfo* info : operators()) {
        for (const Property& property : checked) {
            const Claim claim = (info->claims.*property.claim).where;
            int held = 0;
            std::string counter_example;
            for (const OperatorSpec& spec : all_specs()) {
                if (spec.id != info->id) continue;
                for (const Specimen& s : zoo()) {
                    if (s.mesh.vertex_count() > property.most_vertices) continue;
                    const auto matrices = try_build(s.mesh, spec);
                    if (!matrices) continue;
                    const double violation =
                        property.violation(s.mesh, matrices->stiffness) / matrices->stiffness.diagonal().maxCoeff();
                    if (claimed(claim, s.mesh)) {
                        ++held;
                        EXPECT_LE(violation, holds) << property.name << ": " << spec_name(spec) << " on " << s.name;
                    } else if (violation > broken) {
                        counter_example = s.name;
                    }
                }
            }
            if (claim == Claim::yes) {
                EXPECT_GE(held, 30) << info->id << ", " << property.name;
            } else {
                EXPECT_FALSE(counter_example.empty())
                    << info->id << " never violates " << property.name << ", the claim is too weak";
            }
        }
    }
}

TEST(Zoo, TestsWhatItShould) {
    Index flat = 0;
    for (const char* name : {"grid-8x8-skew", "zigzag", "cube-3"}) {
        EXPECT_TRUE(planar_faces(specimen(name))) << name;
        EXPECT_GE(flat_inner_vertices(specimen(name)).size(), 20u) << name;
    }
    for (const auto& [name, mesh] : zoo()) {
        flat += static_cast<Index>(flat_inner_vertices(mesh).size());
    }
    EXPECT_GE(flat, 100);
    EXPECT_TRUE(planar_faces(specimen("saddle-7"))) << "f(x) + g(y) has planar quads";
    EXPECT_TRUE(flat_inner_vertices(specimen("saddle-7")).empty());
    for (const char* name : {"saddle-12x12", "torus-10x7-noisy", "wavy-4", "moebius"}) {
        EXPECT_GT(non_planarity(specimen(name)), 1e-3) << name;
    }
    EXPECT_TRUE(only_triangles(specimen("triangle-sphere-2")));
    EXPECT_GE(all_specs().size(), 8u);
}

// Refusals are few: only faces that no corner sees whole, where the choice asks for one.
TEST(Operators, BuildNearlyEverywhere) {
    int refused = 0;
    int built = 0;
    for (const OperatorSpec& spec : all_specs()) {
        for (const Specimen& s : zoo()) {
            const bool ok = try_build(s.mesh, spec).has_value();
            ++(ok ? built : refused);
            const bool star = s.name.find("star") != std::string::npos;
            EXPECT_TRUE(ok || star) << spec_name(spec) << " on " << s.name;
        }
    }
    EXPECT_LE(refused, 2);
    EXPECT_GE(built, 300);
}

TEST(Operators, HaveTheShapeOfTheMesh) {
    for_all([](const Specimen& s, const OperatorSpec&, const OperatorMatrices& m, double scale) {
        EXPECT_EQ(m.stiffness.rows(), s.mesh.vertex_count());
        EXPECT_EQ(m.stiffness.cols(), s.mesh.vertex_count());
        EXPECT_EQ(m.mass.rows(), s.mesh.vertex_count());
        EXPECT_EQ(m.mass.cols(), s.mesh.vertex_count());
        EXPECT_TRUE(std::isfinite(largest(m.stiffness)));
        EXPECT_GT(scale, 0);
    });
}

// The linear functions of a flat mesh have the gradient 1, so their energy is the area: that fixes the factor of S.
TEST(Operators, EnergyOfLinearFunctionsIsTheArea) {
    for_all([](const Specimen& s, const OperatorSpec&, const OperatorMatrices& m, double scale) {
        if (!planar_faces(s.mesh) || s.mesh.positions().col(2).cwiseAbs().maxCoeff() > 0) return;
        const Topology topology = build_topology(*s.mesh.connectivity());
        const double area = measure_shape(s.mesh, topology).area;
        for (const double t : {0.0, 0.7, 2.0}) {
            const Vector u = std::cos(t) * s.mesh.positions().col(0) + std::sin(t) * s.mesh.positions().col(1);
            EXPECT_NEAR(u.dot(m.stiffness * u), area, 1e-12 * scale * std::pow(bounding_size(s.mesh), 2));
        }
    });
}

TEST(Operators, MassIsDiagonalAndSumsToTheArea) {
    for_all([](const Specimen& s, const OperatorSpec&, const OperatorMatrices& m, double) {
        const Topology topology = build_topology(*s.mesh.connectivity());
        const double area = measure_shape(s.mesh, topology).area;
        EXPECT_NEAR(m.mass.sum(), area, 1e-13 * area);
        EXPECT_EQ(difference(m.mass, SparseMatrix(Vector(m.mass.diagonal()).asDiagonal())), 0);
        for (Index v = 0; v < s.mesh.vertex_count(); ++v) {
            const bool loose = topology.component[static_cast<std::size_t>(v)] < 0;
            EXPECT_EQ(m.mass.coeff(v, v) > 0, !loose) << v;
            EXPECT_EQ(m.stiffness.coeff(v, v) != 0, !loose) << v;
        }
    });
}

TEST(Operators, AreTheCotanLaplacianOnTriangles) {
    int compared = 0;
    for_all([&](const Specimen& s, const OperatorSpec&, const OperatorMatrices& m, double scale) {
        if (!only_triangles(s.mesh)) return;
        ++compared;
        EXPECT_LE((Matrix(m.stiffness) - naive::cotan(s.mesh)).cwiseAbs().maxCoeff(), 1e-12 * scale);
    });
    EXPECT_GE(compared, 4 * static_cast<int>(all_specs().size()));
}

/// What S may change by, relative to its largest entry, when coordinates move by the rounding of numbers of size
/// `reach`. Angles change by position errors over the shortest edge, and cotangents by their square times that: `scale`
/// stands for the largest cotangent.
double rounding_of(const PolygonMesh& mesh, double reach, double scale) {
    double shortest = bounding_size(mesh);
    for (const Edge& e : build_topology(*mesh.connectivity()).edges) {
        shortest = std::min(shortest, (mesh.position(e.v1) - mesh.position(e.v0)).norm());
    }
    return 1e3 * 1.1e-16 * reach / shortest * std::max(1.0, scale);
}

TEST(Operators, IgnoreRigidMotions) {
    const Eigen::Matrix3d rotation =
        (Eigen::AngleAxisd(0.9, Vector3(1, -2, 0.5).normalized()) * Eigen::AngleAxisd(2.1, Vector3::UnitY()))
            .toRotationMatrix();
    for_all(
        [&](const Specimen& s, const OperatorSpec& spec, const OperatorMatrices& m, double scale) {
            const double size = bounding_size(s.mesh);
            for (const double far : {0.0, 3.0, 1e4}) {
                const Points moved = (s.mesh.positions() * rotation.transpose()).rowwise() +
                                     far * size * Eigen::RowVector3d(0.3, -0.9, 0.4);
                const auto there = get(build_operator(get(s.mesh.with_positions(moved)), spec));
                if (far > 100 && s.name == "straight-corners") continue;  // they are not straight any more
                const double tolerance = rounding_of(s.mesh, size * (1 + far), scale);
                EXPECT_LE(difference(there.stiffness, m.stiffness), tolerance * scale) << far;
                EXPECT_LE(difference(there.mass, m.mass), tolerance * largest(m.mass)) << far;
            }
        },
        330);
}

// S has no unit and M goes with the square of the scale, without any absolute threshold in between. 1e±60: products of
// four lengths, as in tests for cocircular corners, still fit a double.
TEST(Operators, ScaleWithTheMesh) {
    for_all(
        [](const Specimen& s, const OperatorSpec& spec, const OperatorMatrices& m, double scale) {
            for (const double factor : {1e-60, 1e-12, 1e-6, 1e-3, 1e3, 1e6, 1e12, 1e60}) {
                const auto scaled = get(build_operator(get(s.mesh.with_positions(factor * s.mesh.positions())), spec));
                EXPECT_LE(difference(scaled.stiffness, m.stiffness),
                          rounding_of(s.mesh, bounding_size(s.mesh), scale) * scale)
                    << factor;
                EXPECT_LE(difference(scaled.mass / factor / factor, m.mass), 1e-12 * largest(m.mass)) << factor;
                EXPECT_EQ(summarise_weights(scaled.stiffness).negative_ordered,
                          summarise_weights(m.stiffness).negative_ordered)
                    << factor;
            }
        },
        330);
}

TEST(Operators, FollowTheLabelsOfVertices) {
    std::mt19937 random(12);
    for_all(
        [&](const Specimen& s, const OperatorSpec& spec, const OperatorMatrices& m, double scale) {
            Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> p(s.mesh.vertex_count());
            p.setIdentity();
            for (Index k = s.mesh.vertex_count() - 1; k > 0; --k) {
                std::swap(p.indices()[k],
                          p.indices()[static_cast<Index>(random() % static_cast<std::uint32_t>(k + 1))]);
            }
            std::vector<Index> corners = s.mesh.connectivity()->corners;
            for (Index& v : corners) {
                v = p.indices()[v];
            }
            const auto renamed =
                get(PolygonMesh::create(p * s.mesh.positions(), s.mesh.connectivity()->offsets, corners));
            const auto there = get(build_operator(renamed, spec));
            const SparseMatrix stiffness = p * m.stiffness * p.transpose();
            const SparseMatrix mass = p * m.mass * p.transpose();
            EXPECT_LE(difference(there.stiffness, stiffness), 1e-13 * scale);
            EXPECT_LE(difference(there.mass, mass), 1e-13 * largest(m.mass));
        },
        330);
}

PolygonMesh with_turned_faces(const PolygonMesh& mesh) {
    std::vector<Index> corners;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        std::vector<Index> face(mesh.face(f).begin(), mesh.face(f).end());
        std::rotate(face.begin(), face.begin() + 1 + f % static_cast<Index>(face.size() - 1), face.end());
        corners.insert(corners.end(), face.begin(), face.end());
    }
    return get(PolygonMesh::create(mesh.positions(), mesh.connectivity()->offsets, corners));
}

// All but the rule `fan`, which begins at the first corner by definition.
TEST(Operators, DoNotMindWhereAFaceBegins) {
    const auto expect_same = [](const std::string& name, const SparseMatrix& a, const SparseMatrix& b,
                                const PolygonMesh& mesh) {
        EXPECT_LE(difference(a, b), rounding_of(mesh, bounding_size(mesh), largest(a)) * largest(a)) << name;
    };
    for (const auto& [name, mesh] : zoo()) {
        const PolygonMesh turned = with_turned_faces(mesh);
        for (const double lambda : {0.0, 1.0}) {
            expect_same(name, get(alexa_wardetzky_stiffness(mesh, {lambda})),
                        get(alexa_wardetzky_stiffness(turned, {lambda})), mesh);
        }
        for (const auto rule :
             {TriangulationRule::delaunay, TriangulationRule::min_max_angle, TriangulationRule::shortest_diagonal}) {
            expect_same(name, get(planar_stiffness(mesh, {rule})), get(planar_stiffness(turned, {rule})), mesh);
        }
        expect_same(name, get(lumped_mass(mesh)), get(lumped_mass(turned)), mesh);
    }
    EXPECT_GT(difference(get(planar_stiffness(specimen("wavy-8"), {TriangulationRule::fan})),
                         get(planar_stiffness(with_turned_faces(specimen("wavy-8")), {TriangulationRule::fan}))),
              1e-3);
}

// A sum over faces does not mind which way a face runs.
TEST(Operators, DoNotMindTheOrientationOfFaces) {
    for (const auto& [name, mesh] : zoo()) {
        std::vector<Index> corners;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            std::vector<Index> face(mesh.face(f).begin(), mesh.face(f).end());
            if (f % 3 == 0) std::reverse(face.begin(), face.end());
            corners.insert(corners.end(), face.begin(), face.end());
        }
        const auto flipped = get(PolygonMesh::create(mesh.positions(), mesh.connectivity()->offsets, corners));
        for (const OperatorInfo* info : operators()) {
            const SparseMatrix s = get(build_operator(mesh, {info->id, {}})).stiffness;
            EXPECT_LE(difference(get(build_operator(flipped, {info->id, {}})).stiffness, s),
                      rounding_of(mesh, bounding_size(mesh), largest(s)) * largest(s))
                << name << ", " << info->id;
        }
    }
}

// The definitions, face by face, by singular values and by looking at all triangulations.
TEST(Operators, EqualTheirPlainDefinitions) {
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

TEST(Operators, AThousandCorners) {
    const auto mesh = make_face(regular_polygon(1000));
    for (const OperatorInfo* info : operators()) {
        const auto m = get(build_operator(mesh, {info->id, {}}));
        const double scale = m.stiffness.diagonal().maxCoeff();
        const double area = 500 * std::sin(2 * 3.14159265358979323846 / 1000);
        EXPECT_NEAR(m.mass.sum(), area, 1e-12);
        EXPECT_LE(asymmetry(mesh, m.stiffness), 1e-13 * scale);
        EXPECT_LE(constants(mesh, m.stiffness), 1e-11 * scale);
        for (const int k : {0, 1}) {
            const Vector x = mesh.positions().col(k);
            EXPECT_NEAR(x.dot(m.stiffness * x), area, 1e-9 * area) << info->id;
        }
    }
}

// --- figures of λ = 0 ---

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

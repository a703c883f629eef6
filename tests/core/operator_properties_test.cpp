// Every line of the operator table, at all its choices, several values of its parameters and random weights of
// vertices, on the whole zoo. Nothing here knows an operator.

#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include "operator_cases.hpp"
#include "polylap/mesh/shapes.hpp"

namespace polylap::test {
namespace {

// Refusals are few: only faces that no corner sees whole, where the choice asks for one, and meshes without
// orientation, where the sides of edges matter.
TEST(Operators, BuildNearlyEverywhere) {
    int refused = 0;
    int built = 0;
    for (const Specimen& s : zoo()) {
        for (const OperatorSpec& spec : all_specs(s.mesh)) {
            const bool ok = try_build(s.mesh, spec).has_value();
            ++(ok ? built : refused);
            const bool star = s.name.find("star") != std::string::npos;
            EXPECT_TRUE(ok || star || !is_oriented(s.mesh)) << spec_name(spec) << " on " << s.name;
        }
    }
    EXPECT_LE(refused, built / 100);
    EXPECT_GE(built, 1000);
}

TEST(Operators, HaveTheShapeOfTheMesh) {
    for_all([](const Specimen& s, const OperatorSpec&, const OperatorMatrices& m, double scale) {
        EXPECT_EQ(m.stiffness.rows(), s.mesh.vertex_count());
        EXPECT_EQ(m.stiffness.cols(), s.mesh.vertex_count());
        EXPECT_EQ(m.mass.rows(), s.mesh.vertex_count());
        EXPECT_EQ(m.mass.cols(), s.mesh.vertex_count());
        EXPECT_TRUE(std::isfinite(largest(m.stiffness)));
        EXPECT_TRUE(std::isfinite(largest(m.mass)));
        EXPECT_GT(scale, 0);
    });
}

// Symmetric, and nothing at vertices in no face: there S has no row either.
TEST(Operators, MassIsSymmetricAndOfTheFaces) {
    for_all([](const Specimen& s, const OperatorSpec&, const OperatorMatrices& m, double) {
        const Topology topology = build_topology(*s.mesh.connectivity());
        EXPECT_LE(difference(m.mass, m.mass.transpose()), 1e-15 * largest(m.mass));
        EXPECT_GT(m.mass.sum(), 0);
        for (const Index v : topology.unreferenced) {
            EXPECT_EQ(Vector(m.mass.col(v)).norm(), 0) << v;
            EXPECT_EQ(Vector(m.stiffness.col(v)).norm() + Vector(m.stiffness.transpose().col(v)).norm(), 0) << v;
        }
    });
}

/// A copy without ties between triangulations: its vertices move by about a hundredth of the shortest edge.
PolygonMesh without_ties(const PolygonMesh& mesh) {
    double shortest = bounding_size(mesh);
    for (const Edge& e : build_topology(*mesh.connectivity()).edges) {
        shortest = std::min(shortest, (mesh.position(e.v1) - mesh.position(e.v0)).norm());
    }
    std::mt19937 random(3);
    Points moved = mesh.positions();
    for (double& x : moved.reshaped()) {
        x += 0.02 * shortest * (static_cast<double>(random()) / 4294967296.0 - 0.5);
    }
    return get(mesh.with_positions(moved));
}

/// Calls `visit(mesh, spec, matrices)` for everything that can be built on copies without ties.
template <class Visit>
void for_all_without_ties(Visit&& visit) {
    for (const Specimen& s : zoo()) {
        if (s.mesh.vertex_count() > 330) continue;
        const PolygonMesh mesh = without_ties(s.mesh);
        for (const OperatorSpec& spec : all_specs(mesh)) {
            SCOPED_TRACE(spec_name(spec) + " on " + s.name);
            if (const auto matrices = try_build(mesh, spec); matrices) visit(mesh, spec, *matrices);
        }
    }
}

TEST(Operators, IgnoreRigidMotions) {
    const Eigen::Matrix3d rotation =
        (Eigen::AngleAxisd(0.9, Vector3(1, -2, 0.5).normalized()) * Eigen::AngleAxisd(2.1, Vector3::UnitY()))
            .toRotationMatrix();
    for_all_without_ties([&](const PolygonMesh& mesh, const OperatorSpec& spec, const OperatorMatrices& m) {
        const double scale = largest(m.stiffness);
        const double size = bounding_size(mesh);
        for (const double far : {0.0, 3.0, 1e4}) {
            const Points moved =
                (mesh.positions() * rotation.transpose()).rowwise() + far * size * Eigen::RowVector3d(0.3, -0.9, 0.4);
            const auto there = get(build_operator(get(mesh.with_positions(moved)), spec));
            const double tolerance = rounding_of(mesh, size * (1 + far), scale);
            EXPECT_LE(difference(there.stiffness, m.stiffness), tolerance * scale) << far;
            EXPECT_LE(difference(there.mass, m.mass), tolerance * largest(m.mass)) << far;
        }
    });
}

// S has no unit, M goes with the square of the scale and so do weights of vertices, without any absolute threshold in
// between. 1e±60: products of four lengths, as in tests for cocircular corners, still fit a double.
TEST(Operators, ScaleWithTheMesh) {
    for_all_without_ties([](const PolygonMesh& mesh, const OperatorSpec& spec, const OperatorMatrices& m) {
        const double scale = largest(m.stiffness);
        for (const double factor : {1e-60, 1e-12, 1e-3, 1e3, 1e12, 1e60}) {
            OperatorSpec there = spec;
            for (double& w : there.vertex_weights) {
                w *= factor * factor;
            }
            const auto scaled = get(build_operator(get(mesh.with_positions(factor * mesh.positions())), there));
            const double tolerance = rounding_of(mesh, bounding_size(mesh), scale);
            EXPECT_LE(difference(scaled.stiffness, m.stiffness), tolerance * scale) << factor;
            EXPECT_LE(difference(scaled.mass / factor / factor, m.mass), tolerance * largest(m.mass)) << factor;
        }
    });
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
            OperatorSpec renamed_spec = spec;
            for (std::size_t v = 0; v < spec.vertex_weights.size(); ++v) {
                renamed_spec.vertex_weights[static_cast<std::size_t>(p.indices()[static_cast<Eigen::Index>(v)])] =
                    spec.vertex_weights[v];
            }
            const auto there = get(build_operator(renamed, renamed_spec));
            const SparseMatrix stiffness = p * m.stiffness * p.transpose();
            const SparseMatrix mass = p * m.mass * p.transpose();
            EXPECT_LE(difference(there.stiffness, stiffness), 1e-13 * scale);
            EXPECT_LE(difference(there.mass, mass), 1e-13 * largest(m.mass));
        },
        330);
}

/// The initial values of every operator, and the same with random weights of vertices where it takes them.
std::vector<OperatorSpec> initial_specs(const PolygonMesh& mesh) {
    std::vector<OperatorSpec> specs;
    for (const OperatorInfo* info : operators()) {
        specs.push_back(get(complete_spec({info->id, {}})));
        if (!info->takes_vertex_weights) continue;
        specs.push_back(specs.back());
        specs.back().vertex_weights = random_weights(mesh, 7);
    }
    return specs;
}

void expect_same_stiffness(const PolygonMesh& mesh, const PolygonMesh& other, const std::string& name) {
    for (const OperatorSpec& spec : initial_specs(mesh)) {
        const auto before = try_build(mesh, spec);
        const auto after = try_build(other, spec);
        if (!before || !after) continue;
        const SparseMatrix& s = before->stiffness;
        EXPECT_LE(difference(after->stiffness, s), rounding_of(mesh, bounding_size(mesh), largest(s)) * largest(s))
            << name << ", " << spec_name(spec);
    }
}

TEST(Operators, DoNotMindWhereAFaceBegins) {
    for (const auto& [name, tied] : zoo()) {
        const PolygonMesh mesh = without_ties(tied);
        std::vector<Index> corners;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            std::vector<Index> face(mesh.face(f).begin(), mesh.face(f).end());
            std::rotate(face.begin(), face.begin() + 1 + f % static_cast<Index>(face.size() - 1), face.end());
            corners.insert(corners.end(), face.begin(), face.end());
        }
        expect_same_stiffness(mesh, get(PolygonMesh::create(mesh.positions(), mesh.connectivity()->offsets, corners)),
                              name);
    }
}

// A sum over faces does not mind which way a face runs.
TEST(Operators, DoNotMindTheOrientationOfFaces) {
    for (const auto& [name, tied] : zoo()) {
        const PolygonMesh mesh = without_ties(tied);
        std::vector<Index> corners;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            std::vector<Index> face(mesh.face(f).begin(), mesh.face(f).end());
            if (f % 3 == 0) std::reverse(face.begin(), face.end());
            corners.insert(corners.end(), face.begin(), face.end());
        }
        expect_same_stiffness(mesh, get(PolygonMesh::create(mesh.positions(), mesh.connectivity()->offsets, corners)),
                              name);
    }
}

TEST(Operators, AThousandCorners) {
    const auto mesh = make_face(regular_polygon(1000));
    for (const OperatorSpec& spec : initial_specs(mesh)) {
        const auto m = get(build_operator(mesh, spec));
        EXPECT_TRUE(std::isfinite(largest(m.stiffness))) << spec_name(spec);
        EXPECT_EQ(m.stiffness.rows(), 1000);
        EXPECT_NEAR(m.mass.sum(), 500 * std::sin(2 * 3.14159265358979323846 / 1000), 1e-12) << spec_name(spec);
    }
}

}  // namespace
}  // namespace polylap::test

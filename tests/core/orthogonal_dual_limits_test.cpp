// What the orthogonal dual follows and what it refuses, and the operator made of it.

#include "polylap/operators/orthogonal_dual.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "polylap/apply/noise.hpp"
#include "polylap/mesh/shapes.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

TEST(OrthogonalDual, FollowsMotionsAndSize) {
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.9, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
    for (const char* name : {"saddle-7", "hexagon-sphere-2", "torus-10x7-noisy", "two-components", "grid-8x8-skew"}) {
        const PolygonMesh& mesh = specimen(name);
        const OrthogonalDual dual = get(orthogonal_dual(mesh));
        const double size = bounding_size(mesh);
        for (const double factor : {1e-60, 1e-6, 1.0, 1e6, 1e60}) {
            const Eigen::RowVector3d offset(1, -2, 3);
            const Points moved = factor * ((mesh.positions() * rotation.transpose()).rowwise() + offset);
            const OrthogonalDual there = get(orthogonal_dual(get(mesh.with_positions(moved))));
            const Points expected = (dual.vertices * rotation.transpose()).rowwise() + offset;
            EXPECT_LE((there.vertices / factor - expected).cwiseAbs().maxCoeff(), 1e-9 * size)
                << name << " × " << factor;
            EXPECT_EQ(there.rank, dual.rank) << name << " × " << factor;
            EXPECT_NEAR(there.largest_shift, dual.largest_shift, 1e-8);
        }
    }
}

TEST(OrthogonalDual, FollowsTheLabelsOfFacesAndVertices) {
    for (const char* name : {"saddle-7", "hexagon-sphere-2", "torus-10x7-noisy"}) {
        const PolygonMesh& mesh = specimen(name);
        const Index count = mesh.vertex_count();
        Points positions(count, 3);
        std::vector<std::vector<Index>> faces;
        for (Index v = 0; v < count; ++v) {
            positions.row(count - 1 - v) = mesh.positions().row(v);
        }
        std::vector<Index> offsets{0};
        std::vector<Index> corners;
        for (Index f = mesh.face_count() - 1; f >= 0; --f) {
            for (const Index v : mesh.face(f)) {
                corners.push_back(count - 1 - v);
            }
            offsets.push_back(static_cast<Index>(corners.size()));
        }
        const OrthogonalDual there = get(orthogonal_dual(get(PolygonMesh::create(positions, offsets, corners))));
        const OrthogonalDual dual = get(orthogonal_dual(mesh));
        EXPECT_LE((there.vertices.colwise().reverse() - dual.vertices).cwiseAbs().maxCoeff(), 1e-9) << name;
        EXPECT_EQ(there.rank, dual.rank) << name;
    }
}

TEST(OrthogonalDual, IsDeterministic) {
    const auto mesh = get(add_normal_noise(get(make_torus(30, 15)), 0.2, 1));
    const OrthogonalDual a = get(orthogonal_dual(mesh));
    const OrthogonalDual b = get(orthogonal_dual(mesh));
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.rank, b.rank);
    EXPECT_EQ(a.residual, b.residual);
}

template <class T>
void expect_refused(const Result<T>& result, ErrorCode code, std::int64_t element, const char* words) {
    ASSERT_FALSE(result.ok()) << words;
    EXPECT_EQ(result.error().code, code) << result.error().message;
    EXPECT_EQ(result.error().element, element) << result.error().message;
    EXPECT_NE(result.error().message.find(words), std::string::npos) << result.error().message;
}

TEST(OrthogonalDual, RefusesWhatHasNoTwoSides) {
    const PolygonMesh& book = specimen("three-quads-on-an-edge");
    expect_refused(orthogonal_dual(book), ErrorCode::non_manifold_edge, 0, "edge 0–1 has 3 faces");
    expect_refused(orthogonal_dual_stiffness(book), ErrorCode::non_manifold_edge, 0, "edge 0–1");
    const auto flipped = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}});
    expect_refused(orthogonal_dual(flipped), ErrorCode::non_manifold_edge, 1, "edge 0–2 have opposite orientation");
    const auto moebius = orthogonal_dual(specimen("moebius"));
    ASSERT_FALSE(moebius.ok());
    EXPECT_EQ(moebius.error().code, ErrorCode::non_manifold_edge);
}

TEST(OrthogonalDual, RefusesDegenerateFaces) {
    const auto line = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 3, 1}});
    expect_refused(orthogonal_dual(line), ErrorCode::degenerate_face, 1, "face 1");
    const auto no_length = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}});
    expect_refused(orthogonal_dual(no_length), ErrorCode::degenerate_face, 0, "edge 2–3 has no length");
}

TEST(OrthogonalDual, RefusesParametersOutOfRange) {
    for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        expect_refused(orthogonal_dual(specimen("grid-2x2"), {.mu = bad}), ErrorCode::parameter_out_of_range, -1, "mu");
    }
}

TEST(OrthogonalDual, TicksAndCancels) {
    const auto mesh = get(add_normal_noise(get(make_torus(60, 40)), 0.2, 2));
    Ticks all;
    get(orthogonal_dual(mesh, {}, all.monitor()));
    EXPECT_TRUE(all.rise());
    ASSERT_GE(all.fractions.size(), 8u);
    for (std::size_t stop = 1; stop <= all.fractions.size(); ++stop) {
        Ticks some;
        some.stop_at = stop;
        const auto result = orthogonal_dual(mesh, {}, some.monitor());
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.error().code, ErrorCode::cancelled);
        EXPECT_EQ(some.fractions.size(), stop);
    }
}

TEST(OrthogonalDualOperator, HasTheWeightsOfTheDual) {
    const PolygonMesh& mesh = specimen("grid-8x8-skew");
    for (const double mu : {0.0, 3.0}) {
        const SparseMatrix s = get(orthogonal_dual_stiffness(mesh, {.mu = mu}));
        double trace = 0;
        for (const DualEdge& e : get(orthogonal_dual(mesh, {.mu = mu})).edges) {
            EXPECT_EQ(s.coeff(e.v0, e.v1), -e.weight);
            EXPECT_EQ(s.coeff(e.v1, e.v0), -e.weight);
            trace += 2 * e.weight;
        }
        EXPECT_NEAR(s.diagonal().sum(), trace, 1e-11 * std::abs(trace));
    }
}

// Exactly where the dual is; the compromise is not, which is why the operator has no such parameter.
TEST(OrthogonalDualOperator, IsLinearlyPreciseWhereTheDualIsOrthogonal) {
    int looked = 0;
    for (const auto& [name, mesh] : oriented_zoo()) {
        const SparseMatrix s = get(orthogonal_dual_stiffness(mesh));
        const Points sx = s * mesh.positions();
        for (const Index v : flat_inner_vertices(mesh)) {
            ++looked;
            EXPECT_LE(sx.row(v).norm(), 1e-11 * s.diagonal().cwiseAbs().maxCoeff()) << name << ", vertex " << v;
        }
    }
    EXPECT_GE(looked, 100);
    const PolygonMesh& skew = specimen("grid-8x8-skew");
    const Points sx = get(orthogonal_dual_stiffness(skew, {.mu = 1})) * skew.positions();
    double worst = 0;
    for (const Index v : flat_inner_vertices(skew)) {
        worst = std::max(worst, sx.row(v).norm());
    }
    EXPECT_GT(worst, 1e-3);
}

}  // namespace
}  // namespace polylap::test

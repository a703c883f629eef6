#include "polylap/apply/diagnostics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "polylap/mesh/shapes.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

SparseMatrix sparse(const Matrix& dense) {
    return dense.sparseView();
}
Topology topology_of(const PolygonMesh& mesh) {
    return build_topology(*mesh.connectivity());
}

TEST(Weights, AreCountedInOrderedPairs) {
    Matrix s(4, 4);
    s << 3, 0.5, -2, -1.5,  //
        0.5, 2, -2.5, 0,    //
        -2, -2.5, 4, 0.25,  //
        -1.5, 0, 0.25, 1.25;
    const WeightSummary w = summarise_weights(sparse(s));
    EXPECT_EQ(w.negative_ordered, 4);
    EXPECT_EQ(w.nonzero_ordered, 10);
    EXPECT_EQ(w.smallest, -0.5);
    EXPECT_EQ(w.largest, 2.5);
    ASSERT_EQ(w.negative.size(), 2u);
    EXPECT_EQ(std::tuple(w.negative[0].i, w.negative[0].j, w.negative[0].value), std::tuple(0, 1, -0.5));
    EXPECT_EQ(std::tuple(w.negative[1].i, w.negative[1].j, w.negative[1].value), std::tuple(2, 3, -0.25));
}

TEST(Weights, RoundingHasNoSign) {
    for (const double scale : {1e-200, 1.0, 1e200}) {
        Matrix s = Matrix::Zero(3, 3);
        s.diagonal() << 1, 2, 4;  // the tolerance is 4e-10
        s(0, 1) = s(1, 0) = 3.9e-10;
        s(1, 2) = s(2, 1) = 4.1e-10;
        s(0, 2) = s(2, 0) = -3.9e-10;
        const WeightSummary w = summarise_weights(sparse(scale * s));
        EXPECT_EQ(w.negative_ordered, 2) << scale;
        EXPECT_EQ(w.nonzero_ordered, 2) << scale;
        ASSERT_EQ(w.negative.size(), 1u);
        EXPECT_EQ(w.negative[0].i, 1);
    }
}

TEST(Weights, OfAPairThatDisagreesTheSmallerCounts) {
    Matrix s = Matrix::Identity(3, 3);
    s(0, 1) = 0.25;
    s(1, 0) = 0.5;
    s(2, 1) = 0.125;  // the other way round it is positive
    s(1, 2) = -0.125;
    const WeightSummary w = summarise_weights(sparse(s));
    EXPECT_EQ(w.negative_ordered, 3);
    ASSERT_EQ(w.negative.size(), 2u);
    EXPECT_EQ(w.negative[0].value, -0.5);
    EXPECT_EQ(std::pair(w.negative[1].i, w.negative[1].j), std::pair(1, 2));
    EXPECT_EQ(w.negative[1].value, -0.125);
}

TEST(Weights, OfDiagonalAndEmptyMatrices) {
    for (const SparseMatrix& s : {sparse(Matrix::Identity(3, 3)), SparseMatrix(2, 2), SparseMatrix(0, 0)}) {
        const WeightSummary w = summarise_weights(s);
        EXPECT_EQ(w.negative_ordered, 0);
        EXPECT_EQ(w.nonzero_ordered, 0);
        EXPECT_EQ(w.smallest, 0);
        EXPECT_TRUE(w.negative.empty());
    }
}

TEST(Weights, AgreeWithTheMatrixOnTheZoo) {
    for (const auto& [name, mesh] : zoo()) {
        for (const OperatorInfo* info : operators()) {
            const auto built = build_operator(mesh, {info->id, {}});
            if (!built) continue;  // not for this mesh
            const SparseMatrix& s = built->stiffness;
            const double zero = weight_tolerance * s.diagonal().maxCoeff();
            Index negative = 0;
            Index all = 0;
            for (Index i = 0; i < s.rows(); ++i) {
                for (Index j = 0; j < s.cols(); ++j) {
                    if (i == j || mesh.vertex_count() > 90) continue;
                    const double x = s.coeff(i, j);
                    negative += x > zero ? 1 : 0;
                    all += std::abs(x) > zero ? 1 : 0;
                }
            }
            const WeightSummary w = summarise_weights(s);
            if (mesh.vertex_count() <= 90) {
                EXPECT_EQ(w.negative_ordered, negative) << name;
                EXPECT_EQ(w.nonzero_ordered, all) << name;
            }
            EXPECT_EQ(2 * static_cast<Index>(w.negative.size()), w.negative_ordered) << name;
            EXPECT_TRUE(std::is_sorted(w.negative.begin(), w.negative.end(), [](const Weight& a, const Weight& b) {
                return std::pair(a.i, a.j) < std::pair(b.i, b.j);
            }));
            for (const Weight& pair : w.negative) {
                EXPECT_LT(pair.i, pair.j);
                EXPECT_EQ(pair.value, std::min(-s.coeff(pair.i, pair.j), -s.coeff(pair.j, pair.i)));
            }
        }
    }
}

TEST(Shape, OfFlatMeshes) {
    const auto grid = get(make_grid(4, 2, 2, 3));
    const ShapeMeasures m = measure_shape(grid, topology_of(grid));
    EXPECT_NEAR(m.area, 6, 1e-14);
    EXPECT_EQ(m.mean_non_planarity, 0);
    // 3 · 4 edges of length ½ and 5 · 2 of length 1.5.
    EXPECT_NEAR(m.mean_squared_edge, (12 * 0.25 + 10 * 2.25) / 22, 1e-15);
}

// Corners of the quad (0,0,0), (1,0,h), (1,1,0), (0,1,h) lie h/2 above and below the plane z = h/2, and |a| = 1.
TEST(Shape, NonPlanarityOfTheSaddleQuad) {
    for (const double h : {0.1, 1.0}) {
        for (const double scale : {1e-6, 1.0, 1e6}) {
            const Vector3 far(1e3 * scale, 0, 0);
            const auto quad = make_face(
                {far, far + scale * Vector3(1, 0, h), far + scale * Vector3(1, 1, 0), far + scale * Vector3(0, 1, h)});
            EXPECT_NEAR(measure_shape(quad, topology_of(quad)).mean_non_planarity, h / 2, 1e-12);
        }
    }
    // The mean over faces: the same quad beside a flat triangle.
    const auto both = make_mesh({{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}, {3, 3, 3}}, {{0, 1, 2, 3}, {0, 1, 4}});
    EXPECT_NEAR(measure_shape(both, topology_of(both)).mean_non_planarity, 0.25, 1e-14);
}

TEST(Shape, IsFiniteOnFacesWithoutArea) {
    const auto mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}},
                                {{0, 1, 2, 3}, {1, 4, 6, 5}});
    const ShapeMeasures m = measure_shape(mesh, topology_of(mesh));
    EXPECT_NEAR(m.area, 1, 1e-15);
    EXPECT_TRUE(std::isfinite(m.mean_non_planarity));
}

TEST(Volume, OfClosedMeshes) {
    const auto& cube = specimen("cube-3");
    EXPECT_NEAR(get(enclosed_volume(cube, topology_of(cube))), 1, 1e-13);
    const auto far = get(cube.with_positions(cube.positions().rowwise() + Eigen::RowVector3d(1e6, -3e6, 2e6)));
    EXPECT_NEAR(get(enclosed_volume(far, topology_of(far))), 1, 1e-8);
    const auto tetrahedron =
        make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
    EXPECT_NEAR(get(enclosed_volume(tetrahedron, topology_of(tetrahedron))), 1.0 / 6, 1e-16);
    const auto inside_out =
        make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}});
    EXPECT_NEAR(get(enclosed_volume(inside_out, topology_of(inside_out))), -1.0 / 6, 1e-16);
}

TEST(Volume, OnlyOfClosedOrientedMeshes) {
    const auto& grid = specimen("grid-2x2");
    const auto open = enclosed_volume(grid, topology_of(grid));
    ASSERT_FALSE(open.ok());
    EXPECT_EQ(open.error().code, ErrorCode::open_mesh);
    const auto edges = topology_of(grid).edges;
    ASSERT_GE(open.error().element, 0);
    const Edge& e = edges[static_cast<std::size_t>(open.error().element)];
    EXPECT_TRUE(e.boundary());
    EXPECT_NE(open.error().message.find(std::to_string(e.v0)), std::string::npos) << open.error().message;
    EXPECT_NE(open.error().message.find(std::to_string(e.v1)), std::string::npos) << open.error().message;

    const auto flipped =
        make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}});
    const auto disagree = enclosed_volume(flipped, topology_of(flipped));
    ASSERT_FALSE(disagree.ok());
    EXPECT_EQ(disagree.error().code, ErrorCode::non_manifold_edge);
    ASSERT_GE(disagree.error().element, 0);
    EXPECT_FALSE(topology_of(flipped).edges[static_cast<std::size_t>(disagree.error().element)].oriented());
}

}  // namespace
}  // namespace polylap::test

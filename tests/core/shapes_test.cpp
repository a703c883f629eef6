#include "polylap/mesh/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "polylap/apply/diagnostics.hpp"
#include "polylap/apply/noise.hpp"
#include "polylap/face/vector_area.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class T>
void expect_bad_argument(const Result<T>& result, const char* what) {
    ASSERT_FALSE(result.ok()) << what;
    EXPECT_EQ(result.error().code, ErrorCode::bad_argument) << what;
    EXPECT_FALSE(result.error().message.empty()) << what;
}

TEST(Shapes, Grid) {
    const auto grid = get(make_grid(4, 3, 2, 6));
    EXPECT_EQ(grid.vertex_count(), 20);
    EXPECT_EQ(grid.face_count(), 12);
    EXPECT_EQ(grid.position(1 * 5 + 3), Vector3(1.5, 2, 0));  // vertex (3, 1)
    for (Index f = 0; f < grid.face_count(); ++f) {
        std::vector<Vector3> corners;
        gather_corners(grid, f, corners);
        EXPECT_NEAR((vector_area(corners) - Vector3(0, 0, 1)).norm(), 0, 1e-14);
    }
    EXPECT_EQ(get(make_grid(1, 1)).face_count(), 1);
}

TEST(Shapes, Saddle) {
    const auto saddle = get(make_saddle(6, 0.8));
    EXPECT_EQ(saddle.vertex_count(), 49);
    for (Index v = 0; v < saddle.vertex_count(); ++v) {
        const Vector3 p = saddle.position(v);
        EXPECT_LE(p.head<2>().cwiseAbs().maxCoeff(), 0.5);
        EXPECT_NEAR(p.z(), 0.8 * 2 * (p.x() * p.x() - p.y() * p.y()), 1e-15);
    }
    EXPECT_NEAR(saddle.positions().col(2).maxCoeff(), 0.4, 1e-15);
    EXPECT_NEAR(saddle.positions().col(2).minCoeff(), -0.4, 1e-15);
}

TEST(Shapes, Torus) {
    const auto torus = get(make_torus(32, 16, 2, 0.5));
    EXPECT_EQ(torus.vertex_count(), 512);
    EXPECT_EQ(torus.face_count(), 512);
    const auto topology = build_topology(*torus.connectivity());
    EXPECT_EQ(topology.edges.size(), 1024u);
    EXPECT_TRUE(topology.boundary_vertices.empty());
    EXPECT_TRUE(find_issues(topology).empty());
    for (Index v = 0; v < torus.vertex_count(); ++v) {
        const Vector3 p = torus.position(v);
        EXPECT_NEAR(std::hypot(p.head<2>().norm() - 2, p.z()), 0.5, 1e-14);
    }
    // Vertex (i, j) is i · nv + j: a quarter turn is i = 8, the top of the tube j = 4.
    EXPECT_NEAR((torus.position(8 * 16 + 4) - Vector3(0, 2, 0.5)).norm(), 0, 1e-14);
    // Faces look outwards: the volume is positive, and near 2π² R r².
    const double volume = get(enclosed_volume(torus, topology));
    EXPECT_NEAR(volume, 2 * std::pow(std::numbers::pi, 2) * 2 * 0.25, 0.04 * volume);
}

TEST(Shapes, TheTorusIsTheReferenceOne) {
    const auto torus = get(make_torus(32, 16));
    const auto reference = load_mesh("quad-torus-32x16");
    EXPECT_EQ(torus.connectivity()->corners.size(), reference.connectivity()->corners.size());
    EXPECT_LE((torus.positions() - reference.positions()).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Shapes, RefuseWhatDoesNotFit) {
    expect_bad_argument(make_grid(0, 3), "no columns");
    expect_bad_argument(make_grid(3, -1), "negative rows");
    expect_bad_argument(make_grid(2, 2, 0), "no width");
    expect_bad_argument(make_grid(2, 2, 1, -1), "negative height");
    expect_bad_argument(make_grid(2, 2, nan), "nan");
    expect_bad_argument(make_grid(2, 2, 1, infinity), "infinite");
    expect_bad_argument(make_grid(1 << 20, 1 << 20), "too many vertices to number");
    expect_bad_argument(make_saddle(0), "no cells");
    expect_bad_argument(make_saddle(3, nan), "nan");
    expect_bad_argument(make_torus(2, 8), "two the long way");
    expect_bad_argument(make_torus(8, 2), "two the short way");
    expect_bad_argument(make_torus(8, 8, 1, 1), "a closed hole");
    expect_bad_argument(make_torus(8, 8, 1, 0), "no tube");
    expect_bad_argument(make_torus(8, 8, infinity, 1), "infinite");
    expect_bad_argument(make_torus(8, 8, 1, nan), "nan");
    expect_bad_argument(add_normal_noise(specimen("grid-2x2"), nan, 1), "nan");
    expect_bad_argument(add_normal_noise(specimen("grid-2x2"), infinity, 1), "infinite");
}

TEST(Noise, MovesAlongNormalsWithinItsAmplitude) {
    const auto grid = get(make_grid(10, 10));  // edges of length 0.1, normals z
    const auto noisy = get(add_normal_noise(grid, 0.5, 3));
    const Points moved = noisy.positions() - grid.positions();
    EXPECT_TRUE(moved.leftCols(2).isZero(0));
    EXPECT_LE(moved.col(2).cwiseAbs().maxCoeff(), 0.05 * (1 + 1e-12));
    // 121 draws from [-1, 1): they reach far out both ways, and their mean is small.
    EXPECT_GT(moved.col(2).maxCoeff(), 0.04);
    EXPECT_LT(moved.col(2).minCoeff(), -0.04);
    EXPECT_LT(std::abs(moved.col(2).mean()), 0.01);
    EXPECT_EQ(noisy.connectivity(), grid.connectivity());
}

TEST(Noise, TheSeedDecides) {
    const auto torus = get(make_torus(32, 16));
    const auto a = get(add_normal_noise(torus, 0.2, 7));
    EXPECT_EQ(a.positions(), get(add_normal_noise(torus, 0.2, 7)).positions());
    EXPECT_NE(a.positions(), get(add_normal_noise(torus, 0.2, 8)).positions());
    EXPECT_EQ(get(add_normal_noise(torus, 0, 7)).positions(), torus.positions());
}

// The C++ standard fixes what mt19937 returns: 5489, its default seed, starts 3499211612, 581869302, 3890346734,
// 3586334585, 545404204.
TEST(Noise, IsTheSameOnEveryPlatform) {
    const auto grid = get(make_grid(4, 1, 4, 1));
    const auto noisy = get(add_normal_noise(grid, 1, 5489));  // all edges have length 1
    const double raw[] = {3499211612, 581869302, 3890346734, 3586334585, 545404204};
    for (Index v = 0; v < 5; ++v) {
        EXPECT_NEAR(noisy.position(v).z(), raw[v] / 2147483648.0 - 1, 1e-15) << v;
    }
}

TEST(Noise, LeavesUnreferencedVertices) {
    const auto& mesh = specimen("unreferenced-vertices");
    const auto noisy = get(add_normal_noise(mesh, 0.5, 1));
    EXPECT_EQ(noisy.position(0), mesh.position(0));
    EXPECT_EQ(noisy.position(4), mesh.position(4));
    EXPECT_NE(noisy.position(1), mesh.position(1));
}

// The first view of the page: each of the 512 quads of the noisy torus gives both diagonals a negative weight, and the
// planar operator none.
TEST(Noise, TheNoisyTorusReads2048And0) {
    for (const std::uint32_t seed : {1U, 7U, 42U}) {
        const auto torus = get(add_normal_noise(get(make_torus(32, 16)), 0.1, seed));
        const auto count = [&](const char* id) {
            return summarise_weights(get(build_operator(torus, {id, {}})).stiffness).negative_ordered;
        };
        EXPECT_EQ(count("alexa-wardetzky"), 2048) << seed;
        EXPECT_EQ(count("planar"), 0) << seed;
    }
}

}  // namespace
}  // namespace polylap::test

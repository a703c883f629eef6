#include "polylap/apply/display.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include <Eigen/Dense>

#include "polylap/face/vector_area.hpp"
#include "polylap/mesh/shapes.hpp"
#include "polylap/operators/planar.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

Vector3 area_of(const PolygonMesh& mesh, const std::array<Index, 3>& t) {
    return vector_area(std::vector<Vector3>{mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])});
}

TEST(DisplayTriangles, FillEachFaceInTurn) {
    for (const auto& [name, mesh] : zoo()) {
        const DisplayTriangles display = get(triangulate_for_display(mesh));
        ASSERT_EQ(display.triangles.size(), display.edges.size());
        ASSERT_EQ(display.triangles.size(), display.face.size());
        std::size_t t = 0;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            const auto face = mesh.face(f);
            std::vector<Vector3> corners;
            gather_corners(mesh, f, corners);
            const Vector3 a = vector_area(corners);
            Vector3 sum = Vector3::Zero();
            std::map<std::pair<Index, Index>, int> marked;
            for (std::size_t k = 0; k + 2 < face.size(); ++k, ++t) {
                ASSERT_EQ(display.face[t], f) << name;
                const auto& triangle = display.triangles[t];
                EXPECT_GT(area_of(mesh, triangle).dot(a), 0) << name << ": turned away from its face";
                sum += area_of(mesh, triangle);
                EXPECT_LT(display.edges[t], 8);
                for (std::size_t side = 0; side < 3; ++side) {
                    if ((display.edges[t] >> side & 1) != 0) ++marked[{triangle[side], triangle[(side + 1) % 3]}];
                }
            }
            EXPECT_LE((sum - a).norm(), 1e-12 * a.norm()) << name;
            ASSERT_EQ(marked.size(), face.size()) << name;
            for (std::size_t k = 0; k < face.size(); ++k) {
                EXPECT_EQ((marked[{face[k], face[(k + 1) % face.size()]}]), 1) << name;
            }
        }
        EXPECT_EQ(t, display.triangles.size());
    }
}

TEST(DisplayTriangles, AreThePlanarOperators) {
    // The picture's diagonals are exactly those that the operator cuts along: cotan of the display triangles,
    // projected, is its matrix.
    const auto& mesh = specimen("wavy-7");
    std::vector<Vector3> corners;
    gather_corners(mesh, 0, corners);
    Projection projection;
    ASSERT_TRUE(project_maximally(corners, projection));
    std::vector<Triangle> triangles;
    check(triangulate_polygon(projection.points, TriangulationRule::delaunay, triangles));
    const auto key = [](std::array<Index, 3> t) {
        std::sort(t.begin(), t.end());
        return t;
    };
    std::vector<std::array<Index, 3>> a;
    std::vector<std::array<Index, 3>> b;
    const DisplayTriangles display = get(triangulate_for_display(mesh));
    for (const auto& t : display.triangles) {
        a.push_back(key(t));
    }
    for (const auto& t : triangles) {
        b.push_back(key(t));
    }
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    EXPECT_EQ(a, b);
}

TEST(DisplayTriangles, CanBeCancelled) {
    const PolygonMesh mesh = get(make_grid(80, 80));
    Ticks all;
    ASSERT_TRUE(triangulate_for_display(mesh, all.monitor()).ok());
    EXPECT_GT(all.fractions.size(), 3u);
    EXPECT_TRUE(all.rise());
    for (const std::size_t at : {std::size_t{1}, std::size_t{2}, all.fractions.size()}) {
        Ticks some{.fractions = {}, .stop_at = at};
        const auto cancelled = triangulate_for_display(mesh, some.monitor());
        ASSERT_FALSE(cancelled.ok());
        EXPECT_EQ(cancelled.error().code, ErrorCode::cancelled);
        EXPECT_EQ(some.fractions.size(), at);
    }
}

TEST(DisplayTriangles, FacesThatCannotBeCutGetAFan) {
    const auto mesh =
        make_mesh({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {4, 0, 0}, {1, 1, 0}, {3, 1.5, 0}, {5, 0, 0}},
                  {{0, 1, 2, 3}, {0, 4, 5, 6}, {0, 2, 4, 7}, {0, 2, 1}});
    const DisplayTriangles display = get(triangulate_for_display(mesh));
    EXPECT_EQ(display.face, (std::vector<Index>{0, 0, 1, 1, 2, 2, 3}));
    EXPECT_EQ(display.triangles[0], (std::array<Index, 3>{0, 1, 2}));
    EXPECT_EQ(display.triangles[1], (std::array<Index, 3>{0, 2, 3}));
    EXPECT_EQ(display.edges[0], 3);
    EXPECT_EQ(display.edges[1], 6);
}

/// Both points lie in one display triangle of some face, up to rounding.
bool on_surface(const PolygonMesh& mesh, const DisplayTriangles& display, const Vector3& p, const Vector3& q) {
    for (const auto& t : display.triangles) {
        Eigen::Matrix<double, 3, 2> frame;
        frame << mesh.position(t[1]) - mesh.position(t[0]), mesh.position(t[2]) - mesh.position(t[0]);
        bool both = true;
        for (const Vector3& x : {p, q}) {
            const Eigen::Vector2d b = frame.colPivHouseholderQr().solve(x - mesh.position(t[0]));
            const double off = (frame * b - (x - mesh.position(t[0]))).norm();
            both = both && off < 1e-9 && b.minCoeff() > -1e-9 && b.sum() < 1 + 1e-9;
        }
        if (both) return true;
    }
    return false;
}

TEST(Draping, LaysChainsOnTheSurface) {
    int bent = 0;
    for (const char* name : {"saddle-7", "torus-10x7-noisy", "wavy-8", "regular-6", "three-quads-on-an-edge"}) {
        const auto& mesh = specimen(name);
        const auto display = get(triangulate_for_display(mesh));
        std::vector<Weight> pairs;
        for (Index f = 0; f < mesh.face_count(); f += 5) {  // every pair of corners, edges included
            const auto face = mesh.face(f);
            for (std::size_t i = 0; i < face.size(); ++i) {
                for (std::size_t j = i + 1; j < face.size(); ++j) {
                    pairs.push_back({std::min(face[i], face[j]), std::max(face[i], face[j]), -1});
                }
            }
        }
        const SurfaceLines lines = drape_pairs(mesh, display, pairs);
        ASSERT_EQ(lines.segments.size(), lines.start.size());
        ASSERT_EQ(lines.segments.size(), lines.pair.size());
        std::vector<char> drawn(pairs.size(), 0);
        for (std::size_t k = 0; k < lines.segments.size();) {
            const auto p = static_cast<std::size_t>(lines.pair[k]);
            ASSERT_EQ(std::exchange(drawn[p], 1), 0) << name << ": pair " << p << " has two lines";
            Vector3 at = mesh.position(pairs[p].i);
            double length = 0;
            const std::size_t first = k;
            for (; k < lines.segments.size() && lines.pair[k] == static_cast<Index>(p); ++k) {
                const auto& [from, to] = lines.segments[k];
                EXPECT_LE((from - at).norm(), 1e-12) << name << ": a gap";
                EXPECT_NEAR(lines.start[k], length, 1e-12) << name;
                EXPECT_TRUE(on_surface(mesh, display, from, to)) << name << ": " << pairs[p].i << "–" << pairs[p].j;
                length += (to - from).norm();
                at = to;
            }
            EXPECT_LE((at - mesh.position(pairs[p].j)).norm(), 1e-12) << name;
            EXPECT_GE(length, (mesh.position(pairs[p].j) - mesh.position(pairs[p].i)).norm() * (1 - 1e-12));
            bent += k - first > 1 ? 1 : 0;
        }
        EXPECT_EQ(std::count(drawn.begin(), drawn.end(), 1), static_cast<std::ptrdiff_t>(pairs.size())) << name;
    }
    EXPECT_GT(bent, 10);
}

// A face of n corners has up to n² negative pairs, each across up to n triangles: too much to draw, so an even choice
// is.
TEST(Draping, StopsWithAnEvenChoiceOfWholeLines) {
    const PolygonMesh mesh = make_face(regular_polygon(1000));
    const auto negative = summarise_weights(get(build_operator(mesh, {"alexa-wardetzky", {1}})).stiffness).negative;
    ASSERT_GT(negative.size(), 200'000u);
    constexpr std::size_t most = 20'000;
    const SurfaceLines lines = drape_pairs(mesh, get(triangulate_for_display(mesh)), negative, most);
    EXPECT_GE(lines.segments.size(), most);
    EXPECT_LT(lines.segments.size(), most + 1000);
    std::vector<Index> drawn;
    for (std::size_t k = 0; k < lines.pair.size(); ++k) {
        const Weight& pair = negative[static_cast<std::size_t>(lines.pair[k])];
        if (k == 0 || lines.pair[k] != lines.pair[k - 1]) {
            drawn.push_back(lines.pair[k]);
            EXPECT_EQ(lines.segments[k][0], mesh.position(pair.i));
        }
        if (k + 1 == lines.pair.size() || lines.pair[k] != lines.pair[k + 1]) {
            EXPECT_EQ(lines.segments[k][1], mesh.position(pair.j));
        }
    }
    std::sort(drawn.begin(), drawn.end());
    ASSERT_GT(drawn.size(), 20u);
    const double mean = static_cast<double>(negative.size()) / static_cast<double>(drawn.size());
    for (std::size_t k = 1; k < drawn.size(); ++k) {
        EXPECT_GT(drawn[k], drawn[k - 1]);
        EXPECT_LT(drawn[k] - drawn[k - 1], 3 * mean) << "a gap in the choice";
    }
}

TEST(Draping, PairsWithoutACommonFaceAreStraight) {
    const auto& grid = specimen("grid-2x2");
    const std::vector<Weight> pairs{{0, 8, -1}};
    const SurfaceLines lines = drape_pairs(grid, get(triangulate_for_display(grid)), pairs);
    ASSERT_EQ(lines.segments.size(), 1u);
    EXPECT_EQ(lines.segments[0][0], grid.position(0));
    EXPECT_EQ(lines.segments[0][1], grid.position(8));
    EXPECT_TRUE(drape_pairs(grid, get(triangulate_for_display(grid)), {}).segments.empty());
}

}  // namespace
}  // namespace polylap::test

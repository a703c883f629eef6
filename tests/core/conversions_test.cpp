#include "polylap/apply/conversions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "polylap/apply/diagnostics.hpp"
#include "polylap/apply/noise.hpp"
#include "polylap/face/vector_area.hpp"
#include "polylap/mesh/convert.hpp"
#include "polylap/mesh/shapes.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

int euler(const PolygonMesh& mesh) {
    const auto topology = build_topology(*mesh.connectivity());
    return mesh.vertex_count() - static_cast<int>(topology.edges.size()) + mesh.face_count() -
           static_cast<int>(topology.unreferenced.size());
}

int faces_of(const PolygonMesh& mesh, std::size_t corners) {
    int count = 0;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        count += mesh.face(f).size() == corners ? 1 : 0;
    }
    return count;
}

bool closed_manifold(const PolygonMesh& mesh) {
    const auto topology = build_topology(*mesh.connectivity());
    return topology.boundary_vertices.empty() && find_issues(topology).empty();
}

template <class T>
Error error_of(const Result<T>& result) {
    EXPECT_FALSE(result.ok());
    return result.ok() ? Error{} : result.error();
}

TEST(DualMesh, OfACubeIsAnOctahedron) {
    const auto dual = get(dual_mesh(get(make_shape("cube", Pairs{{"n", "1"}}))));
    EXPECT_EQ(dual.vertex_count(), 6);
    EXPECT_EQ(faces_of(dual, 3), 8);
    // Its corners are the middles of the cube's sides, its volume a sixth of the cube's, and it looks outwards.
    EXPECT_NEAR(get(enclosed_volume(dual, build_topology(*dual.connectivity()))), 1.0 / 6, 1e-15);
    for (Index v = 0; v < 6; ++v) {
        EXPECT_NEAR((dual.position(v) - Vector3::Constant(0.5)).norm(), 0.5, 1e-15);
    }
}

TEST(DualMesh, OfTheDualOfAClosedMeshHasTheCountsOfTheMesh) {
    for (const Specimen& s : zoo()) {
        if (!closed_manifold(s.mesh)) continue;
        SCOPED_TRACE(s.name);
        const auto dual = get(dual_mesh(s.mesh));
        EXPECT_EQ(dual.vertex_count(), s.mesh.face_count());
        EXPECT_EQ(dual.face_count(), s.mesh.vertex_count());
        EXPECT_EQ(euler(dual), euler(s.mesh));
        EXPECT_TRUE(closed_manifold(dual));
        const auto twice = get(dual_mesh(dual));
        ASSERT_EQ(twice.vertex_count(), s.mesh.vertex_count());
        for (Index f = 0; f < s.mesh.face_count(); ++f) {
            ASSERT_EQ(twice.face(f).size(), s.mesh.face(f).size());
        }
        // Vertex v of the mesh became face v of the dual and vertex v again.
        for (Index f = 0; f < s.mesh.face_count(); ++f) {
            for (const Index v : s.mesh.face(f)) {
                EXPECT_NE(std::find(twice.face(f).begin(), twice.face(f).end(), v), twice.face(f).end());
            }
        }
    }
}

TEST(DualMesh, LeavesTheBoundaryOut) {
    const auto dual = get(dual_mesh(get(make_grid(4, 3))));
    EXPECT_EQ(dual.vertex_count(), 12);
    EXPECT_EQ(dual.face_count(), 6);
    EXPECT_NEAR(total_area(dual), 0.75 * 2 / 3, 1e-15);
    std::vector<Vector3> corners;
    for (Index f = 0; f < dual.face_count(); ++f) {
        gather_corners(dual, f, corners);
        EXPECT_GT(vector_area(corners).z(), 0);
    }
    // Corners between two faces only bend an edge: they get no face.
    const auto tiles = get(dual_mesh(get(make_shape("tetris"))));
    EXPECT_TRUE(find_issues(build_topology(*tiles.connectivity())).empty());
}

TEST(DualMesh, RefusesWhatHasNone) {
    EXPECT_EQ(error_of(dual_mesh(make_face(regular_polygon(5)))).code, ErrorCode::bad_mesh);
    EXPECT_EQ(error_of(dual_mesh(get(make_grid(1, 5)))).code, ErrorCode::bad_mesh);
    // Two tetrahedra that share the vertex 0.
    const auto pinched =
        make_mesh({{0, 0, 0}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}, {1, 0, -1}, {-1, 1, -1}, {-1, -1, -1}},
                  {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}});
    const Error error = error_of(dual_mesh(pinched));
    EXPECT_EQ(error.code, ErrorCode::non_manifold_edge);
    EXPECT_EQ(error.element, 0);
    EXPECT_NE(error.message.find("vertex 0"), std::string::npos);
    // A closed surface with one side turned over.
    const auto turned =
        make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}});
    EXPECT_EQ(error_of(dual_mesh(turned)).code, ErrorCode::non_manifold_edge);
}

TEST(Quads, OnlyQuadsAndTheSameTopology) {
    for (const Specimen& s : zoo()) {
        SCOPED_TRACE(s.name);
        const auto edges = static_cast<Index>(build_topology(*s.mesh.connectivity()).edges.size());
        for (const auto rule : {SubdivisionRule::linear, SubdivisionRule::catmull_clark}) {
            const auto quads = subdivide_into_quads(s.mesh, rule);
            if (s.name == "three-quads-on-an-edge" && rule == SubdivisionRule::catmull_clark) {
                EXPECT_EQ(error_of(quads).code, ErrorCode::non_manifold_edge);
                continue;
            }
            ASSERT_TRUE(quads.ok()) << quads.error().message;
            EXPECT_EQ(quads->vertex_count(), s.mesh.vertex_count() + edges + s.mesh.face_count());
            EXPECT_EQ(faces_of(*quads, 4), static_cast<int>(s.mesh.connectivity()->corners.size()));
            EXPECT_EQ(quads->face_count(), faces_of(*quads, 4));
            EXPECT_EQ(euler(*quads), euler(s.mesh));
        }
    }
}

TEST(Quads, LinearKeepsPositionsAndArea) {
    const auto grid = get(make_shape("skew-grid"));
    const auto fine = get(subdivide_into_quads(grid));
    EXPECT_EQ(fine.positions().topRows(grid.vertex_count()), grid.positions());
    EXPECT_NEAR(total_area(fine), total_area(grid), 1e-14);
}

// By the paper's rules: face points are the middles of the sides; an edge point is a quarter of two corners and two
// face points; with n = 3 a corner goes to (Q + 2 R) / 3.
TEST(Quads, CatmullClarkOfACube) {
    const auto cube = get(make_shape("cube", Pairs{{"n", "1"}}));
    const auto fine = get(subdivide_into_quads(cube, SubdivisionRule::catmull_clark));
    const auto centred = [&](Index v) -> Vector3 { return 2 * (fine.position(v) - Vector3::Constant(0.5)); };
    for (Index v = 0; v < 8; ++v) {
        const Vector3 corner = 2 * (cube.position(v) - Vector3::Constant(0.5));
        EXPECT_NEAR((centred(v) - corner * 5 / 9).norm(), 0, 1e-15) << v;
    }
    for (Index e = 8; e < 20; ++e) {  // (±3/4, ±3/4, 0) in some order
        EXPECT_NEAR(centred(e).cwiseAbs().maxCoeff(), 0.75, 1e-15);
        EXPECT_NEAR(centred(e).norm(), 0.75 * std::sqrt(2), 1e-15);
    }
    for (Index f = 20; f < 26; ++f) {
        EXPECT_NEAR(centred(f).norm(), 1, 1e-15);
    }
}

TEST(Quads, CatmullClarkMakesASplineOfTheBoundary) {
    const auto square = make_face({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
    const auto fine = get(subdivide_into_quads(square, SubdivisionRule::catmull_clark));
    EXPECT_EQ(fine.position(0), Vector3(1, 1, 0));  // 3/4 of itself and 1/8 of both neighbours
    EXPECT_EQ(fine.position(4), Vector3(4, 0, 0));
    EXPECT_EQ(fine.position(8), Vector3(4, 4, 0));
    const auto& lonely = specimen("unreferenced-vertices");
    EXPECT_EQ(get(subdivide_into_quads(lonely, SubdivisionRule::catmull_clark)).position(0), lonely.position(0));
}

TEST(PairTriangles, MakesTheGridAgain) {
    const auto grid = get(make_grid(7, 5));
    const auto again = get(pair_triangles(get(triangulate_faces(grid))));
    EXPECT_EQ(faces_of(again, 4), 35);
    EXPECT_EQ(faces_of(again, 3), 0);
    EXPECT_NEAR(total_area(again), 1, 1e-14);
}

TEST(PairTriangles, LeavesFewTrianglesOnSpheres) {
    for (const char* level : {"1", "2", "3", "4"}) {
        const auto sphere = get(make_shape("ico-sphere", Pairs{{"level", level}}));
        const auto paired = get(pair_triangles(sphere));
        EXPECT_EQ(faces_of(paired, 4) * 2 + faces_of(paired, 3), sphere.face_count());
        EXPECT_LE(faces_of(paired, 3), sphere.face_count() / 100) << level;
        EXPECT_TRUE(closed_manifold(paired));
        EXPECT_EQ(euler(paired), 2);
        EXPECT_EQ(paired.positions(), sphere.positions());
        EXPECT_EQ(get(pair_triangles(sphere)).connectivity()->corners, paired.connectivity()->corners);
        EXPECT_GT(get(enclosed_volume(paired, build_topology(*paired.connectivity()))), 3);
    }
}

TEST(PairTriangles, TakesTheBetterPairAndNoConcaveOne) {
    // A square and a long triangle at its side: the diagonal of the square goes.
    const auto mesh =
        make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {4, 0.5, 0}}, {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}});
    const auto paired = get(pair_triangles(mesh));
    EXPECT_EQ(faces_of(paired, 4), 1);
    EXPECT_EQ(std::vector<Index>(paired.face(1).begin(), paired.face(1).end()), (std::vector<Index>{1, 4, 2}));
    // An arrowhead stays two triangles.
    const auto arrow = make_mesh({{0, 0, 0}, {2, 1, 0}, {0.5, 1, 0}, {0, 2, 0}}, {{0, 1, 2}, {1, 3, 2}});
    EXPECT_EQ(faces_of(get(pair_triangles(arrow)), 4), 0);
}

TEST(PairTriangles, KeepsAllElse) {
    const auto grid = get(make_grid(3, 3));
    EXPECT_EQ(get(pair_triangles(grid)).connectivity()->corners, grid.connectivity()->corners);
    // Neighbours of opposite orientation, and three on an edge, stay.
    const auto turned = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}});
    EXPECT_EQ(faces_of(get(pair_triangles(turned)), 3), 2);
    const auto fan =
        make_mesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 2, 1}, {0, 1, 3}, {0, 4, 1}});
    EXPECT_EQ(faces_of(get(pair_triangles(fan)), 3), 3);
}

TEST(Triangles, KeepTheAreaOfPlanarMeshes) {
    for (const Specimen& s : zoo()) {
        if (!planar_faces(s.mesh)) continue;
        SCOPED_TRACE(s.name);
        for (const auto rule :
             {TriangulationRule::delaunay, TriangulationRule::min_max_angle, TriangulationRule::shortest_diagonal}) {
            const auto triangles = get(triangulate_faces(s.mesh, rule));
            EXPECT_TRUE(only_triangles(triangles));
            EXPECT_NEAR(total_area(triangles), total_area(s.mesh), 1e-12 * total_area(s.mesh));
            EXPECT_EQ(euler(triangles), euler(s.mesh));
            EXPECT_EQ(triangles.positions(), s.mesh.positions());
        }
    }
}

TEST(Triangles, NameTheFaceThatCannotBeCut) {
    const auto bow =
        make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {3, 0, 0}, {3, 2, 0}, {2, 0.5, 0}, {4, 0.5, 0}},
                  {{0, 1, 2, 3}, {4, 5, 6, 7}});
    const Error crossing = error_of(triangulate_faces(bow));
    EXPECT_EQ(crossing.code, ErrorCode::degenerate_face);
    EXPECT_EQ(crossing.element, 1);
    EXPECT_NE(crossing.message.find("face 1"), std::string::npos);
    const Error flat = error_of(triangulate_faces(make_face({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}})));
    EXPECT_EQ(flat.code, ErrorCode::degenerate_face);
    EXPECT_EQ(flat.element, 0);
}

TEST(ConversionTable, DoesWhatTheFunctionsDo) {
    const auto& torus = specimen("torus-9x5");
    EXPECT_EQ(get(convert(torus, "dual")).positions(), get(dual_mesh(torus)).positions());
    EXPECT_EQ(get(convert(torus, "quads")).positions(), get(subdivide_into_quads(torus)).positions());
    EXPECT_EQ(get(convert(torus, "quads", Pairs{{"rule", "catmull-clark"}})).positions(),
              get(subdivide_into_quads(torus, SubdivisionRule::catmull_clark)).positions());
    for (const auto& [name, rule] : {std::pair("delaunay", TriangulationRule::delaunay),
                                     {"min-max-angle", TriangulationRule::min_max_angle},
                                     {"shortest-diagonal", TriangulationRule::shortest_diagonal},
                                     {"fan", TriangulationRule::fan}}) {
        EXPECT_EQ(get(convert(torus, "triangles", Pairs{{"rule", name}})).connectivity()->corners,
                  get(triangulate_faces(torus, rule)).connectivity()->corners);
    }
    EXPECT_EQ(get(convert(torus, "pair-triangles")).connectivity()->corners, torus.connectivity()->corners);
    EXPECT_EQ(get(convert(torus, "noise", Pairs{{"amplitude", "0.2"}, {"seed", "4294967295"}})).positions(),
              get(add_normal_noise(torus, 0.2, 4294967295U)).positions());
}

TEST(ConversionTable, RefusesWithReasons) {
    const auto& torus = specimen("torus-9x5");
    EXPECT_EQ(error_of(convert(torus, "sharpen")).code, ErrorCode::bad_argument);
    EXPECT_NE(error_of(convert(torus, "sharpen")).message.find("pair-triangles"), std::string::npos);
    EXPECT_EQ(error_of(convert(torus, "quads", Pairs{{"rule", "loop"}})).code, ErrorCode::bad_argument);
    EXPECT_EQ(error_of(convert(torus, "dual", Pairs{{"rule", "linear"}})).code, ErrorCode::bad_argument);
    EXPECT_EQ(error_of(convert(torus, "noise", Pairs{{"amplitude", "-1"}})).code, ErrorCode::parameter_out_of_range);
    EXPECT_EQ(error_of(convert(torus, "noise", Pairs{{"seed", "1.5"}})).code, ErrorCode::parameter_out_of_range);
    for (const ConversionInfo* info : conversions()) {
        EXPECT_EQ(get(find_conversion(info->id)), info);
        for (const Parameter& p : info->parameters) {
            EXPECT_TRUE(p.min <= p.initial && p.initial <= p.slider_max && p.slider_max <= p.max) << info->id << p.id;
        }
    }
}

}  // namespace
}  // namespace polylap::test

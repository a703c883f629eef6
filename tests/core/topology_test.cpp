#include <gtest/gtest.h>

#include "polylap/mesh/shapes.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

Topology topology_of(const std::string& name) {
    return build_topology(*specimen(name).connectivity());
}

TEST(Topology, CountsEdgesOfKnownMeshes) {
    const auto grid = build_topology(*get(make_grid(4, 3)).connectivity());
    EXPECT_EQ(grid.edges.size(), 4u * 4 + 5u * 3);
    EXPECT_EQ(grid.boundary_vertices.size(), 14u);
    EXPECT_EQ(grid.component_count, 1);

    const auto torus = topology_of("torus-9x5");
    EXPECT_EQ(torus.edges.size(), 90u);
    EXPECT_TRUE(torus.boundary_vertices.empty());

    const auto cube = topology_of("cube-3");  // V - E + F = 2
    EXPECT_EQ(
        specimen("cube-3").vertex_count() - static_cast<Index>(cube.edges.size()) + specimen("cube-3").face_count(), 2);
}

TEST(Topology, DescribesEachEdge) {
    const auto topology = topology_of("three-quads-on-an-edge");
    ASSERT_EQ(topology.edges.size(), 10u);
    EXPECT_TRUE(std::is_sorted(topology.edges.begin(), topology.edges.end(), [](const Edge& a, const Edge& b) {
        return std::pair(a.v0, a.v1) < std::pair(b.v0, b.v1);
    }));
    const Edge& shared = topology.edges.front();
    EXPECT_EQ(std::pair(shared.v0, shared.v1), std::pair(0, 1));
    EXPECT_EQ(shared.forward, 0);
    EXPECT_EQ(shared.backward, 3);
    EXPECT_EQ(shared.first_face, 0);
    EXPECT_FALSE(shared.manifold());
    EXPECT_FALSE(shared.oriented());
    EXPECT_FALSE(shared.boundary());
    for (std::size_t k = 1; k < topology.edges.size(); ++k) {
        EXPECT_LT(topology.edges[k].v0, topology.edges[k].v1);
        EXPECT_TRUE(topology.edges[k].boundary());
    }
    EXPECT_EQ(topology.edges.back().first_face, 2);
}

TEST(Topology, EdgesCountEveryCornerOnce) {
    for (const auto& [name, mesh] : zoo()) {
        Index sides = 0;
        for (const Edge& e : build_topology(*mesh.connectivity()).edges) {
            EXPECT_LT(e.v0, e.v1) << name;
            sides += e.faces();
        }
        EXPECT_EQ(sides, static_cast<Index>(mesh.connectivity()->corners.size())) << name;
    }
}

TEST(Topology, LabelsComponentsAndUnreferencedVertices) {
    const auto two = topology_of("two-components");
    EXPECT_EQ(two.component_count, 2);
    const auto& labels = two.component;
    ASSERT_EQ(labels.size(), 17u);
    for (std::size_t v = 0; v < labels.size(); ++v) {
        EXPECT_EQ(labels[v], v < 12 ? 0 : 1) << v;
    }

    const auto loose = topology_of("unreferenced-vertices");
    EXPECT_EQ(loose.component_count, 1);
    EXPECT_EQ(loose.unreferenced, (std::vector<Index>{0, 4}));
    EXPECT_EQ(loose.component, (std::vector<Index>{-1, 0, 0, 0, -1, 0}));
    EXPECT_EQ(loose.boundary_vertices, (std::vector<Index>{1, 2, 3, 5}));
}

TEST(Topology, JoinsComponentsThatMeetLate) {
    // Faces 0 and 1 share nothing until face 2 joins them, and vertex 6 is alone with face 3.
    const auto mesh =
        make_mesh(std::vector<Vector3>(12, Vector3::Zero()), {{9, 1, 2}, {3, 10, 5}, {2, 3, 0}, {6, 7, 8}});
    const auto topology = build_topology(*mesh.connectivity());
    EXPECT_EQ(topology.component_count, 2);
    EXPECT_EQ(topology.component, (std::vector<Index>{0, 0, 0, 0, -1, 0, 1, 1, 1, 0, 0, -1}));
}

TEST(Issues, NoneOnCleanMeshes) {
    for (const char* name : {"grid-2x2", "torus-9x5", "two-components", "star", "cube-3"}) {
        EXPECT_TRUE(find_issues(topology_of(name)).empty()) << name;
    }
}

TEST(Issues, NamesTheFirstPlace) {
    const auto moebius = find_issues(topology_of("moebius"));
    ASSERT_EQ(moebius.size(), 1u);
    EXPECT_EQ(moebius[0].kind, MeshIssue::Kind::opposite_orientation);
    EXPECT_EQ(moebius[0].count, 1);
    EXPECT_EQ(issue_name(moebius[0].kind), "opposite-orientation");

    const auto crowded = find_issues(topology_of("three-quads-on-an-edge"));
    ASSERT_EQ(crowded.size(), 1u);  // an edge with three faces is not also one of opposite orientation
    EXPECT_EQ(crowded[0].kind, MeshIssue::Kind::non_manifold_edges);
    EXPECT_EQ(crowded[0].count, 1);
    EXPECT_EQ(issue_name(crowded[0].kind), "non-manifold-edges");
    EXPECT_NE(crowded[0].message.find('0'), std::string::npos);
    EXPECT_NE(crowded[0].message.find('1'), std::string::npos);

    const auto loose = find_issues(topology_of("unreferenced-vertices"));
    ASSERT_EQ(loose.size(), 1u);
    EXPECT_EQ(loose[0].kind, MeshIssue::Kind::unreferenced_vertices);
    EXPECT_EQ(loose[0].count, 2);
    EXPECT_EQ(issue_name(loose[0].kind), "unreferenced-vertices");
    EXPECT_NE(loose[0].message.find("vertex 0"), std::string::npos) << loose[0].message;
}

TEST(BoundaryLoops, RunAlongTheFacesFromTheLowestVertex) {
    const auto loops = get(boundary_loops(build_topology(*get(make_grid(2, 2)).connectivity())));
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_EQ(loops[0], (std::vector<Index>{0, 1, 2, 5, 8, 7, 6, 3}));

    const auto two = get(boundary_loops(topology_of("two-components")));
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[1], (std::vector<Index>{12, 13, 14, 15, 16}));

    EXPECT_TRUE(get(boundary_loops(topology_of("torus-9x5"))).empty());
}

TEST(BoundaryLoops, GoAroundHoles) {
    // A ring of four quads around a square hole: the outer loop one way, the hole's the other.
    const auto ring =
        make_mesh({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
                  {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
    const auto loops = get(boundary_loops(build_topology(*ring.connectivity())));
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_EQ(loops[0], (std::vector<Index>{0, 1, 2, 3}));
    EXPECT_EQ(loops[1], (std::vector<Index>{4, 7, 6, 5}));
}

TEST(BoundaryLoops, RefuseWhatIsNoManifold) {
    const auto crowded = boundary_loops(topology_of("three-quads-on-an-edge"));
    ASSERT_FALSE(crowded.ok());
    EXPECT_EQ(crowded.error().code, ErrorCode::non_manifold_edge);
    EXPECT_EQ(crowded.error().element, 0);
    EXPECT_NE(crowded.error().message.find('0'), std::string::npos);
    EXPECT_NE(crowded.error().message.find('1'), std::string::npos);

    const auto topology = topology_of("moebius");
    const auto moebius = boundary_loops(topology);
    ASSERT_FALSE(moebius.ok());
    EXPECT_EQ(moebius.error().code, ErrorCode::non_manifold_edge);
    ASSERT_GE(moebius.error().element, 0);
    EXPECT_FALSE(topology.edges[static_cast<std::size_t>(moebius.error().element)].oriented());

    // Two triangles that meet in a vertex only.
    const auto bow_tie = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
    const auto twice = boundary_loops(build_topology(*bow_tie.connectivity()));
    ASSERT_FALSE(twice.ok());
    EXPECT_EQ(twice.error().code, ErrorCode::non_manifold_edge);
}

}  // namespace
}  // namespace polylap::test

#include "polylap/mesh/repair.hpp"

#include <limits>
#include <random>

#include "mesh_files.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using Kind = RepairChange::Kind;
using Elements = std::vector<Index>;

RawMesh raw_mesh(const std::vector<Vector3>& points, const std::vector<Face>& faces) {
    RawMesh raw;
    raw.positions.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v)
        raw.positions.row(static_cast<Eigen::Index>(v)) = points[v];
    raw.offsets.push_back(0);
    for (const Face& face : faces) {
        raw.corners.insert(raw.corners.end(), face.begin(), face.end());
        raw.offsets.push_back(static_cast<Index>(raw.corners.size()));
    }
    return raw;
}

RawMesh raw_mesh(const PolygonMesh& mesh) {
    return {mesh.positions(), mesh.connectivity()->offsets, mesh.connectivity()->corners, {}};
}

/// The elements of a change; empty if it did not happen.
Elements elements(const Repaired& repaired, Kind kind) {
    for (const RepairChange& change : repaired.changes)
        if (change.kind == kind) return change.elements;
    return {};
}

std::vector<Kind> kinds(const Repaired& repaired) {
    std::vector<Kind> found;
    for (const RepairChange& change : repaired.changes)
        found.push_back(change.kind);
    return found;
}

const std::vector<Vector3> unit_square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(Repair, LeavesASoundMeshAlone) {
    for (const auto& [name, mesh] : zoo()) {
        SCOPED_TRACE(name);
        const bool odd = !find_issues(build_topology(*mesh.connectivity())).empty();
        const Repaired repaired = get(repair(raw_mesh(mesh)));
        EXPECT_TRUE(odd || repaired.changes.empty());
        if (repaired.changes.empty()) expect_identical(mesh, repaired.mesh);
    }
}

TEST(Repair, MergesEqualVerticesAndTracesThemBack) {
    const Repaired repaired = get(repair(raw_mesh(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {9, 9, 9}, {-0.0, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {4, 5, 6}})));
    EXPECT_EQ(kinds(repaired), std::vector<Kind>{Kind::merged_vertices});
    EXPECT_EQ(elements(repaired, Kind::merged_vertices), (Elements{4, 5}));
    EXPECT_EQ(repaired.changes[0].message, "2 vertices merged into another (vertices 4, 5)");
    // Vertex 3 was in no face before, and stays.
    EXPECT_EQ(repaired.original_vertices, (Elements{0, 1, 2, 3, 6}));
    EXPECT_EQ(faces_of(repaired.mesh), (std::vector<Face>{{0, 1, 2}, {0, 2, 4}}));
    EXPECT_EQ(repaired.original_faces, (Elements{0, 1}));
}

TEST(Repair, MergesWithinADistanceOfTheDiagonal) {
    // Diagonal 5, so 0.01 is a distance of 0.05. Vertex 5 is within it of 4 only, which became 0.
    const RawMesh raw = raw_mesh({{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}, {0.04, 0, 0}, {0.08, 0, 0}},
                                 {{0, 1, 2}, {4, 2, 3}, {5, 1, 2, 3}});
    EXPECT_EQ(elements(get(repair(raw)), Kind::merged_vertices), Elements{});
    EXPECT_EQ(elements(get(repair(raw, {0.0079})), Kind::merged_vertices), Elements{});
    EXPECT_EQ(elements(get(repair(raw, {0.0081})), Kind::merged_vertices), Elements{4});
    EXPECT_EQ(elements(get(repair(raw, {0.0161})), Kind::merged_vertices), (Elements{4, 5}));
    for (const double scale : {1e-300, 1e300}) {
        RawMesh scaled = raw;
        scaled.positions *= scale;
        EXPECT_EQ(elements(get(repair(scaled, {0.0081})), Kind::merged_vertices), Elements{4});
    }
}

TEST(Repair, MergesAsComparingAllPairsDoes) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::vector<Vector3> points;
    for (int k = 0; k < 400; ++k)
        points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    const RawMesh raw = raw_mesh(points, {{0, 1, 2}});
    const Vector3 size = (raw.positions.colwise().maxCoeff() - raw.positions.colwise().minCoeff()).transpose();
    for (const double ratio : {1e-9, 0.02, 0.05, 0.1}) {
        Elements expected, staying;
        for (Index v = 0; v < 400; ++v) {
            const bool merges = std::any_of(staying.begin(), staying.end(), [&](Index w) {
                return (points[static_cast<std::size_t>(v)] - points[static_cast<std::size_t>(w)]).norm() <=
                       ratio * size.norm();
            });
            (merges ? expected : staying).push_back(v);
        }
        const auto repaired = repair(raw, {ratio});
        ASSERT_TRUE(repaired.ok()) << repaired.error().message;
        EXPECT_EQ(elements(*repaired, Kind::merged_vertices), expected);
        EXPECT_GE(expected.size(), ratio < 0.05 ? 0u : 10u);
    }
}

TEST(Repair, DropsRepeatedCornersSpikesAndPinches) {
    const std::vector<Vector3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 2, 1}, {9, 9, 9}};
    const auto cleaned = [&](const Face& face) { return faces_of(get(repair(raw_mesh(points, {face}))).mesh).at(0); };
    EXPECT_EQ(cleaned({0, 1, 1, 2}), (Face{0, 1, 2}));
    EXPECT_EQ(cleaned({0, 1, 2, 0}), (Face{0, 1, 2}));
    EXPECT_EQ(cleaned({0, 1, 4, 1, 2, 3}), (Face{0, 1, 2, 3}));  // a spike
    EXPECT_EQ(cleaned({4, 1, 2, 3, 0, 1}), (Face{1, 2, 3, 0}));  // one around the end
    EXPECT_EQ(cleaned({0, 1, 2, 3, 0, 4}), (Face{0, 1, 2, 3}));
    EXPECT_EQ(cleaned({0, 1, 4, 0, 2, 3}), (Face{0, 1, 4, 2, 3}));  // a pinch keeps its first
    const Repaired repaired = get(repair(raw_mesh(points, {{0, 1, 2, 3}, {0, 4, 1, 1}})));
    EXPECT_EQ(elements(repaired, Kind::repeated_corners), Elements{1});
    EXPECT_EQ(repaired.changes[0].message, "1 face freed of repeated corners (face 1)");
}

TEST(Repair, RemovesFacesWithoutArea) {
    const std::vector<Vector3> points = {{0, 0, 0},   {1, 0, 0},   {1, 1, 0}, {0, 1, 0},
                                         {0.1, 0, 0}, {0.3, 0, 0}, {7, 7, 7}};
    const Repaired repaired =
        get(repair(raw_mesh(points, {{}, {0, 1}, {0, 1, 2, 3}, {1, 6, 1}, {0, 4, 5}, {4, 4, 4, 4}, {0, 4, 5, 1}})));
    EXPECT_EQ(elements(repaired, Kind::degenerate_faces), (Elements{0, 1, 3, 4, 5, 6}));
    EXPECT_EQ(elements(repaired, Kind::dropped_vertices), (Elements{4, 5, 6}));
    EXPECT_EQ(repaired.changes[0].message,
              "6 faces removed for having fewer than three corners or no area (faces 0, 1, 3, 4, 5, …)");
    EXPECT_EQ(repaired.original_faces, Elements{2});
    EXPECT_EQ(repaired.original_vertices, (Elements{0, 1, 2, 3}));
}

TEST(Repair, CallsNothingFlatThatIsOnlyThin) {
    for (const double scale : {1e-300, 1.0, 1e300}) {
        // A height of 1e-12 of the length is no rounding; one of 1e-15 is.
        const auto thin = [&](double height) {
            return raw_mesh({Vector3(0, 0, 0), Vector3(scale, 0, 0), Vector3(0.5 * scale, height * scale, 0)},
                            {{0, 1, 2}});
        };
        EXPECT_TRUE(repair(thin(1e-12)).ok());
        EXPECT_EQ(repair(thin(1e-15)).error().code, ErrorCode::bad_mesh);
    }
    // Far from the origin, this is what rounding makes of three points on a line.
    const double far = 1e6;
    EXPECT_FALSE(repair(raw_mesh({{far, far, 0}, {far + 1, far + 0.1, 0}, {far + 2, far + 0.2, 0}}, {{0, 1, 2}})).ok());
    // A bow-tie whose lobes cancel has area.
    EXPECT_TRUE(repair(raw_mesh({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 3}})).ok());
}

TEST(Repair, RemovesDuplicates) {
    const Repaired repaired = get(repair(raw_mesh(
        unit_square, {{0, 1, 2, 3}, {2, 3, 0, 1}, {3, 2, 1, 0}, {0, 2, 1, 3}, {0, 1, 2}, {1, 2, 0}, {1, 0, 2}})));
    EXPECT_EQ(elements(repaired, Kind::duplicate_faces), (Elements{1, 2, 5, 6}));
    EXPECT_EQ(repaired.original_faces, (Elements{0, 3, 4}));  // the same four corners in another order are another face
}

TEST(Repair, OrientsAComponentAsMostOfItsAreaIs) {
    // A strip: face 0 small, face 1 large and turned, face 2 small; and a component of its own that stays.
    const std::vector<Vector3> points = {{0, 0, 0}, {1, 0, 0},  {9, 0, 0}, {10, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                         {9, 1, 0}, {10, 1, 0}, {0, 0, 5}, {1, 0, 5},  {0, 1, 5}};
    const Repaired repaired = get(repair(raw_mesh(points, {{0, 1, 5, 4}, {1, 5, 6, 2}, {2, 3, 7, 6}, {8, 10, 9}})));
    EXPECT_EQ(kinds(repaired), std::vector<Kind>{Kind::turned_faces});
    EXPECT_EQ(elements(repaired, Kind::turned_faces), (Elements{0, 2}));
    EXPECT_EQ(faces_of(repaired.mesh), (std::vector<Face>{{0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {8, 10, 9}}));
    // Half of the area each way: the lowest face stays.
    const Repaired tied = get(repair(raw_mesh(unit_square, {{0, 1, 2}, {0, 3, 2}})));
    EXPECT_EQ(elements(tied, Kind::turned_faces), Elements{1});
}

TEST(Repair, OrientsWhatWasTurnedAtRandom) {
    std::mt19937 random(3);
    for (const auto& [name, mesh] : zoo()) {
        if (!find_issues(build_topology(*mesh.connectivity())).empty()) continue;
        SCOPED_TRACE(name);
        RawMesh raw = raw_mesh(mesh);
        for (Index f = 0; f < mesh.face_count(); ++f)
            if (random() % 3 == 0)
                std::reverse(raw.corners.begin() + raw.offsets[static_cast<std::size_t>(f)],
                             raw.corners.begin() + raw.offsets[static_cast<std::size_t>(f) + 1]);
        const Repaired repaired = get(repair(raw));
        EXPECT_TRUE(find_issues(build_topology(*repaired.mesh.connectivity())).empty());
        EXPECT_EQ(repaired.mesh.face_count(), mesh.face_count());
        EXPECT_TRUE(get(repair(raw_mesh(repaired.mesh))).changes.empty());  // once is enough
    }
}

TEST(Repair, LeavesAMoebiusStripAsItIs) {
    std::vector<Vector3> points;
    std::vector<Face> faces;
    for (Index k = 0; k < 6; ++k) {
        const double t = k * 1.0471975511965976;
        for (const double w : {-0.3, 0.3})
            points.emplace_back((1 + w * std::cos(t / 2)) * std::cos(t), (1 + w * std::cos(t / 2)) * std::sin(t),
                                w * std::sin(t / 2));
        if (k < 5) faces.push_back({2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1});
    }
    faces.push_back({10, 1, 0, 11});
    faces.push_back({12, 13, 14});
    points.insert(points.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
    const Repaired repaired = get(repair(raw_mesh(points, faces)));
    EXPECT_EQ(kinds(repaired), std::vector<Kind>{Kind::unorientable_faces});
    EXPECT_EQ(elements(repaired, Kind::unorientable_faces), (Elements{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(faces_of(repaired.mesh), faces);
}

TEST(Repair, DoesNotConnectAcrossNonManifoldEdges) {
    // Three faces at the edge 0–1: each is a component, so none is turned.
    const std::vector<Face> faces = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
    const Repaired repaired = get(repair(raw_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, faces)));
    EXPECT_TRUE(repaired.changes.empty());
    EXPECT_EQ(faces_of(repaired.mesh), faces);
}

TEST(Repair, RepairsAFileThatIsRefused) {
    const std::string text = "OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 1\n4 0 1 2 3\n2 0 1\n";
    EXPECT_EQ(read_mesh(bytes_of(text), MeshFormat::off).error().code, ErrorCode::bad_mesh);
    const Repaired repaired = get(repair(get(read_raw(bytes_of(text), MeshFormat::off))));
    EXPECT_EQ(elements(repaired, Kind::degenerate_faces), (Elements{0, 2}));
    EXPECT_EQ(repaired.original_faces, Elements{1});
}

TEST(Repair, SaysWhatItCannotDo) {
    const RawMesh raw = raw_mesh(unit_square, {{0, 1, 2, 3}});
    for (const double distance : {-0.1, 1.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(repair(raw, {distance}).error().code, ErrorCode::bad_argument);
    const auto nothing = repair(raw_mesh(unit_square, {{0, 1}, {2, 2, 2}}));
    EXPECT_EQ(nothing.error().code, ErrorCode::bad_mesh);
    EXPECT_EQ(nothing.error().message, "repair leaves nothing: all 2 faces have fewer than three corners or no area");
    EXPECT_EQ(repair(raw_mesh(unit_square, {{0, 1}})).error().message,
              "repair leaves nothing: the only face has fewer than three corners or no area");
    EXPECT_EQ(repair(raw_mesh(unit_square, {{0, 1, 4}})).error().element, 0);
    EXPECT_EQ(repair(raw_mesh(unit_square, {{0, 1, -1}})).error().code, ErrorCode::bad_mesh);
    EXPECT_EQ(repair(RawMesh{}).error().message, "the mesh has no faces");
    RawMesh crooked = raw;
    crooked.offsets = {0, 5, 4};
    EXPECT_EQ(repair(crooked).error().code, ErrorCode::bad_mesh);
    RawMesh infinite = raw;
    infinite.positions(2, 1) = std::numeric_limits<double>::infinity();
    EXPECT_EQ(repair(infinite).error().element, 2);
}

TEST(Repair, ReportsProgressAndStops) {
    const RawMesh raw = raw_mesh(unit_square, {{0, 1, 2, 3}});
    Ticks all;
    ASSERT_TRUE(repair(raw, {}, all.monitor()).ok());
    EXPECT_TRUE(all.rise());
    for (std::size_t stop_at = 1; stop_at <= all.fractions.size(); ++stop_at) {
        Ticks ticks;
        ticks.stop_at = stop_at;
        EXPECT_EQ(repair(raw, {}, ticks.monitor()).error().code, ErrorCode::cancelled);
    }
}

TEST(Repair, NamesItsKinds) {
    EXPECT_EQ(repair_name(Kind::merged_vertices), "merged-vertices");
    EXPECT_EQ(repair_name(Kind::repeated_corners), "repeated-corners");
    EXPECT_EQ(repair_name(Kind::degenerate_faces), "degenerate-faces");
    EXPECT_EQ(repair_name(Kind::duplicate_faces), "duplicate-faces");
    EXPECT_EQ(repair_name(Kind::turned_faces), "turned-faces");
    EXPECT_EQ(repair_name(Kind::unorientable_faces), "unorientable-faces");
    EXPECT_EQ(repair_name(Kind::dropped_vertices), "dropped-vertices");
}

}  // namespace
}  // namespace polylap::test

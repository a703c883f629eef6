#include <gtest/gtest.h>

#include <limits>

#include "zoo.hpp"

namespace polylap::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Points square_points() {
    Points p(4, 3);
    p << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
    return p;
}

struct Refusal {
    const char* what;
    std::vector<Index> offsets, corners;
    std::int64_t element;
    std::vector<std::string> words;  // that the message must contain
};

TEST(PolygonMesh, RefusesBadFaces) {
    constexpr Index lowest = std::numeric_limits<Index>::min();
    constexpr Index highest = std::numeric_limits<Index>::max();
    const Refusal refusals[] = {
        {"index too large", {0, 3, 6}, {0, 1, 2, 0, 2, 4}, 1, {"face 1", "4"}},
        {"index far too large", {0, 3}, {0, 1, highest}, 0, {"face 0", "2147483647"}},
        {"negative index", {0, 3, 6}, {0, 1, 2, 0, -1, 3}, 1, {"face 1", "-1"}},
        {"two corners", {0, 3, 5}, {0, 1, 2, 0, 2}, 1, {"face 1", "three"}},
        {"empty face", {0, 3, 3, 6}, {0, 1, 2, 0, 2, 3}, 1, {"face 1", "three"}},
        {"repeated corner", {0, 3, 7}, {0, 1, 2, 0, 2, 3, 2}, 1, {"face 1", "vertex 2"}},
        {"neighbouring repeated corner", {0, 4}, {0, 1, 1, 2}, 0, {"face 0", "vertex 1"}},
        {"no faces", {0}, {}, -1, {"no faces"}},
        {"no offsets", {}, {}, -1, {"no faces"}},
        {"corners without faces", {0}, {0, 1, 2}, -1, {}},
        {"offsets not from 0", {1, 4}, {0, 1, 2, 3}, -1, {"offset"}},
        {"offsets end early", {0, 3}, {0, 1, 2, 3}, -1, {"offset"}},
        {"offsets end late", {0, 5}, {0, 1, 2, 3}, -1, {"offset"}},
        {"offsets fall", {0, 6, 3, 6}, {0, 1, 2, 0, 2, 3}, 1, {}},
        {"offsets whose difference overflows", {0, highest, lowest, 3}, {0, 1, 2}, -2, {}},
    };
    for (const Refusal& r : refusals) {
        const auto mesh = PolygonMesh::create(square_points(), r.offsets, r.corners);
        ASSERT_FALSE(mesh.ok()) << r.what;
        EXPECT_EQ(mesh.error().code, ErrorCode::bad_mesh) << r.what;
        if (r.element != -2) {
            EXPECT_EQ(mesh.error().element, r.element) << r.what;
        }
        EXPECT_EQ(mesh.error().line, -1) << r.what;
        EXPECT_FALSE(mesh.error().message.empty()) << r.what;
        for (const std::string& word : r.words) {
            EXPECT_NE(mesh.error().message.find(word), std::string::npos) << r.what << ": " << mesh.error().message;
        }
    }
}

TEST(PolygonMesh, RefusesCoordinatesThatAreNotFinite) {
    for (const double bad : {nan, infinity, -infinity}) {
        Points p = square_points();
        p(2, 1) = bad;
        const auto mesh = PolygonMesh::create(p, {0, 4}, {0, 1, 2, 3});
        ASSERT_FALSE(mesh.ok());
        EXPECT_EQ(mesh.error().code, ErrorCode::bad_mesh);
        EXPECT_EQ(mesh.error().element, 2);
        EXPECT_NE(mesh.error().message.find("vertex 2"), std::string::npos) << mesh.error().message;
    }
}

TEST(PolygonMesh, KeepsWhatItWasGiven) {
    const auto mesh = get(PolygonMesh::create(square_points(), {0, 3, 6}, {0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(mesh.vertex_count(), 4);
    EXPECT_EQ(mesh.face_count(), 2);
    ASSERT_EQ(mesh.face(1).size(), 3u);
    EXPECT_EQ(mesh.face(1)[2], 3);
    EXPECT_EQ(mesh.positions(), square_points());
    EXPECT_EQ(mesh.position(2), Vector3(1, 1, 0));
    EXPECT_EQ(mesh.connectivity()->corners, (std::vector<Index>{0, 1, 2, 0, 2, 3}));
}

TEST(PolygonMesh, MovesOnlyToFinitePositionsOfAllVertices) {
    const auto mesh = get(PolygonMesh::create(square_points(), {0, 4}, {0, 1, 2, 3}));
    const auto moved = get(mesh.with_positions(2 * square_points()));
    EXPECT_EQ(moved.positions(), 2 * square_points());
    EXPECT_EQ(mesh.positions(), square_points());
    EXPECT_EQ(moved.connectivity(), mesh.connectivity());

    const auto short_of_one = mesh.with_positions(square_points().topRows(3));
    ASSERT_FALSE(short_of_one.ok());
    EXPECT_EQ(short_of_one.error().code, ErrorCode::bad_argument);
    EXPECT_NE(short_of_one.error().message.find('3'), std::string::npos) << short_of_one.error().message;

    Points p = square_points();
    p(3, 2) = nan;
    const auto broken = mesh.with_positions(p);
    ASSERT_FALSE(broken.ok());
    EXPECT_EQ(broken.error().code, ErrorCode::bad_mesh);
    EXPECT_EQ(broken.error().element, 3);
}

TEST(PolygonMesh, TakesLargeFacesAndOddMeshes) {
    EXPECT_EQ(make_face(regular_polygon(1000)).face(0).size(), 1000u);
    EXPECT_EQ(specimen("moebius").face_count(), 11);
    EXPECT_EQ(specimen("three-quads-on-an-edge").face_count(), 3);
    EXPECT_EQ(specimen("unreferenced-vertices").vertex_count(), 6);
}

TEST(Errors, EachCodeHasItsKebabCaseName) {
    std::vector<std::string_view> names;
    for (int code = 0; code <= static_cast<int>(ErrorCode::out_of_memory); ++code) {
        const std::string_view name = error_code_name(static_cast<ErrorCode>(code));
        EXPECT_FALSE(name.empty());
        EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string_view::npos) << name;
        EXPECT_EQ(std::find(names.begin(), names.end(), name), names.end()) << name;
        names.push_back(name);
    }
    EXPECT_EQ(error_code_name(ErrorCode::degenerate_face), "degenerate-face");
    EXPECT_EQ(error_code_name(ErrorCode::parameter_out_of_range), "parameter-out-of-range");
}

}  // namespace
}  // namespace polylap::test

#include "mesh_files.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using namespace std::string_literals;
using Triangles = std::vector<std::vector<float>>;  // 9 numbers each

std::string binary(const Triangles& triangles, std::string header = "made for a test") {
    header.resize(80, ' ');
    std::string bytes = header + raw_bytes(static_cast<std::uint32_t>(triangles.size()));
    for (const auto& triangle : triangles) {
        for (int k = 0; k < 3; ++k)
            bytes += raw_bytes(std::numeric_limits<float>::quiet_NaN());  // a normal, which does not matter
        for (const float x : triangle)
            bytes += raw_bytes(x);
        bytes += "\x34\x12";  // an attribute, which does not matter
    }
    return bytes;
}

const std::string facet0 =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 1 1 0.1\n endloop\nendfacet\n";
const std::string facet1 =
    "facet normal 0 0 1\n outer loop\n  vertex -0 0 0\n  vertex 1 1 .1\n  vertex 0 1 0\n endloop\nendfacet\n";
const Triangles square = {{0, 0, 0, 1, 0, 0, 1, 1, 0.5f}, {-0.f, 0, 0, 1, 1, 0.5f, 0, 1, 0}};
const std::vector<double> coordinates = {0, 0, 0, 1, 0, 0, 1, 1, 0.1, 0, 1, 0};
const std::vector<double> binary_coordinates = {0, 0, 0, 1, 0, 0, 1, 1, 0.5, 0, 1, 0};

class StlUnderstood : public testing::TestWithParam<Accepted> {};
TEST_P(StlUnderstood, WeldsFacets) {
    expect_understood(GetParam(), MeshFormat::stl);
}

INSTANTIATE_TEST_SUITE_P(
    Files, StlUnderstood,
    testing::Values(
        Accepted{"Text", "solid a b\n" + facet0 + facet1 + "endsolid a b\n", {{0, 1, 2}, {0, 2, 3}}, coordinates},
        Accepted{"Nameless", "solid\n" + facet0 + facet1 + "endsolid", {{0, 1, 2}, {0, 2, 3}}, coordinates},
        Accepted{"TwoSolids",
                 "solid a\n" + facet0 + "endsolid a\n\nsolid solid\n" + facet1 + "endsolid solid\n",
                 {{0, 1, 2}, {0, 2, 3}},
                 coordinates},
        Accepted{
            "Capitals",
            "SOLID\r\nFACET NORMAL nan nan nan\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\nVERTEX 1 0 0\r\nVERTEX 1 1 1E-1\r\n"
            "ENDLOOP\r\nENDFACET\r\n" +
                facet1 + "ENDSOLID\r\n",
            {{0, 1, 2}, {0, 2, 3}},
            coordinates},
        Accepted{"OneLine",
                 "solid x\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 1 1 0.1 endloop endfacet " +
                     facet1 + "endsolid\n",
                 {{0, 1, 2}, {0, 2, 3}},
                 coordinates},
        Accepted{"Binary", binary(square), {{0, 1, 2}, {0, 2, 3}}, binary_coordinates},
        Accepted{"BinaryThatSaysSolid",
                 binary(square, "solid of a CAD program"),
                 {{0, 1, 2}, {0, 2, 3}},
                 binary_coordinates}),
    accepted_name);

class StlRefused : public testing::TestWithParam<Refusal> {};
TEST_P(StlRefused, NamesLineAndFacet) {
    expect_refused(GetParam(), MeshFormat::stl);
}

std::string patched(std::size_t at, const std::string& patch) {
    return binary(square).replace(at, patch.size(), patch);
}

INSTANTIATE_TEST_SUITE_P(
    Text, StlRefused,
    testing::Values(
        Refusal{"Empty", "", -1, -1, "the file is empty"},
        Refusal{"Other", "Dear reader,\n", -1, -1, "this is not an STL file: it does not begin with solid"},
        Refusal{"Off", "OFF\n3 1 0\n", -1, -1, "this is an OFF file, not an STL file"},
        Refusal{"NoFacets", "solid a\nendsolid a\n", -1, -1, "the file has no facets"},
        Refusal{"Unknown", "solid a\n" + facet0 + "colour 1 2 3\nendsolid\n", 9, -1,
                "line 9: 'colour' where facet or endsolid should stand"},
        Refusal{"Behind", "solid a\n" + facet0 + "endsolid\n" + facet1, 10, -1,
                "line 10: 'facet' where solid should stand"},
        Refusal{"NoEndsolid", "solid a\n" + facet0, -1, -1, "the file ends without endsolid"},
        Refusal{"EndsInFacet", "solid a\n" + facet0 + facet1.substr(0, 60), 12, 1,
                "line 12: facet 1 ends with the file where a coordinate should stand"},
        Refusal{"FourCorners",
                "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n", 7,
                0, "line 7: facet 0 has 'vertex' where endloop should stand"},
        Refusal{"Nan", "solid a\n" + facet0 + "facet normal 0 0 1\nouter loop\nvertex 0 nan 0\n", 11, 1,
                "line 11: facet 1 has 'nan', which is no finite number"},
        Refusal{"NoNormal", "solid a\nfacet outer loop\n", 2, 0,
                "line 2: facet 0 has 'outer' where normal should stand"},
        Refusal{"Degenerate",
                "solid a\n" + facet0 +
                    "facet normal 0 0 0 outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1.0 0 "
                    "-0\nendloop\nendfacet\nendsolid\n",
                9, 1, "line 9: facet 1 has vertex 1 twice", ErrorCode::bad_mesh}),
    refusal_name);

INSTANTIATE_TEST_SUITE_P(
    Binary, StlRefused,
    testing::Values(Refusal{"Short", std::string(60, '\0'), -1, -1,
                            "byte 60: the file ends within the 84 bytes that begin"},
                    Refusal{"NoFacets", binary({}), -1, -1, "the file has no facets"},
                    Refusal{"Huge", patched(80, raw_bytes(std::uint32_t{0xffffffff})), -1, -1,
                            "byte 80: 4294967295 facets are announced"},
                    Refusal{"CutOff", binary(square).substr(0, 180), -1, -1,
                            "byte 80: 2 facets are announced, but the 96 bytes that follow cannot hold them"},
                    Refusal{"MoreFollows", binary(square) + "!", -1, -1,
                            "byte 184: more follows than the 2 facets that the header"},
                    Refusal{"Nan", patched(84 + 12 + 16, raw_bytes(std::numeric_limits<float>::quiet_NaN())), -1, 0,
                            "byte 112: facet 0 has a coordinate that is no finite number"},
                    Refusal{"Degenerate", patched(134 + 12 + 12, raw_bytes(0.f) + raw_bytes(0.f) + raw_bytes(0.f)), -1,
                            1, "byte 134: facet 1 has vertex 0 twice", ErrorCode::bad_mesh}),
    refusal_name);

TEST(Stl, SaysWhatWasWelded) {
    const PolygonMesh cube = get(read_mesh(
        bytes_of(
            "OFF\n8 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n"
            "3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n"),
        MeshFormat::off));
    const std::string bytes = write_mesh(cube, MeshFormat::stl).value();
    EXPECT_EQ(bytes.size(), 84u + 12 * 50);
    const RawMesh raw = get(read_raw(bytes_of(bytes), MeshFormat::stl));
    EXPECT_EQ(raw.notes, std::vector<std::string>{"36 corners welded to 8 vertices"});
    EXPECT_EQ(raw.positions.rows(), 8);
    // The first facet's normal points down.
    EXPECT_EQ(bytes.substr(84, 12), raw_bytes(0.f) + raw_bytes(0.f) + raw_bytes(-1.f));
}

/// The same triangles at the same places, in single precision.
void expect_same_triangles(const PolygonMesh& a, const PolygonMesh& b) {
    ASSERT_EQ(a.face_count(), b.face_count());
    for (Index f = 0; f < a.face_count(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(a.position(a.face(f)[k]).cast<float>(), b.position(b.face(f)[k]).cast<float>());
}

TEST(Stl, ReadsBackTheTrianglesOfTheZoo) {
    int triangle_meshes = 0;
    for (const auto& [name, mesh] : zoo()) {
        SCOPED_TRACE(name);
        const auto bytes = write_mesh(mesh, MeshFormat::stl);
        EXPECT_EQ(bytes.ok(), only_triangles(mesh));
        if (!bytes) {
            EXPECT_EQ(bytes.error().code, ErrorCode::bad_argument);
            EXPECT_GT(mesh.face(static_cast<Index>(bytes.error().element)).size(), 3u);
            continue;
        }
        ++triangle_meshes;
        expect_same_triangles(mesh, get(read_mesh(bytes_of(*bytes), MeshFormat::stl)));
    }
    EXPECT_GT(triangle_meshes, 0);
}

TEST(Stl, NamesWhatItCannotHold) {
    const PolygonMesh quad = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2, 3}});
    EXPECT_EQ(write_mesh(quad, MeshFormat::stl).error().message,
              "face 1 has 4 corners, and an STL file holds triangles only");
    const PolygonMesh huge = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, -1e39, 0}}, {{0, 1, 2}});
    EXPECT_EQ(write_mesh(huge, MeshFormat::stl).error().element, 2);
}

}  // namespace
}  // namespace polylap::test

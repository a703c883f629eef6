#include "mesh_files.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using namespace std::string_literals;

Result<PolygonMesh> read(const std::string& text) {
    return read_mesh(bytes_of(text), MeshFormat::off);
}

/// Four vertices, in lines 3 to 6 behind a header of two lines.
const std::string corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::vector<double> coordinates = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

class OffUnderstood : public testing::TestWithParam<Accepted> {};
TEST_P(OffUnderstood, GivesFacesAndCoordinates) {
    expect_understood(GetParam(), MeshFormat::off);
}

INSTANTIATE_TEST_SUITE_P(
    Text, OffUnderstood,
    testing::Values(
        Accepted{"Plain", "OFF\n4 1 4\n" + corners + "4 0 1 2 3\n", {{0, 1, 2, 3}}, coordinates},
        Accepted{"NoEdgeCount", "OFF\n4 1\n" + corners + "4 0 1 2 3", {{0, 1, 2, 3}}, coordinates},
        Accepted{"CountsBesideKeyword", "OFF 4 1 0\n" + corners + "4 0 1 2 3\n", {{0, 1, 2, 3}}, coordinates},
        Accepted{"CountsStuckToKeyword", "OFF4 1 0\n" + corners + "4 0 1 2 3\n", {{0, 1, 2, 3}}, coordinates},
        Accepted{"LowerCase", "off\n4 1 0\n" + corners + "4 0 1 2 3\n", {{0, 1, 2, 3}}, coordinates},
        Accepted{"ByteOrderMark", "\xEF\xBB\xBFOFF\n4 1 0\n" + corners + "4 0 1 2 3\n", {{0, 1, 2, 3}}, coordinates},
        Accepted{"Comments",
                 "# a\n\nOFF # b\n# c\n4 2 0 # d\n0 0 0#e\n\n1 0 0\n 1 1 0\n# f\n0 1 0\n4 0 1 2 3 # 9\n3 0 1 2#\n# g\n",
                 {{0, 1, 2, 3}, {0, 1, 2}},
                 coordinates},
        Accepted{
            "Crlf", "OFF\r\n4 1 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n4 0 1 2 3\r\n", {{0, 1, 2, 3}}, coordinates},
        Accepted{
            "Colours",
            "COFF\n4 5 0\n0 0 0 255 0 0 255\n1 0 0 .1 .2 .3 1\n1 1 0 0 0 0 0\n0 1 0 1 1 1 1\n4 0 1 2 3\n3 0 1 2 7\n"
            "3 0 1 2 255 0 0\n3 0 2 3 .5 .5 .5 1\n3 1 2 3 9 9\n",
            {{0, 1, 2, 3}, {0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {1, 2, 3}},
            coordinates},
        Accepted{"ColoursWithoutKeyword",
                 "OFF\n4 1 0\n0 0 0 1 1 1\n1 0 0 1 1 1\n1 1 0 1 1 1\n0 1 0 1 1 1\n4 0 1 2 3\n",
                 {{0, 1, 2, 3}},
                 coordinates},
        Accepted{"Normals",
                 "NOFF\n4 1 0\n0 0 0 0 0 1\n1 0 0 nan nan nan\n1 1 0 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3\n",
                 {{0, 1, 2, 3}},
                 coordinates},
        Accepted{"Everything",
                 "STCNOFF\n4 1 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0 0 0 1 1 1 1 1 0 0\n1 1 0 0 0 1 1 1 1 1 0 0\n"
                 "0 1 0 0 0 1 1 1 1 1 0 0\n4 0 1 2 3\n",
                 {{0, 1, 2, 3}},
                 coordinates}),
    accepted_name);

std::string binary(bool big, bool colour_counts, const std::string& keyword = "OFF BINARY\n", int extras = 0) {
    std::string bytes = keyword;
    for (const std::int32_t count : {4, 2, 0})
        bytes += raw_bytes(count, big);
    for (std::size_t k = 0; k < coordinates.size(); ++k) {
        bytes += raw_bytes(static_cast<float>(coordinates[k]), big);
        for (int i = 0; k % 3 == 2 && i < extras; ++i)
            bytes += raw_bytes(0.5f, big);
    }
    for (const std::int32_t number : {4, 0, 1, 2, 3})
        bytes += raw_bytes(number, big);
    if (colour_counts)
        bytes += raw_bytes(std::int32_t{3}, big) + raw_bytes(1.f, big) + raw_bytes(0.f, big) + raw_bytes(0.f, big);
    for (const std::int32_t number : {3, 0, 1, 2})
        bytes += raw_bytes(number, big);
    if (colour_counts) bytes += raw_bytes(std::int32_t{0}, big);
    return bytes;
}

INSTANTIATE_TEST_SUITE_P(
    Binary, OffUnderstood,
    testing::Values(Accepted{"LittleEndian", binary(false, false), {{0, 1, 2, 3}, {0, 1, 2}}, coordinates},
                    Accepted{"BigEndian", binary(true, false), {{0, 1, 2, 3}, {0, 1, 2}}, coordinates},
                    Accepted{"LittleEndianColours", binary(false, true), {{0, 1, 2, 3}, {0, 1, 2}}, coordinates},
                    Accepted{"BigEndianColours", binary(true, true), {{0, 1, 2, 3}, {0, 1, 2}}, coordinates},
                    Accepted{"Crlf", binary(true, true, "OFF BINARY\r\n"), {{0, 1, 2, 3}, {0, 1, 2}}, coordinates},
                    Accepted{"Normals", binary(true, true, "NOFF BINARY\n", 3), {{0, 1, 2, 3}, {0, 1, 2}}, coordinates},
                    Accepted{
                        "All", binary(false, false, "STCNOFF BINARY\n", 9), {{0, 1, 2, 3}, {0, 1, 2}}, coordinates}),
    accepted_name);

class OffRefused : public testing::TestWithParam<Refusal> {};
TEST_P(OffRefused, NamesLineAndElement) {
    expect_refused(GetParam(), MeshFormat::off);
}

const std::string head = "OFF\n4 2 0\n" + corners;

INSTANTIATE_TEST_SUITE_P(
    Text, OffRefused,
    testing::Values(
        Refusal{"Empty", "", -1, -1, "the file is empty"}, Refusal{"Blank", " \n# c\n", -1, -1, "the file is empty"},
        Refusal{"Obj", "v 0 0 0\n", 1, -1, "line 1: 'v' where the keyword OFF should stand"},
        Refusal{"Html", "<html>", -1, -1, "this is an HTML page, not an OFF file"},
        Refusal{"Ply", "ply\nformat", -1, -1, "this is a PLY file, not an OFF file"},
        Refusal{"Dimensions", "nOFF\n2\n3 1 0\n", 1, -1, "line 1: 'nOFF': vertices of other dimensions than three"},
        Refusal{"Homogeneous", "# c\nC4OFF 3 1 0\n", 2, -1, "line 2: 'C4OFF': vertices of other dimensions than three"},
        Refusal{"NoCounts", "OFF\n", -1, -1, "the file ends before its counts"},
        Refusal{"WordCount", "OFF\n4 x 0\n", 2, -1, "line 2: 'x' where the counts of vertices, faces and edges should"},
        Refusal{"FourCounts", "OFF\n4 1 0 0\n", 2, -1, "line 2: '0' where the counts of vertices, faces and edges"},
        Refusal{"OneCount", "OFF\n4\n1\n", 2, -1, "line 2: the count of faces is missing"},
        Refusal{"Negative", "OFF\n-4 1 0\n", 2, -1,
                "line 2: -4 vertices are announced, but a count cannot be negative"},
        Refusal{"Huge", "OFF\n2000000000 1 0\n" + corners, 2, -1,
                "line 2: 2000000000 vertices are announced, but the 26 bytes that follow cannot hold them"},
        Refusal{"HugeFaces", "OFF\n4 2000000000 0\n" + corners, 2, -1,
                "line 2: 2000000000 faces are announced, but the"},
        Refusal{"BeyondIndex", "OFF\n3000000000 1 0\n", 2, -1,
                "line 2: 3000000000 vertices are announced, but a mesh holds at most 2147483647"},
        Refusal{"Beyond64Bits", "OFF\n99999999999999999999 1 0\n", 2, -1, "line 2: 9223372036854775807 vertices are"},
        Refusal{"NoFaces", "OFF\n4 0 0\n" + corners, -1, -1, "the file has no faces, only 4 vertices"},
        Refusal{"TwoCoordinates", "OFF\n1 1 0\n0 0\n3 0 0 0", 3, 0, "line 3: vertex 0 has only 2 of 3 coordinates"},
        Refusal{"Nan", "OFF\n1 1 0\n0 nan 0\n", 3, 0, "line 3: vertex 0 has 'nan', which is no finite number"},
        Refusal{"Infinite", "OFF\n2 1 0\n0 0 0\n0 1e999 0\n", 4, 1, "line 4: vertex 1 has '1e999', which is no finite"},
        Refusal{"TooManyNumbers", "OFF\n1 1 0\n0 0 0 1 2 3 4 5 6 7 8 9 10\n", 3, 0, "line 3: vertex 0 has 13 numbers,"},
        Refusal{"EndsInVertices", "OFF\n4 1 0\n0 0 0\n0 0 0          #\n#", -1, -1,
                "the file ends before vertex 2 of 4, counted from 0"},
        Refusal{"EndsInFaces", head + "4 0 1 2 3\n", -1, -1, "the file ends before face 1 of 2, counted from 0"},
        Refusal{"CornerMissing", head + "4 0 1 2\n3 0 1 2\n", 7, 0, "line 7: face 0 has only 3 of 4 corners"},
        Refusal{"WordCorner", head + "3 0 1 x\n3 0 1 2\n", 7, 0,
                "line 7: face 0 has the corner 'x', which is no whole"},
        Refusal{"WordSize", head + "3 0 1 2\nx 0 1 2\n", 8, 1, "line 8: face 1 has 'x' where its number of corners"},
        Refusal{"NegativeSize", head + "-3 0 1 2\n3 0 1 2\n", 7, 0, "line 7: face 0 has '-3' where its number"},
        Refusal{"HugeSize", head + "9999999999 0 1 2\n3 0 1 2\n", 7, 0, "line 7: face 0 has only 3 of 9999999999"},
        Refusal{"OutOfRange", head + "3 0 1 2\n3 0 1 4\n", 8, 1,
                "line 8: face 1 has the index 4, but the file has 4 vertices, counted from 0"},
        Refusal{"NegativeIndex", head + "3 0 1 -1\n3 0 1 2\n", 7, 0, "line 7: face 0 has the index -1, but"},
        Refusal{"TooMuchColour", head + "3 0 1 2 1 1 1 1 1\n3 0 1 2\n", 7, 0,
                "line 7: face 0 has '1' behind its 3 corners"},
        Refusal{"WordColour", head + "3 0 1 2 red\n3 0 1 2\n", 7, 0, "line 7: face 0 has 'red' behind its 3 corners"},
        Refusal{"MoreThanAnnounced", head + "3 0 1 2\n3 1 2 3\n3 0 2 3\n", 9, -1,
                "line 9: more follows than the 2 faces that the header announces"},
        Refusal{"TwoCorners", head + "3 0 1 2\n2 0 1\n", 8, 1, "line 8: face 1 has 2 corners, fewer than 3",
                ErrorCode::bad_mesh},
        Refusal{"NoCorners", head + "0\n3 0 1 2\n", 7, 0, "line 7: face 0 has 0 corners, fewer than 3",
                ErrorCode::bad_mesh},
        Refusal{"Repeated", head + "3 0 1 2\n4 0 1 2 1\n", 8, 1, "line 8: face 1 has vertex 1 twice",
                ErrorCode::bad_mesh}),
    refusal_name);

std::string with(std::string bytes, std::size_t at, const std::string& patch) {
    return bytes.replace(at, patch.size(), patch);
}

// 11 bytes of header, 12 of counts, 48 of vertices: face 0 is at byte 71, face 1 at 91, the end at 107.
INSTANTIATE_TEST_SUITE_P(
    Binary, OffRefused,
    testing::Values(
        Refusal{"NoCounts", "OFF BINARY\n\1\0\0"s, -1, -1, "byte 14: the file ends within its counts"},
        Refusal{"Huge", with(binary(false, false), 11, raw_bytes(std::int32_t{0x7f000000})), -1, -1,
                "byte 11: 2130706432 vertices are announced, but the 84 bytes that follow cannot hold them"},
        Refusal{"HugeFaces", with(binary(false, false), 15, raw_bytes(std::int32_t{0x7f000000})), -1, -1,
                "byte 15: 2130706432 faces are announced, but the 36 bytes that follow cannot hold them"},
        Refusal{"NoFaces", "OFF BINARY\n"s + std::string(12, '\0'), -1, -1, "the file has no faces, only 0 vertices"},
        Refusal{"Nan", with(binary(false, false), 27, raw_bytes(std::numeric_limits<float>::quiet_NaN())), -1, 0,
                "byte 27: vertex 0 has a coordinate that is no finite number"},
        Refusal{"CutOff", binary(false, false).substr(0, 105), -1, 1,
                "byte 91: face 1 is cut off by the end of the file"},
        Refusal{"CutOffBigEndian", binary(true, true).substr(0, 100), -1, 0, "byte 71: face 0 is cut off"},
        Refusal{"NegativeSize", with(binary(false, false), 91, raw_bytes(std::int32_t{-3})), -1, 1,
                "byte 91: face 1 has -3 corners"},
        Refusal{"HugeSize", with(binary(false, false), 71, raw_bytes(std::int32_t{0x7fffffff})), -1, 0,
                "byte 71: face 0 is cut off"},
        Refusal{"OutOfRange", with(binary(false, false), 99, raw_bytes(std::int32_t{4})), -1, 1,
                "byte 99: face 1 has the index 4, but the file has 4 vertices"},
        Refusal{"MoreFollows", binary(false, false) + "!", -1, -1,
                "byte 107: more follows than the 2 faces that the header announces"},
        Refusal{"Repeated", with(binary(false, false), 99, raw_bytes(std::int32_t{0})), -1, 1,
                "byte 91: face 1 has vertex 0 twice", ErrorCode::bad_mesh}),
    refusal_name);

TEST(Off, PrefersTheByteOrderThatEndsWithTheFile) {
    // 65536 vertices read in the wrong order are 256, which a file of this size could hold too.
    const Index n = 65536;
    std::string bytes = "OFF BINARY\n";
    for (const std::int32_t count : {n, n, 0})
        bytes += raw_bytes(count, true);
    for (Index v = 0; v < n; ++v)
        for (const float x : {static_cast<float>(v), 0.f, 1.f})
            bytes += raw_bytes(x, true);
    for (Index f = 0; f < n; ++f)
        for (const std::int32_t k : {3, f, (f + 1) % n, (f + 2) % n, 0})
            bytes += raw_bytes(k, true);
    const auto mesh = read(bytes);
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    EXPECT_EQ(mesh->vertex_count(), n);
    EXPECT_EQ(mesh->face(n - 1)[1], 0);
}

TEST(Off, WritesPlainly) {
    const auto mesh = read("OFF\n3 1 0\n0.1 -1e300 1e-7\n1 0 0\n0 1 0\n3 2 0 1\n");
    EXPECT_EQ(
        write_mesh(get(mesh), MeshFormat::off).value(),
        "OFF\n3 1 0\n0.10000000000000001 -1.0000000000000001e+300 9.9999999999999995e-08\n1 0 0\n0 1 0\n3 2 0 1\n");
}

TEST(Off, ReadsBackTheZoo) {
    for (const auto& [name, mesh] : zoo()) {
        SCOPED_TRACE(name);
        expect_identical(mesh, get(read(write_mesh(mesh, MeshFormat::off).value())));
    }
}

}  // namespace
}  // namespace polylap::test

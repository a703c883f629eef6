#include "mesh_files.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using namespace std::string_literals;

Result<PolygonMesh> read(const std::string& bytes) {
    return read_mesh(bytes_of(bytes), MeshFormat::ply);
}

std::string header(const std::string& vertices = "3", const std::string& faces = "1",
                   const std::string& format = "ascii") {
    return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}
/// Nine lines, so that vertex 0 is in line 10.
const std::string triangle = "0 0 0\n1 0 0\n0 1 0.1\n";
const std::vector<double> coordinates = {0, 0, 0, 1, 0, 0, 0, 1, 0.1};

class PlyUnderstood : public testing::TestWithParam<Accepted> {};
TEST_P(PlyUnderstood, GivesFacesAndCoordinates) {
    expect_understood(GetParam(), MeshFormat::ply);
}

std::string crlf(std::string text) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
        text.insert(at, 1, '\r');
    return text;
}

INSTANTIATE_TEST_SUITE_P(
    Text, PlyUnderstood,
    testing::Values(
        Accepted{"Plain", header() + triangle + "3 0 1 2\n", {{0, 1, 2}}, coordinates},
        Accepted{"NoLastLineEnd", header() + triangle + "3 0 1 2", {{0, 1, 2}}, coordinates},
        Accepted{"Crlf", crlf(header() + triangle + "3 0 1 2\n"), {{0, 1, 2}}, coordinates},
        Accepted{"BlankLines", header() + "\n" + triangle + "\n\n3 0 1 2\n\n", {{0, 1, 2}}, coordinates},
        Accepted{
            "EverythingElse",
            "ply\ncomment before the format\nformat ascii 1.0\nobj_info made by hand\nelement material 1\nproperty "
            "int r\nproperty list uint8 float32 xs\nelement vertex 3\nproperty uint8 red\nproperty float64 z\ncomment "
            "elements\nproperty int16 x\nproperty list uchar float extra\nproperty double y\nelement face 2\nproperty "
            "list uint8 float texcoord\nproperty list int32 uint32 vertex_index\nproperty int flags\nelement edge 1\n"
            "property int a\nproperty int b\nelement nothing 5\nend_header\n7 2 .5 .5\n255 0 0 0 0\n0 0 1 3 1 2 nan 0\n"
            "0 0.1 0 1 7 1\n2 .5 .5 3 0 1 2 9\n0 3 2 1 0 9\n0 1\n",
            {{0, 1, 2}, {2, 1, 0}},
            coordinates},
        Accepted{
            "FacesFirst",
            "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement vertex 3\nproperty "
            "float x\nproperty float y\nproperty float z\nend_header\n3 0 1 2\n" +
                triangle,
            {{0, 1, 2}},
            coordinates}),
    accepted_name);

/// A quad of int16 positions with a colour and a list each, another element before, and faces with a list behind.
std::string rich_binary(bool big) {
    std::string bytes =
        "ply\nformat "s + (big ? "binary_big_endian" : "binary_little_endian") +
        " 1.0\nelement camera 2\nproperty double f\nproperty list uchar short s\nelement vertex 4\nproperty "
        "short x\nproperty uchar red\nproperty char y\nproperty list ushort double l\nproperty uint z\n"
        "element face 1\nproperty list ushort ushort vertex_index\nproperty list int float uv\nend_header\n";
    bytes += raw_bytes(std::numeric_limits<double>::quiet_NaN(), big) + "\2"s + raw_bytes(std::int32_t{0}, big);
    bytes += raw_bytes(1.0, big) + "\0"s;
    const int xyz[4][3] = {{-300, -1, 0}, {300, -128, 70000}, {300, 127, 5}, {-300, 1, 6}};
    for (const auto& [x, y, z] : xyz)
        bytes += raw_bytes(static_cast<std::int16_t>(x), big) + "\xff" + raw_bytes(static_cast<std::int8_t>(y)) +
                 raw_bytes(std::uint16_t{1}, big) + raw_bytes(0.5, big) + raw_bytes(static_cast<std::uint32_t>(z), big);
    for (const int number : {4, 0, 1, 2, 3})
        bytes += raw_bytes(static_cast<std::uint16_t>(number), big);
    return bytes + raw_bytes(std::int32_t{1}, big) + raw_bytes(0.5f, big);
}
const std::vector<double> rich_coordinates = {-300, -1, 0, 300, -128, 70000, 300, 127, 5, -300, 1, 6};

/// Vertex 0 begins with a line feed, which must not be taken for one behind a header with CR LF or CR.
std::string binary(bool big, const std::string& line_end = "\n") {
    std::string bytes = header("3", "1", big ? "binary_big_endian" : "binary_little_endian");
    for (std::size_t at = 0; (at = bytes.find('\n', at)) != std::string::npos; at += line_end.size())
        bytes.replace(at, 1, line_end);
    const float first = std::bit_cast<float>(std::uint32_t{0x0a00000a});
    for (const float x : {first, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
        bytes += raw_bytes(x, big);
    bytes += "\3";
    for (const std::int32_t vertex : {0, 1, 2})
        bytes += raw_bytes(vertex, big);
    return bytes;
}
const std::vector<double> binary_coordinates = {
    std::bit_cast<float>(std::uint32_t{0x0a00000a}), 0, 0, 1, 0, 0, 0, 1, 0};

INSTANTIATE_TEST_SUITE_P(
    Binary, PlyUnderstood,
    testing::Values(Accepted{"LittleEndian", binary(false), {{0, 1, 2}}, binary_coordinates},
                    Accepted{"BigEndian", binary(true), {{0, 1, 2}}, binary_coordinates},
                    Accepted{"HeaderWithCrlf", binary(true, "\r\n"), {{0, 1, 2}}, binary_coordinates},
                    Accepted{"HeaderWithCr", binary(false, "\r"), {{0, 1, 2}}, binary_coordinates},
                    Accepted{"LineEndBehind", binary(false) + "\r\n", {{0, 1, 2}}, binary_coordinates},
                    Accepted{"RichLittleEndian", rich_binary(false), {{0, 1, 2, 3}}, rich_coordinates},
                    Accepted{"RichBigEndian", rich_binary(true), {{0, 1, 2, 3}}, rich_coordinates}),
    accepted_name);

class PlyRefused : public testing::TestWithParam<Refusal> {};
TEST_P(PlyRefused, NamesLineAndElement) {
    expect_refused(GetParam(), MeshFormat::ply);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

INSTANTIATE_TEST_SUITE_P(
    Header, PlyRefused,
    testing::Values(
        Refusal{"Empty", "", -1, -1, "the file is empty"},
        Refusal{"Other", "plyx\n", -1, -1, "this is not a PLY file: its first line is not ply"},
        Refusal{"Off", "OFF\n3 1 0\n", -1, -1, "this is an OFF file, not a PLY file"},
        Refusal{"NoFormat", "ply\nelement vertex 3\n", 2, -1, "line 2: 'element' where the format should stand"},
        Refusal{"Format", "ply\nformat binary 1.0\n", 2, -1, "line 2: the format 'binary' is none of ascii,"},
        Refusal{"Version", "ply\nformat ascii 2.0\n", 2, -1, "line 2: the version '2.0' is not 1.0"},
        Refusal{"NoEnd", "ply\nformat ascii 1.0\nelement vertex 3\n", -1, -1, "the file ends within its header"},
        Refusal{"Unknown", replaced(header(), "element", "elemnt"), 3, -1, "line 3: 'elemnt' where a declaration"},
        Refusal{"Type", replaced(header(), "float y", "real y"), 5, -1, "line 5: 'real' is no type of a property"},
        Refusal{"CountType", replaced(header(), "uchar", "float"), 8, -1, "line 8: a list is counted by a type of"},
        Refusal{"CornerType", replaced(header(), "uchar int", "uchar float"), 8, -1, "line 8: 'vertex_indices' has a"},
        Refusal{"CornersNoList", replaced(header(), "list uchar", ""), 8, -1,
                "line 8: 'vertex_indices' must be a list"},
        Refusal{"ListOfX", replaced(header(), "float x", "list uchar float x"), 4, -1, "line 4: 'x' must be no list"},
        Refusal{"Nameless", replaced(header(), "float x", "float"), 4, -1, "line 4: a property is declared by"},
        Refusal{"TwoX", replaced(header(), "float y", "float x"), 5, -1, "line 5: 'x' is declared twice"},
        Refusal{"NoZ", replaced(header(), "float z", "float w") + triangle + "3 0 1 2\n", 3, -1,
                "line 3: the element 'vertex' has no property z"},
        Refusal{"NoCorners", replaced(header(), "vertex_indices", "v") + triangle + "3 0 1 2\n", 7, -1,
                "line 7: the element 'face' has no"},
        Refusal{"TwoVertexElements", replaced(header(), "element face", "element vertex"), 7, -1,
                "line 7: the element 'vertex' is declared twice"},
        Refusal{"NoVertexElement", replaced(header(), "element vertex", "element point") + triangle + "3 0 1 2\n", -1,
                -1, "the file has no element vertex"},
        Refusal{"NoFaceElement", replaced(header(), "element face 1", "element strips 0") + triangle, -1, -1,
                "the file has no faces, only 3 vertices"},
        Refusal{"NoFaces", header("3", "0") + triangle, -1, -1, "the file has no faces, only 3 vertices"},
        Refusal{"PropertyFirst", "ply\nformat ascii 1.0\nproperty int x\n", 3, -1, "line 3: a property stands before"},
        Refusal{"CountWord", header("three"), 3, -1, "line 3: an element is declared by its name and how many"},
        Refusal{"Negative", header("-1"), 3, -1, "line 3: -1 vertices are announced, but a count cannot be negative"},
        Refusal{"Huge", header("2000000000") + triangle, 3, -1, "line 3: 2000000000 vertices are announced, but the"},
        Refusal{"HugeBinary", header("3", "2147483647", "binary_little_endian"), 3, -1, "line 3: 3 vertices are"},
        Refusal{"HugeFaces", header("3", "2147483648") + triangle, 7, -1,
                "line 7: 2147483648 faces are announced, but a mesh holds at most 2147483647"}),
    refusal_name);

// Each vertex has 12 bytes, so that face 0 is at byte 36 of the data and the end at 49.
const std::size_t data = header("3", "1", "binary_little_endian").size();
std::string patched(std::size_t at, const std::string& patch) {
    return binary(false).replace(data + at, patch.size(), patch);
}
std::string at_data(std::size_t byte) {
    return "byte " + std::to_string(data + byte) + ": ";
}

INSTANTIATE_TEST_SUITE_P(
    Data, PlyRefused,
    testing::Values(
        Refusal{"Nan", header() + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", 11, 1,
                "line 11: vertex 1 has 'nan', which is no"},
        Refusal{"TwoCoordinates", header() + "0 0 0\n1 0 0\n0 1\n3 0 1 2\n", 12, 2,
                "line 12: vertex 2 has fewer values"},
        Refusal{"FourCoordinates", header() + "0 0 0 4\n1 0 0\n0 1 0\n3 0 1 2\n", 10, 0,
                "line 10: vertex 0 has '4' behind its last property"},
        Refusal{"EndsInVertices", header() + "0 0 0\n100000 0 0\n", -1, -1, "the file ends before vertex 2 of 3"},
        Refusal{"EndsInFaces", header("3", "2") + triangle + "3 0 1 2\n", -1, -1, "the file ends before face 1 of 2"},
        Refusal{"CornerMissing", header() + triangle + "3 0 1\n", 13, 0, "line 13: face 0 has fewer values"},
        Refusal{"WordCorner", header() + triangle + "3 0 1 x\n", 13, 0, "line 13: face 0 has 'x', which is no whole"},
        Refusal{"NegativeSize", header() + triangle + "-3 0 1 2\n", 13, 0, "line 13: face 0 has a list of -3 items"},
        Refusal{"OutOfRange", header() + triangle + "3 0 1 3\n", 13, 0,
                "line 13: face 0 has the index 3, but the file"},
        Refusal{"MoreFollows", header() + triangle + "3 0 1 2\n3 0 1 2\n", 14, -1,
                "line 14: more follows than the header"},
        Refusal{"LineWithCrlf", crlf(header() + triangle + "3 0 1 3\n"), 13, 0, "line 13: face 0 has the index 3"},
        Refusal{"TwoCorners", header() + triangle + "2 0 1\n", 13, 0, "line 13: face 0 has 2 corners, fewer than 3",
                ErrorCode::bad_mesh},
        Refusal{"Repeated", header() + triangle + "3 0 1 0\n", 13, 0, "line 13: face 0 has vertex 0 twice",
                ErrorCode::bad_mesh},
        Refusal{"BinaryInfinity", patched(16, raw_bytes(std::numeric_limits<float>::infinity())), -1, 1,
                at_data(16) + "vertex 1 has a coordinate that is no finite number"},
        Refusal{"BinaryCutOff", binary(false).substr(0, data + 47), -1, 0,
                at_data(36) + "face 0 is cut off by the end"},
        Refusal{"BinaryOutOfRange", patched(41, raw_bytes(std::int32_t{-1})), -1, 0,
                at_data(41) + "face 0 has the index -1"},
        Refusal{"BinaryLongList", patched(36, "\xff"), -1, 0, at_data(36) + "face 0 is cut off"},
        Refusal{"BinaryMoreFollows", binary(false) + "\n!", -1, -1,
                at_data(49) + "more follows than the header announces"},
        Refusal{"BinaryRepeated", patched(41, raw_bytes(std::int32_t{0})), -1, 0,
                at_data(36) + "face 0 has vertex 0 twice", ErrorCode::bad_mesh}),
    refusal_name);

TEST(Ply, ReadsBackTheZoo) {
    for (const auto& [name, mesh] : zoo()) {
        SCOPED_TRACE(name);
        expect_identical(mesh, get(read(write_mesh(mesh, MeshFormat::ply).value())));
    }
}

TEST(Ply, WritesWhatEverybodyReads) {
    const PolygonMesh mesh = get(read(header() + triangle + "3 2 0 1\n"));
    EXPECT_EQ(
        write_mesh(mesh, MeshFormat::ply).value(),
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\nelement "
        "face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0.10000000000000001\n3 2 0 1\n");
    const PolygonMesh large = make_face(regular_polygon(256));
    const std::string text = write_mesh(large, MeshFormat::ply).value();
    EXPECT_NE(text.find("list uint int"), std::string::npos);
    expect_identical(large, get(read(text)));
}

}  // namespace
}  // namespace polylap::test

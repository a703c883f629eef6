#include "polylap/mesh/mesh_io.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <random>
#include <string>
#include <vector>

namespace polylap {
namespace {

using Face = std::vector<Index>;
using namespace std::string_literals;

Result<PolygonMesh> read(const std::string& text, Monitor monitor = {}) {
    return read_obj(std::as_bytes(std::span(text)), monitor);
}

std::vector<Face> faces_of(const PolygonMesh& mesh) {
    std::vector<Face> faces;
    for (Index f = 0; f < mesh.face_count(); ++f)
        faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
    return faces;
}

std::vector<double> coordinates_of(const PolygonMesh& mesh) {
    return {mesh.positions().data(), mesh.positions().data() + mesh.positions().size()};
}

/// Four vertices, in lines 1 to 4.
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::vector<double> square_coordinates = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

// What is refused

struct Refusal {
    std::string name, text;
    std::int64_t line, element;
    std::string message;  ///< All of it, or how it starts.
};

void PrintTo(const Refusal& refusal, std::ostream* stream) {
    *stream << refusal.name;
}

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, NamesLineAndElement) {
    const auto& [name, text, line, element, message] = GetParam();
    const auto mesh = read(text);
    ASSERT_FALSE(mesh.ok());
    const bool repairable = message.find(", fewer than 3") != std::string::npos || message.ends_with(" twice");
    EXPECT_EQ(mesh.error().code, repairable ? ErrorCode::bad_mesh : ErrorCode::parse_error);
    EXPECT_EQ(mesh.error().line, line) << mesh.error().message;
    EXPECT_EQ(mesh.error().element, element) << mesh.error().message;
    EXPECT_EQ(mesh.error().message.substr(0, message.size()), message);
}

std::string binary_stl() {
    std::string text(84 + 50, '\0');
    text.replace(0, 12, "exported by…", 12);
    text[80] = 1;
    return text;
}

INSTANTIATE_TEST_SUITE_P(
    Coordinates, Refused,
    testing::Values(
        Refusal{"NaN", "v 0 0 0\nv 1 nan 0\n", 2, 1, "line 2: vertex 1 has 'nan', which is no finite number"},
        Refusal{"Infinity", "v 0 0 inf\n", 1, 0, "line 1: vertex 0 has 'inf', which is no finite number"},
        Refusal{"TooLarge", "\n# c\nv 1e999 0 0\n", 3, 0, "line 3: vertex 0 has '1e999', which is no finite number"},
        Refusal{"Word", "v 0 abc 0\n", 1, 0, "line 1: vertex 0 has 'abc', which is no finite number"},
        Refusal{"TrailingLetters", "v 0 1x 0\n", 1, 0, "line 1: vertex 0 has '1x', which is no finite number"},
        Refusal{"DecimalComma", "v 0,5 1 0\n", 1, 0, "line 1: vertex 0 has '0,5', which is no finite number"},
        Refusal{"TwoSigns", "v +-1 1 0\n", 1, 0, "line 1: vertex 0 has '+-1', which is no finite number"},
        Refusal{"Hexadecimal", "v 0x10 1 0\n", 1, 0, "line 1: vertex 0 has '0x10', which is no finite number"},
        Refusal{"BadColour", "v 0 0 0 1 1 red\n", 1, 0, "line 1: vertex 0 has 'red', which is no finite number"},
        Refusal{"TwoCoordinates", square + "v 1 2\n", 5, 4, "line 5: vertex 4 has only 2 of 3 coordinates"},
        Refusal{"CutByComment", square + "v 1 2 # 3\n", 5, 4, "line 5: vertex 4 has only 2 of 3 coordinates"},
        Refusal{"NoCoordinates", "v\n", 1, 0, "line 1: vertex 0 has no coordinates"},
        Refusal{"ControlCharacters", "v 0 \x1b[31m\xff 0\n", 1, 0,
                "line 1: vertex 0 has '?[31m?', which is no finite number"},
        Refusal{"LongToken", "v 0 " + std::string(5000, 'z') + " 0\n", 1, 0,
                "line 1: vertex 0 has 'zzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzz…', which is no finite number"}),
    [](const auto& param_info) { return param_info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Corners, Refused,
    testing::Values(
        Refusal{"ZeroIndex", square + "f 1 2 0\n", 5, 0, "line 5: face 0 has the corner '0' with an index 0;"},
        Refusal{"ZeroTexture", square + "f 1/1 2/0 3/1\n", 5, 0,
                "line 5: face 0 has the corner '2/0' with an index 0;"},
        Refusal{"ZeroNormal", square + "f 1//1 2//0 3//1\n", 5, 0,
                "line 5: face 0 has the corner '2//0' with an index 0;"},
        Refusal{"TooHigh", square + "f 1 2 3\nf 1 2 5\n", 6, 1,
                "line 6: face 1 has the index 5 (counted from 1, as in the file), but the file has 4 vertices"},
        Refusal{"FirstTooHigh", square + "f 1 2 7\nf 1 2 9\nf 1 2 3\n", 5, 0, "line 5: face 0 has the index 7"},
        Refusal{"TooHighAmongLater", "f 1 2 3\nf 1 2 5\n" + square, 2, 1, "line 2: face 1 has the index 5"},
        Refusal{"TooLow", square + "f -1 -2 -5\n", 5, 0,
                "line 5: face 0 has the corner '-5', but only 4 vertices stand before it"},
        Refusal{"RelativeForward", "f -1 -2 -3\n" + square, 1, 0,
                "line 1: face 0 has the corner '-1', but only 0 vertices stand before it"},
        Refusal{"Fraction", square + "f 1 2 3.5\n", 5, 0,
                "line 5: face 0 has the corner '3.5', which is none of v, v/vt, v//vn, v/vt/vn"},
        Refusal{"Word", square + "f 1 2 x\n", 5, 0, "line 5: face 0 has the corner 'x',"},
        Refusal{"PlusSign", square + "f 1 2 +3\n", 5, 0, "line 5: face 0 has the corner '+3',"},
        Refusal{"TextureWord", square + "f 1/x/2 2/1/1 3/1/1\n", 5, 0, "line 5: face 0 has the corner '1/x/2',"},
        Refusal{"OpenSlash", square + "f 1/ 2/ 3/\n", 5, 0, "line 5: face 0 has the corner '1/',"},
        Refusal{"OpenSlashes", square + "f 1// 2// 3//\n", 5, 0, "line 5: face 0 has the corner '1//',"},
        Refusal{"FourFields", square + "f 1/1/1/1 2 3\n", 5, 0, "line 5: face 0 has the corner '1/1/1/1',"},
        Refusal{"NoVertexField", square + "f /1 2 3\n", 5, 0, "line 5: face 0 has the corner '/1',"},
        Refusal{"HugeIndex", square + "f 1 2 99999999999\n", 5, 0,
                "line 5: face 0 has the corner '99999999999' with an index out of range"},
        Refusal{"WrapsTo3", square + "f 1 2 4294967299\n", 5, 0,
                "line 5: face 0 has the corner '4294967299' with an index out of range"},
        Refusal{"LowestInt", square + "f 1 2 -2147483648\n", 5, 0,
                "line 5: face 0 has the corner '-2147483648', but only 4"},
        Refusal{"TwoCorners", square + "f 1 2 3\nf 1 2\n", 6, 1, "line 6: face 1 has 2 corners, fewer than 3"},
        Refusal{"NoCorners", square + "f\n", 5, 0, "line 5: face 0 has 0 corners, fewer than 3"},
        Refusal{"Repeated", square + "f 1 2 3 4\nf 1 2 3\nf 4 2 3 2\n", 7, 2, "line 7: face 2 has vertex 1 twice"},
        Refusal{"RepeatedRelative", square + "f 1 2 -4\n", 5, 0, "line 5: face 0 has vertex 0 twice"},
        Refusal{"RepeatedForward", "f 3 2 3\n" + square, 1, 0, "line 1: face 0 has vertex 2 twice"},
        Refusal{"InContinuation", square + "f 1 2 \\\n 3 \\\n x\nf 1 2 3\n", 5, 0,
                "line 5: face 0 has the corner 'x',"},
        Refusal{"AfterContinuation", square + "f 1 2 \\\n 3 \\\r\n 4\nf 1 2\n", 8, 1,
                "line 8: face 1 has 2 corners, fewer than 3"},
        Refusal{"CarriageReturns", "v 0 0 0\rv 1 0 0\r\rf 1 2\r", 4, 0, "line 4: face 0 has 2 corners, fewer than 3"},
        Refusal{"ZeroByte", square + "f 1 2 3\nf 1 \0 2\n"s, 6, -1,
                "line 6: a zero byte: this is a binary file, not an OBJ file"}),
    [](const auto& param_info) { return param_info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    WholeFile, Refused,
    testing::Values(Refusal{"Empty", "", -1, -1, "the file is empty"},
                    Refusal{"Blank", " \n\t\r\n", -1, -1, "the file is empty"},
                    Refusal{"OnlyMark", "\xEF\xBB\xBF", -1, -1, "the file is empty"},
                    Refusal{"NoFaces", square, -1, -1, "the file has no faces, only 4 vertices"},
                    Refusal{"OtherText", "Dear reader,\nthis is a letter.\n", -1, -1,
                            "this is not an OBJ file: it has neither v nor f lines"},
                    Refusal{"NoVertices", "f 1 2 3\n", 1, 0, "line 1: face 0 has the index 3"},
                    Refusal{"Html", "\n  <!DOCTYPE html><html><body>Not found</body></html>", -1, -1,
                            "this is an HTML page, not an OBJ file"},
                    Refusal{"HtmlTag", "<HTML>\n", -1, -1, "this is an HTML page, not an OBJ file"},
                    Refusal{"HtmlWithMark", "\xEF\xBB\xBF<!doctype html>", -1, -1,
                            "this is an HTML page, not an OBJ file"},
                    Refusal{"Xml", "<?xml version=\"1.0\"?>\n", -1, -1, "this is an XML or HTML file, not an OBJ file"},
                    Refusal{"Json", "{\"asset\": {}}", -1, -1, "this is a JSON file, not an OBJ file"},
                    Refusal{"Ply", "ply\nformat ascii 1.0\n", -1, -1, "this is a PLY file, not an OBJ file"},
                    Refusal{"Off", "OFF\n3 1 0\n", -1, -1, "this is an OFF file, not an OBJ file"},
                    Refusal{"OffBinary", "OFF BINARY\n\0\0"s, -1, -1, "this is an OFF file, not an OBJ file"},
                    Refusal{"StlText", "solid cube\n", -1, -1, "this is an STL file, not an OBJ file"},
                    Refusal{"StlBinary", binary_stl(), -1, -1, "this is an STL file, not an OBJ file"},
                    Refusal{"Zip", "PK\x03\x04rest", -1, -1, "this is a ZIP archive, not an OBJ file"},
                    Refusal{"Gzip", "\x1f\x8b\x08", -1, -1, "this is a gzip archive, not an OBJ file"},
                    Refusal{"Utf16", "\xff\xfev\0 \0"s, -1, -1, "this is UTF-16 text, not an OBJ file"}),
    [](const auto& param_info) { return param_info.param.name; });

// What is understood

struct Accepted {
    std::string name, text;
    std::vector<Face> faces;
    std::vector<double> coordinates;
};

void PrintTo(const Accepted& accepted, std::ostream* stream) {
    *stream << accepted.name;
}

class Understood : public testing::TestWithParam<Accepted> {};

TEST_P(Understood, GivesFacesAndCoordinates) {
    const auto& [name, text, faces, coordinates] = GetParam();
    const auto mesh = read(text);
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    EXPECT_EQ(faces_of(*mesh), faces);
    EXPECT_EQ(coordinates_of(*mesh), coordinates);
}

INSTANTIATE_TEST_SUITE_P(
    Features, Understood,
    testing::Values(
        Accepted{"Quad", square + "f 1 2 3 4\n", {{0, 1, 2, 3}}, square_coordinates},
        Accepted{"NoLastLineEnd", square + "f 1 2 3 4", {{0, 1, 2, 3}}, square_coordinates},
        Accepted{"MixedForms",
                 square + "vt 0 0\nvn 0 0 1\nf 1 2/1 3//1 4/1/1\nf 1/9 2//-9 3\n",
                 {{0, 1, 2, 3}, {0, 1, 2}},
                 square_coordinates},
        Accepted{"Negative",
                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 3 -1\n",
                 {{0, 1, 2}, {0, 2, 3}},
                 square_coordinates},
        Accepted{"FacesFirst", "f 1 2 3 4\n" + square, {{0, 1, 2, 3}}, square_coordinates},
        Accepted{"Interleaved",
                 "v 0 0 0\nf 1 3 4\nv 1 0 0\nv 1 1 0\nf 1 2 3\nv 0 1 0\n",
                 {{0, 2, 3}, {0, 1, 2}},
                 square_coordinates},
        Accepted{"Crlf",
                 "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\n\r\nf 1 2 3 4\r\n",
                 {{0, 1, 2, 3}},
                 square_coordinates},
        Accepted{"Cr", "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r", {{0, 1, 2, 3}}, square_coordinates},
        Accepted{"TabsAndBlanks",
                 "\tv\t0\t0 0 \n  v  1 0 0\t\nv 1 1 0\nv 0 1 0\n \t f\t1  2\t3 4 \t\n",
                 {{0, 1, 2, 3}},
                 square_coordinates},
        Accepted{"ByteOrderMark", "\xEF\xBB\xBF" + square + "f 1 2 3 4\n", {{0, 1, 2, 3}}, square_coordinates},
        Accepted{"Comments",
                 "# v 9 9 9\nv 0 0 0 # first\nv 1 0 0#x\nv 1 1 0\nv 0 1 0\n  # f 1 2 3\nf 1 2 3 4 # 1\nf 1 2 3#\n",
                 {{0, 1, 2, 3}, {0, 1, 2}},
                 square_coordinates},
        Accepted{"Continuations",
                 "v 0 \\\n0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf \\\n1 2\\\n3 \\\r\n4\n",
                 {{0, 1, 2, 3}},
                 square_coordinates},
        Accepted{"ContinuationAtEnd", square + "f 1 2 3 4 \\", {{0, 1, 2, 3}}, square_coordinates},
        Accepted{"ContinuedKeyword",
                 "v\\\n0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf\\\n1 2 3 4\n",
                 {{0, 1, 2, 3}},
                 square_coordinates},
        Accepted{"BackslashesElsewhere",
                 "# C:\\\nv 0 0 0\nmtllib C:\\new\\\nv 1 0 0\nv 1 1 0\ng a\\\nv 0 1 0\nusemtl b\\\nf 1 2 3 4\n",
                 {{0, 1, 2, 3}},
                 square_coordinates},
        Accepted{"OtherLines",
                 "mtllib a.mtl\no part\ng one two\ns off\nusemtl\ng\n" + square +
                     "vp 1\nl 1 2\np 1\nparm u 0 1\ncurv 0 1 \\\n 1 2\nfo 1 2 3\nV 1\nf 1 2 3 4\nend\n",
                 {{0, 1, 2, 3}},
                 square_coordinates},
        Accepted{"WeightsAndColours",
                 "v 0 0 0 2\nv 1 0 0 .1 .2 .3\nv 1 1 0 1 .1 .2 .3\nv 0 1 0\nf 1 2 3 4\n",
                 {{0, 1, 2, 3}},
                 square_coordinates},
        Accepted{"Numbers",
                 "v +1 -.5 1.\nv 1e3 1E-3 -1.5e+2\nv 00012 0.1 1e-400\nf 1 2 3\n",
                 {{0, 1, 2}},
                 {1, -.5, 1, 1e3, 1e-3, -150, 12, .1, 0}},
        Accepted{"LongExponents",
                 "v 1e-99999999999 0e99999999999 1e-2147483649\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                 {{0, 1, 2}},
                 {0, 0, 0, 1, 0, 0, 0, 1, 0}},
        Accepted{"Unreferenced", square + "f 1 2 3\n", {{0, 1, 2}}, square_coordinates},
        Accepted{"HighBytes", "# \xff\xfe\xe4\n" + square + "g \xff\nf 1 2 3 4\n", {{0, 1, 2, 3}}, square_coordinates}),
    [](const auto& param_info) { return param_info.param.name; });

TEST(MeshIo, RoundsCorrectly) {
    // Halfway between two doubles and just above; and the smallest and the largest there are.
    const auto mesh = read(
        "v 9007199254740993 9007199254740993.0000000000000000000000000000000001 0.1\n"
        "v 4.9406564584124654e-324 2.2250738585072011e-308 1.7976931348623157e308\n"
        "v 0.30000000000000004 -0 123456789.123456789\nf 1 2 3\n");
    ASSERT_TRUE(mesh.ok());
    EXPECT_EQ(coordinates_of(*mesh),
              (std::vector<double>{9007199254740992., 9007199254740994., 0.1, std::numeric_limits<double>::denorm_min(),
                                   0x0.fffffffffffffp-1022, std::numeric_limits<double>::max(), 0.1 + 0.2, 0,
                                   123456789.12345679}));
    EXPECT_TRUE(std::signbit(mesh->positions()(2, 1)));
}

TEST(MeshIo, KeepsFacesOfAnySize) {
    for (const Index corners : {24, 25, 1000, 70000}) {
        std::string text, face = "f";
        Face expected;
        for (Index i = 0; i < corners; ++i) {
            const double angle = 2 * std::acos(-1.0) * i / corners;
            text += "v " + std::to_string(std::cos(angle)) + ' ' + std::to_string(std::sin(angle)) + " 0\n";
            face += ' ' + std::to_string(i + 1);
            expected.push_back(i);
        }
        const auto mesh = read(text + face + '\n');
        ASSERT_TRUE(mesh.ok()) << mesh.error().message;
        EXPECT_EQ(faces_of(*mesh), std::vector<Face>{expected});

        const auto repeated = read(text + face + " 7\n");
        ASSERT_FALSE(repeated.ok());
        EXPECT_EQ(repeated.error().message, "line " + std::to_string(corners + 1) + ": face 0 has vertex 6 twice");
    }
}

// Writing

TEST(MeshIo, WritesPlainObj) {
    const auto mesh = read(square + "v 0.1 -1e300 1e-7\nf 1/1 2/1 3/1 4/1\nf -1 1 2\n");
    ASSERT_TRUE(mesh.ok());
    EXPECT_EQ(write_obj(*mesh).value(),
              square + "v 0.10000000000000001 -1.0000000000000001e+300 9.9999999999999995e-08\nf 1 2 3 4\nf 5 1 2\n");
}

/// Random bit patterns: all exponents, denormals and both zeros among them.
PolygonMesh random_mesh(Index vertices) {
    std::mt19937_64 random(20240607);
    Points points(vertices, 3);
    for (double& coordinate : points.reshaped()) {
        do {
            const std::uint64_t bits = random();
            const bool denormal = bits % 8 == 0;
            coordinate = std::bit_cast<double>(denormal ? bits & 0x800fffffffffffff : bits);
        } while (!std::isfinite(coordinate));
    }
    points.row(0) << 1e300, -1e-300, 0.0;
    points.row(1) << -0.0, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::lowest();
    std::vector<Index> offsets{0}, corners;
    for (Index v = 0; v + 5 < vertices; v += 3) {
        for (Index k = 0; k < 3 + v % 3; ++k)
            corners.push_back((v + 5 * k) % vertices);
        offsets.push_back(static_cast<Index>(corners.size()));
    }
    auto mesh = PolygonMesh::create(points, offsets, corners);
    EXPECT_TRUE(mesh.ok()) << mesh.error().message;
    return *std::move(mesh);
}

void expect_identical(const PolygonMesh& a, const PolygonMesh& b) {
    EXPECT_EQ(faces_of(a), faces_of(b));
    ASSERT_EQ(a.vertex_count(), b.vertex_count());
    for (Index v = 0; v < a.vertex_count(); ++v)
        for (Index k = 0; k < 3; ++k)
            ASSERT_EQ(std::bit_cast<std::uint64_t>(a.positions()(v, k)),
                      std::bit_cast<std::uint64_t>(b.positions()(v, k)))
                << "vertex " << v;
}

TEST(MeshIo, ReadsBackTheSameBits) {
    const PolygonMesh mesh = random_mesh(5000);
    const auto again = read(write_obj(mesh).value());
    ASSERT_TRUE(again.ok()) << again.error().message;
    expect_identical(mesh, *again);
}

/// Digits as a German reads them.
struct CommaPunctuation : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(MeshIo, KnowsNoLocale) {
    const PolygonMesh mesh = random_mesh(100);
    const std::string text = write_obj(mesh).value();
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation));
    for (const char* name :
         {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"})  // where installed, C's own functions write commas too
        if (std::setlocale(LC_ALL, name) != nullptr) break;
    const std::string written = write_obj(mesh).value();
    const auto again = read(text);
    std::setlocale(LC_ALL, "C");
    std::locale::global(before);
    EXPECT_EQ(written, text);
    ASSERT_TRUE(again.ok()) << again.error().message;
    expect_identical(mesh, *again);
}

// Progress and cancellation

/// Long enough to be stopped in the middle of its vertices and of its faces.
std::string large_text() {
    std::string text = write_obj(random_mesh(20000)).value();
    const std::string faces = text.substr(text.find("f "));
    for (int copy = 0; copy < 5; ++copy)
        text += faces;
    return text;
}

TEST(MeshIo, ReportsProgress) {
    const std::string text = large_text();
    std::vector<double> fractions;
    const auto mesh = read(text, {[](void* user, double fraction) {
                                      static_cast<std::vector<double>*>(user)->push_back(fraction);
                                      return true;
                                  },
                                  &fractions});
    ASSERT_TRUE(mesh.ok());
    ASSERT_GT(fractions.size(), 10u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_GE(fractions.front(), 0);
    EXPECT_GT(fractions.back(), 0.8);
    EXPECT_LE(fractions.back(), 1);
}

TEST(MeshIo, StopsWheneverTheMonitorSaysSo) {
    const std::string text = large_text();
    struct State {
        int calls = 0, stop_at = 0;
    };
    const auto tick = [](void* user, double) {
        auto& state = *static_cast<State*>(user);
        return ++state.calls != state.stop_at;
    };
    State all;
    ASSERT_TRUE(read(text, {tick, &all}).ok());
    for (int stop_at = 1; stop_at <= all.calls; ++stop_at) {
        State state{0, stop_at};
        const auto mesh = read(text, {tick, &state});
        ASSERT_FALSE(mesh.ok());
        EXPECT_EQ(mesh.error().code, ErrorCode::cancelled);
        EXPECT_EQ(state.calls, stop_at) << "asked again after it had said stop";
    }
}

}  // namespace
}  // namespace polylap

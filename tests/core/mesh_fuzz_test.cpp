// Mutations of small files of each format, the same on every run: whatever comes in, the reader gives a sound mesh or
// says what is wrong.
#include <algorithm>

#include "mesh_files.hpp"
#include "polylap/mesh/repair.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

struct Case {
    std::string name;
    MeshFormat format;
    std::vector<std::string> seeds, snippets;
    int sound, refused;  ///< The mutations reach both ends at least so often.
};

void PrintTo(const Case& one, std::ostream* stream) {
    *stream << one.name;
}

std::string binary_off(bool big) {
    std::string bytes = "OFF BINARY\n";
    for (const std::int32_t count : {4, 2, 0})
        bytes += raw_bytes(count, big);
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f})
        bytes += raw_bytes(x, big);
    for (const std::int32_t number : {4, 0, 1, 2, 3, 3, 0, 1, 2})
        bytes += raw_bytes(number, big);
    return bytes;
}

std::string binary_ply(bool big) {
    std::string bytes = std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
                        " 1.0\nelement vertex 3\nproperty short x\nproperty float y\nproperty uchar z\nelement face 2\n"
                        "property list uchar int vertex_index\nproperty list ushort double uv\nend_header\n";
    for (const int k : {0, 1, 2})
        bytes += raw_bytes(static_cast<std::int16_t>(k), big) + raw_bytes(static_cast<float>(k * k), big) + "\5";
    for (int f = 0; f < 2; ++f) {
        bytes += "\3";
        for (const std::int32_t k : {0, 1, 2})
            bytes += raw_bytes(k, big);
        bytes += raw_bytes(std::uint16_t{1}, big) + raw_bytes(0.5, big);
    }
    return bytes;
}

const std::vector<std::string> numbers = {
    "\n", "\r", "\r\n", "#",     " ",          "\t",          "-",           "+",    ".",     "e",          "0",
    "1",  "-1", "nan",  "1e999", "2147483647", "-2147483648", "99999999999", "\xff", "\n3 0", "\n0 1 2 3\n"};

std::vector<std::string> joined(std::vector<std::string> more) {
    more.insert(more.end(), numbers.begin(), numbers.end());
    return more;
}

std::vector<Case> cases() {
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n";
    const std::string text_stl = "solid a\n" + facet + "endsolid\n";
    const PolygonMesh triangles = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
    const std::string binary_stl = write_mesh(triangles, MeshFormat::stl).value();
    return {
        {"Off",
         MeshFormat::off,
         {"OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2 255 0 0\n",
          "# c\r\nCNOFF 3 1 # d\r\n0 0 0 1 1 1 1\r\n1 0 0\r\n0 1 0 nan\r\n3 0 1 2\r\n", binary_off(false),
          binary_off(true)},
         joined({"OFF", "COFF", "nOFF", " BINARY\n", std::string(4, '\0')}),
         1000,
         10000},
        {"Ply",
         MeshFormat::ply,
         {write_mesh(triangles, MeshFormat::ply).value(),
          "ply\r\nformat ascii 1.0\r\ncomment c\r\nelement a 1\r\nproperty list uchar float b\r\nelement vertex 3\r\n"
          "property int x\r\nproperty float y\r\nproperty float z\r\nelement face 1\r\nproperty list uchar int "
          "vertex_index\r\nend_header\r\n2 .5 .5\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n",
          binary_ply(false), binary_ply(true)},
         joined({"property int a\n", "element b 1\n", "comment d\n", "list", "uchar", "double", "end_header\n"}),
         200,  // most mutations hit the header
         5000},
        {"Stl",
         MeshFormat::stl,
         {text_stl, "SOLID\r\n" + facet + facet + "ENDSOLID a\r\n", binary_stl},
         joined({"solid", "facet", "vertex 0 0 0\n", "endloop", "endsolid\n", std::string(50, '\0')}),
         1000,
         5000}};
}

void expect_sound(const PolygonMesh& mesh) {
    ASSERT_GE(mesh.face_count(), 1);
    ASSERT_TRUE(mesh.positions().allFinite());
    for (Index f = 0; f < mesh.face_count(); ++f) {
        Face corners(mesh.face(f).begin(), mesh.face(f).end());
        ASSERT_GE(corners.size(), 3u);
        std::sort(corners.begin(), corners.end());
        ASSERT_GE(corners.front(), 0);
        ASSERT_LT(corners.back(), mesh.vertex_count());
        ASSERT_EQ(std::adjacent_find(corners.begin(), corners.end()), corners.end());
    }
}

class MeshFuzz : public testing::TestWithParam<Case> {};

TEST_P(MeshFuzz, GivesASoundMeshOrSaysWhatIsWrong) {
    const Case& one = GetParam();
    std::mt19937 random(815);
    int sound = 0, refused = 0;
    for (int round = 0; round < 20000; ++round) {
        const std::string text = mutate(one.seeds[random() % one.seeds.size()], one.snippets, random);
        const std::vector<char> exact(text.begin(), text.end());  // a sanitizer sees reads past its end
        SCOPED_TRACE("round " + std::to_string(round) + ": " + testing::PrintToString(text));
        const auto mesh = read_mesh(std::as_bytes(std::span(exact)), one.format);
        const auto raw = read_raw(std::as_bytes(std::span(exact)), one.format);
        if (raw) {
            const auto repaired = repair(*raw);
            if (repaired)
                expect_sound(repaired->mesh);
            else
                ASSERT_EQ(repaired.error().code, ErrorCode::bad_mesh);
        }
        if (mesh) {
            ++sound;
            ASSERT_TRUE(raw.ok());
            expect_sound(*mesh);
            if (one.format != MeshFormat::stl)
                expect_identical(*mesh, get(read_mesh(bytes_of(write_mesh(*mesh, one.format).value()), one.format)));
            continue;
        }
        ++refused;
        const Error& error = mesh.error();
        // The other way around does not hold: something that is no matter of repair may come later in the file.
        ASSERT_TRUE(!raw.ok() || error.code == ErrorCode::bad_mesh) << error.message;
        ASSERT_TRUE(error.code == ErrorCode::parse_error || error.code == ErrorCode::bad_mesh) << error.message;
        ASSERT_TRUE(std::all_of(error.message.begin(), error.message.end(),
                                [](char c) { return static_cast<unsigned char>(c) >= ' '; }));
        if (error.line >= 1) {
            ASSERT_LE(error.line,
                      1 + std::count_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }));
            ASSERT_TRUE(error.message.starts_with("line " + std::to_string(error.line) + ": "));
        } else {
            ASSERT_EQ(error.line, -1);
            ASSERT_TRUE(error.message.starts_with("the file ") || error.message.starts_with("this is ") ||
                        error.message.starts_with("byte "))
                << error.message;
        }
    }
    EXPECT_GT(sound, one.sound);
    EXPECT_GT(refused, one.refused);
}

/// A file that was cut off is never taken for a whole one, but for a line end or the last digit of a text.
TEST_P(MeshFuzz, NoticesTruncation) {
    for (const std::string& seed : GetParam().seeds) {
        const PolygonMesh whole = get(read_mesh(bytes_of(seed), GetParam().format));
        for (std::size_t length = 0; length < seed.size(); ++length) {
            const auto part = read_mesh(std::as_bytes(std::span(seed).first(length)), GetParam().format);
            if (!part) continue;
            EXPECT_EQ(part->face_count(), whole.face_count());
            EXPECT_EQ(part->vertex_count(), whole.vertex_count());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshFuzz, testing::ValuesIn(cases()),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(MeshFiles, ReportProgressAndStop) {
    Points points(20000, 3);
    std::vector<Index> offsets{0}, corners;
    for (Index v = 0; v < points.rows(); ++v) {
        points.row(v) << v / 7.0, v % 7 / 3.0, v % 11;
        for (const Index k : {0, 1, 2})
            corners.push_back((v + k) % 20000);
        offsets.push_back(static_cast<Index>(corners.size()));
    }
    const PolygonMesh mesh = get(PolygonMesh::create(points, offsets, corners));
    for (const MeshFormat format : {MeshFormat::obj, MeshFormat::off, MeshFormat::ply, MeshFormat::stl}) {
        const std::string bytes = write_mesh(mesh, format).value();
        Ticks all;
        ASSERT_TRUE(read_mesh(bytes_of(bytes), format, all.monitor()).ok());
        EXPECT_GT(all.fractions.size(), 5u);
        EXPECT_TRUE(all.rise());
        for (std::size_t stop_at = 1; stop_at <= all.fractions.size(); ++stop_at) {
            Ticks ticks;
            ticks.stop_at = stop_at;
            const auto stopped = read_raw(bytes_of(bytes), format, ticks.monitor());
            ASSERT_FALSE(stopped.ok());
            EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
            EXPECT_EQ(ticks.fractions.size(), stop_at);
        }
    }
}

TEST(MeshFiles, KnowFormatsByTheirEndings) {
    EXPECT_EQ(format_of("a.obj").value(), MeshFormat::obj);
    EXPECT_EQ(format_of("dir.off/b.PLY").value(), MeshFormat::ply);
    EXPECT_EQ(format_of("c.obj.Off").value(), MeshFormat::off);
    EXPECT_EQ(format_of("x.stl").value(), MeshFormat::stl);
    for (const char* name : {"", "a", ".obj", "obj", "a.obj.gz", "a.objx"}) {
        const auto format = format_of(name);
        ASSERT_FALSE(format.ok()) << name;
        EXPECT_EQ(format.error().code, ErrorCode::bad_argument);
        EXPECT_NE(format.error().message.find(".obj, .off, .ply or .stl"), std::string::npos);
    }
}

TEST(MeshFiles, ReadBackTheZooAsObj) {
    for (const auto& [name, mesh] : zoo()) {
        SCOPED_TRACE(name);
        const std::string text = write_mesh(mesh, MeshFormat::obj).value();
        EXPECT_EQ(text, write_obj(mesh).value());
        expect_identical(mesh, get(read_mesh(bytes_of(text), MeshFormat::obj)));
    }
}

TEST(MeshFiles, RawObjKeepsFacesThatNoMeshMayHave) {
    const RawMesh raw =
        get(read_raw(bytes_of("f\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf # none\nf 1 2 3\nf 2\nf -1 -2\nf\\\n\nf 1 2 3 2\nf\n"),
                     MeshFormat::obj));
    EXPECT_EQ(faces_of(raw), (std::vector<Face>{{}, {}, {0, 1, 2}, {1}, {2, 1}, {}, {0, 1, 2, 1}, {}}));
    const RawMesh bare = get(read_raw(bytes_of("v 0 0 0\nf\n"), MeshFormat::obj));
    EXPECT_EQ(faces_of(bare), std::vector<Face>{{}});
}

}  // namespace
}  // namespace polylap::test

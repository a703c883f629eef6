// Mutations of small OBJ texts, the same on every run: whatever comes in, the reader gives a sound mesh or says what is
// wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mesh_files.hpp"
#include "polylap/mesh/mesh_io.hpp"

namespace polylap {
namespace {

const std::vector<std::string> seeds = {
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n",
    "# two\r\nv -1.5e-3 .25 +7\r\nv 1 0 0 1\r\nv 1 1 0 .1 .2 .3\r\nv 0 1 0\r\nf -4 -3 -2\r\nf 1 3 4\r\n",
    "mtllib a.mtl\no part\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvn 0 0 1\ng a b\nusemtl c\ns 1\nf 1/1/1 2/1 3//1 # end\n",
    "\xEF\xBB\xBFv 0 0 \\\n0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 2\nf 1 2 \\\r\n3 \\\n4\nf\t1 3\t5\n",
    "f 1 2 3\nf 3 4 5 6 1\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9007199254740993 1e308 4.9e-324\nv 1 2 3",
};

const std::vector<std::string> snippets = {"\n",
                                           "\r",
                                           "\r\n",
                                           "\\\n",
                                           "\\",
                                           "#",
                                           " ",
                                           "\t",
                                           "/",
                                           "//",
                                           "-",
                                           "+",
                                           ".",
                                           "e",
                                           "0",
                                           "1",
                                           "-1",
                                           "99999999999",
                                           "1e999",
                                           "nan",
                                           "inf",
                                           "v",
                                           "f",
                                           "v ",
                                           "\nf ",
                                           "\nv 1 2 3\n",
                                           "f 1 2 3\n",
                                           "\xff",
                                           "1e-2147483649",
                                           "2147483647",
                                           "-2147483648"};

TEST(ObjFuzz, GivesASoundMeshOrSaysWhatIsWrong) {
    std::mt19937 random(4711);
    int accepted = 0, with_line = 0, whole_file = 0;
    for (int round = 0; round < 20000; ++round) {
        const std::string text = test::mutate(seeds[random() % seeds.size()], snippets, random);
        const std::vector<char> exact(text.begin(),
                                      text.end());  // no terminator behind the end: a sanitizer sees reads past it
        SCOPED_TRACE("round " + std::to_string(round) + ": " + testing::PrintToString(text));
        const auto mesh = read_obj(std::as_bytes(std::span(exact)));
        if (!mesh) {
            const Error& error = mesh.error();
            ASSERT_TRUE(error.code == ErrorCode::parse_error || error.code == ErrorCode::bad_mesh);
            ASSERT_FALSE(error.message.empty());
            ASSERT_TRUE(std::all_of(error.message.begin(), error.message.end(),
                                    [](char c) { return static_cast<unsigned char>(c) >= ' '; }));
            if (error.line >= 1) {
                ASSERT_LE(error.line,
                          1 + std::count_if(text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }));
                ASSERT_EQ(error.message.find("line " + std::to_string(error.line) + ": "), 0u);
                ++with_line;
            } else {
                ASSERT_EQ(error.line, -1);
                ASSERT_EQ(error.element, -1);
                ASSERT_TRUE(error.message.starts_with("the file ") || error.message.starts_with("this is "))
                    << error.message;
                ++whole_file;
            }
            continue;
        }
        ++accepted;
        ASSERT_GE(mesh->face_count(), 1);
        ASSERT_TRUE(mesh->positions().allFinite());
        for (Index f = 0; f < mesh->face_count(); ++f) {
            std::vector<Index> corners(mesh->face(f).begin(), mesh->face(f).end());
            ASSERT_GE(corners.size(), 3u);
            std::sort(corners.begin(), corners.end());
            ASSERT_GE(corners.front(), 0);
            ASSERT_LT(corners.back(), mesh->vertex_count());
            ASSERT_EQ(std::adjacent_find(corners.begin(), corners.end()), corners.end());
        }
        const std::string written = write_obj(*mesh).value();
        const auto again = read_obj(std::as_bytes(std::span(written)));
        ASSERT_TRUE(again.ok()) << again.error().message;
        ASSERT_EQ(again->positions(), mesh->positions());
        ASSERT_EQ(again->connectivity()->offsets, mesh->connectivity()->offsets);
        ASSERT_EQ(again->connectivity()->corners, mesh->connectivity()->corners);
    }
    // The mutations reach all three ends.
    EXPECT_GT(accepted, 2000);
    EXPECT_GT(with_line, 5000);
    EXPECT_GT(whole_file, 200);
}

/// Cutting a valid file anywhere never gives a face that the file does not have.
TEST(ObjFuzz, TruncationNeverInventsFaces) {
    for (const std::string& seed : seeds) {
        const auto whole = read_obj(std::as_bytes(std::span(seed)));
        ASSERT_TRUE(whole.ok()) << whole.error().message;
        for (std::size_t length = 0; length < seed.size(); ++length) {
            const auto part = read_obj(std::as_bytes(std::span(seed).first(length)));
            if (part) {
                EXPECT_LE(part->face_count(), whole->face_count());
                EXPECT_LE(part->vertex_count(), whole->vertex_count());
            } else {
                EXPECT_TRUE(part.error().code == ErrorCode::parse_error || part.error().code == ErrorCode::bad_mesh);
            }
        }
    }
}

}  // namespace
}  // namespace polylap

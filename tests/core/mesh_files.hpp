#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "polylap/mesh/mesh_io.hpp"

// What the tests of the formats of mesh files share.
namespace polylap::test {

using Face = std::vector<Index>;

inline std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text));
}

inline std::vector<Face> faces_of(const PolygonMesh& mesh) {
    std::vector<Face> faces;
    for (Index f = 0; f < mesh.face_count(); ++f)
        faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
    return faces;
}

inline std::vector<Face> faces_of(const RawMesh& raw) {
    std::vector<Face> faces;
    for (std::size_t f = 0; f + 1 < raw.offsets.size(); ++f)
        faces.emplace_back(raw.corners.begin() + raw.offsets[f], raw.corners.begin() + raw.offsets[f + 1]);
    return faces;
}

inline std::vector<double> coordinates_of(const Points& positions) {
    return {positions.data(), positions.data() + positions.size()};
}

inline void expect_identical(const PolygonMesh& a, const PolygonMesh& b) {
    EXPECT_EQ(faces_of(a), faces_of(b));
    ASSERT_EQ(a.vertex_count(), b.vertex_count());
    EXPECT_EQ(std::memcmp(a.positions().data(), b.positions().data(),
                          sizeof(double) * static_cast<std::size_t>(a.positions().size())),
              0);
}

/// A number as a binary file holds it.
template <class T>
std::string raw_bytes(T value, bool big_endian = false) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big_endian != (std::endian::native == std::endian::big)) bytes.assign(bytes.rbegin(), bytes.rend());
    return bytes;
}

struct Refusal {
    std::string name, bytes;
    std::int64_t line, element;
    std::string message;  ///< All of it, or how it starts.
    ErrorCode code = ErrorCode::parse_error;
};
inline void PrintTo(const Refusal& refusal, std::ostream* stream) {
    *stream << refusal.name;
}
inline std::string refusal_name(const testing::TestParamInfo<Refusal>& info) {
    return info.param.name;
}

inline void expect_refused(const Refusal& refusal, MeshFormat format) {
    const auto mesh = read_mesh(bytes_of(refusal.bytes), format);
    ASSERT_FALSE(mesh.ok());
    EXPECT_EQ(mesh.error().code, refusal.code) << mesh.error().message;
    EXPECT_EQ(mesh.error().line, refusal.line) << mesh.error().message;
    EXPECT_EQ(mesh.error().element, refusal.element) << mesh.error().message;
    EXPECT_EQ(mesh.error().message.substr(0, refusal.message.size()), refusal.message);
    // What is repairable, and only that, passes where repair begins.
    EXPECT_EQ(read_raw(bytes_of(refusal.bytes), format).ok(), refusal.code == ErrorCode::bad_mesh);
}

struct Accepted {
    std::string name, bytes;
    std::vector<Face> faces;
    std::vector<double> coordinates;
};
inline void PrintTo(const Accepted& accepted, std::ostream* stream) {
    *stream << accepted.name;
}
inline std::string accepted_name(const testing::TestParamInfo<Accepted>& info) {
    return info.param.name;
}

inline void expect_understood(const Accepted& accepted, MeshFormat format) {
    const auto mesh = read_mesh(bytes_of(accepted.bytes), format);
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    EXPECT_EQ(faces_of(*mesh), accepted.faces);
    EXPECT_EQ(coordinates_of(mesh->positions()), accepted.coordinates);
}

/// Changes a few bytes; the same ones for the same state of `random`.
inline std::string mutate(std::string text, const std::vector<std::string>& snippets, std::mt19937& random) {
    const auto below = [&random](std::size_t n) { return n == 0 ? 0 : random() % n; };
    for (std::size_t count = 1 + below(4); count > 0; --count) {
        const std::size_t at = below(text.size() + 1);
        switch (below(7)) {
            case 0:
                text.resize(at);
                break;
            case 1:
                if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
                break;
            case 2:
                if (at < text.size()) text[at] = static_cast<char>(below(256));
                break;
            case 3:
                text.erase(at, 1 + below(6));
                break;
            case 4:
                text.insert(at, snippets[below(snippets.size())]);
                break;
            case 5:
                text.insert(below(text.size() + 1), text.substr(at, below(20)));
                break;
            default:
                if (at < text.size()) std::swap(text[at], text[below(text.size())]);
        }
    }
    return text;
}

}  // namespace polylap::test

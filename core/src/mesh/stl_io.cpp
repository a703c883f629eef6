// STL holds triangles by the positions of their corners. Equal positions become one vertex.
#include <array>
#include <cmath>

#include "load_bytes.hpp"
#include "raw_builder.hpp"
#include "text_lines.hpp"
#include "weld.hpp"

namespace polylap::io {
namespace {

constexpr std::size_t header_bytes = 80, count_bytes = 4, facet_bytes = 50, normal_bytes = 12;

/// Text begins with `solid`, but so do the headers of some binary files, whose size then gives them away.
bool is_binary(std::string_view bytes) {
    if (bytes.size() >= header_bytes + count_bytes) {
        const std::uint64_t facets = load<std::uint32_t>(bytes, header_bytes, ByteOrder::little);
        if (bytes.size() == header_bytes + count_bytes + facet_bytes * facets) return true;
    }
    const bool solid = is_word(LineScanner(bytes).next_word(), "solid");
    return !solid || bytes.find('\0') != std::string_view::npos;
}

/// Collects facets, welding their corners.
class Facets {
public:
    explicit Facets(FaceRule rule) : builder_(rule, "facet") {}

    RawBuilder& builder() { return builder_; }

    std::optional<Error> add(Place place, const std::array<std::array<double, 3>, 3>& corners) {
        for (const auto& corner : corners) {
            const auto fresh = static_cast<Index>(builder_.vertex());
            const Index vertex = welder_.weld({corner[0], corner[1], corner[2]}, fresh);
            if (vertex == fresh) builder_.add_vertex(corner.data());
            if (auto error = builder_.add_corner(place, vertex)) return error;
        }
        return builder_.finish_face(place);
    }

    Result<RawMesh> finish() {
        const std::int64_t facets = builder_.face();
        if (facets == 0) return whole_file("the file has no facets");
        RawMesh raw = builder_.finish();
        raw.notes.push_back(std::to_string(3 * facets) + " corners welded to " + std::to_string(raw.positions.rows()) +
                            " vertices");
        return raw;
    }

private:
    RawBuilder builder_;
    Welder welder_;
};

Result<RawMesh> read_binary(std::string_view bytes, FaceRule rule, Ticker ticker) {
    if (bytes.size() < header_bytes + count_bytes)
        return fault(at_byte(bytes.size()), -1, "the file ends within the 84 bytes that begin a binary STL file");
    const std::int64_t count = load<std::uint32_t>(bytes, header_bytes, ByteOrder::little);
    std::size_t at = header_bytes + count_bytes;
    if (auto error = refuse_count(at_byte(header_bytes), count, "facets", facet_bytes, bytes.size() - at))
        return std::move(*error);
    Facets facets(rule);
    for (std::int64_t f = 0; f < count; ++f, at += facet_bytes) {
        std::array<std::array<double, 3>, 3> corners{};
        for (std::size_t i = 0; i < 9; ++i) {
            const std::size_t from = at + normal_bytes + sizeof(float) * i;
            corners[i / 3][i % 3] = load<float>(bytes, from, ByteOrder::little);
            if (!std::isfinite(corners[i / 3][i % 3]))
                return facets.builder().fault_of_face(at_byte(from), "has a coordinate that is no finite number");
        }
        if (auto error = facets.add(at_byte(at), corners)) return std::move(*error);
        if (!ticker.proceed(at)) return cancelled();
    }
    if (at != bytes.size())
        return fault(at_byte(at), -1,
                     "more follows than the " + std::to_string(count) + " facets that the header announces");
    return facets.finish();
}

class TextReader {
public:
    TextReader(std::string_view text, FaceRule rule, Ticker ticker) : words_(text), facets_(rule), ticker_(ticker) {}

    Result<RawMesh> run() {
        bool inside = false;
        for (auto word = words_.next_word(); !word.empty(); word = words_.next_word()) {
            if (is_word(word, inside ? "endsolid" : "solid")) {
                inside = !inside;
                words_.skip_line();  // the solid's name
            } else if (inside && is_word(word, "facet")) {
                if (auto error = read_facet()) return std::move(*error);
            } else {
                return fault(place(), -1,
                             quote(word) + " where " + (inside ? "facet or endsolid" : "solid") + " should stand");
            }
            if (!ticker_.proceed(words_.position())) return cancelled();
        }
        if (inside) return whole_file("the file ends without endsolid, so it may have lost facets");
        return facets_.finish();
    }

private:
    Place place() const { return at_line(words_.line()); }

    std::optional<Error> expect(std::string_view wanted) {
        const auto word = words_.next_word();
        if (is_word(word, wanted)) return std::nullopt;
        return misplaced(word, std::string(wanted));
    }

    Error misplaced(std::string_view word, const std::string& wanted) {
        return facets_.builder().fault_of_face(place(), (word.empty() ? "ends with the file" : "has " + quote(word)) +
                                                            " where " + wanted + " should stand");
    }

    std::optional<Error> read_facet() {
        const Place start = place();
        if (auto error = expect("normal")) return error;
        // The normal follows from the corners. That of a sliver may be nan.
        for (int k = 0; k < 3; ++k)
            words_.next_word();
        if (auto error = expect("outer")) return error;
        if (auto error = expect("loop")) return error;
        std::array<std::array<double, 3>, 3> corners{};
        for (auto& corner : corners) {
            if (auto error = expect("vertex")) return error;
            for (double& coordinate : corner) {
                const auto word = words_.next_word();
                if (word.empty()) return misplaced(word, "a coordinate");
                if (!parse_finite(word, coordinate))
                    return facets_.builder().fault_of_face(place(),
                                                           "has " + quote(word) + ", which is no finite number");
            }
        }
        if (auto error = expect("endloop")) return error;
        if (auto error = expect("endfacet")) return error;
        return facets_.add(start, corners);
    }

    LineScanner words_;
    Facets facets_;
    Ticker ticker_;
};

}  // namespace

Result<RawMesh> read_stl(std::string_view bytes, FaceRule rule, Monitor monitor) {
    const Ticker ticker(monitor, bytes.size());
    const std::string_view text = bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes;
    if (!is_binary(text)) return TextReader(text, rule, ticker).run();
    if (auto refusal = refuse_foreign(bytes, "an STL file"); !refusal.empty()) return whole_file(std::move(refusal));
    if (bytes.find('\0') == std::string_view::npos)
        return whole_file("this is not an STL file: it does not begin with solid, and a binary one has zero bytes");
    return read_binary(bytes, rule, ticker);
}

}  // namespace polylap::io

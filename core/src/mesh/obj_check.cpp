// The strict half of the OBJ reader. tinyobjloader turns broken input into other meshes without a word: what it would
// misread is refused here, with the line, before it sees anything.
#include "obj_check.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "obj_scanner.hpp"
#include "text_lines.hpp"

namespace polylap::obj {
namespace {

using io::fault;
using io::most;
using io::quote;
using io::whole_file;

enum class Corner { good, malformed, zero, too_large };

/// Reads `v`, `v/vt`, `v//vn` or `v/vt/vn`; only v is kept.
Corner parse_corner(std::string_view token, int& vertex) {
    const char* at = token.data();
    const char* const last = at + token.size();
    for (int field = 0; field < 3; ++field) {
        if (field > 0) {
            if (*at++ != '/') return Corner::malformed;
            if (field == 1 && at != last && *at == '/') continue;
        }
        int index = 0;
        const auto [rest, status] = std::from_chars(at, last, index);
        if (status == std::errc::result_out_of_range) return Corner::too_large;
        if (status != std::errc()) return Corner::malformed;
        if (index == 0) return Corner::zero;
        if (field == 0) vertex = index;
        at = rest;
        if (at == last) return Corner::good;
    }
    return Corner::malformed;
}

class Checker {
public:
    Checker(std::string_view text, io::FaceRule rule, Monitor monitor)
        : text_(text), rule_(rule), ticker_(monitor, text.size()), scanner_(text) {}

    Result<Script> run() {
        while (scanner_.next_statement()) {
            if (scanner_.keyword() == "v") {
                if (auto error = check_vertex()) return std::move(*error);
            } else if (scanner_.keyword() == "f") {
                if (auto error = check_face()) return std::move(*error);
            } else {
                scanner_.skip_line();
            }
            if (!ticker_.proceed(static_cast<std::size_t>(scanner_.position() - text_.data()))) return io::cancelled();
        }
        if (auto error = check_whole()) return std::move(*error);
        return std::move(script_);
    }

private:
    std::optional<Error> check_vertex() {
        const std::int64_t vertex = script_.vertices();
        const auto fail = [&](const std::string& what) {
            return fault(io::at_line(scanner_.line()), vertex, "vertex " + std::to_string(vertex) + " " + what);
        };
        int numbers = 0;
        for (auto token = scanner_.next_token(); !token.empty(); token = scanner_.next_token(), ++numbers) {
            double value = 0;
            if (!io::parse_finite(token, value)) return fail("has " + quote(token) + ", which is no finite number");
            if (numbers < 3) script_.coordinates.push_back(value);
        }
        if (numbers < 3)
            return fail(numbers == 0 ? "has no coordinates"
                                     : "has only " + std::to_string(numbers) + " of 3 coordinates");
        if (vertex == most) return fail("is one too many: a mesh holds at most " + std::to_string(most));
        scanner_.finish_statement();
        // Only that there is a vertex: tinyobjloader's own number parser does not round correctly (two of three doubles
        // written with 17 digits come back changed), overflows on long exponents, and would take three quarters of its
        // time.
        script_.statements.emplace_back("v \n");
        return std::nullopt;
    }

    std::optional<Error> check_face() {
        const std::int64_t face = script_.faces;
        const auto fail = [&](const std::string& what, ErrorCode code = ErrorCode::parse_error) {
            return fault(io::at_line(scanner_.line()), face, "face " + std::to_string(face) + " " + what, code);
        };
        corners_.clear();
        std::int64_t highest = 0;
        for (auto token = scanner_.next_token(); !token.empty(); token = scanner_.next_token()) {
            int index = 0;
            switch (parse_corner(token, index)) {
                case Corner::good:
                    break;
                case Corner::malformed:
                    return fail("has the corner " + quote(token) +
                                ", which is none of v, v/vt, v//vn, v/vt/vn with whole numbers");
                case Corner::zero:
                    return fail("has the corner " + quote(token) +
                                " with an index 0; indices in the file count from 1");
                case Corner::too_large:
                    return fail("has the corner " + quote(token) + " with an index out of range");
            }
            const std::int64_t vertex = index > 0 ? index - std::int64_t{1} : script_.vertices() + index;
            if (vertex < 0)
                return fail("has the corner " + quote(token) + ", but only " + std::to_string(script_.vertices()) +
                            " vertices stand before it");
            highest = std::max(highest, vertex);
            corners_.push_back(static_cast<Index>(vertex));
        }
        if (rule_ == io::FaceRule::sound)
            if (const auto what = io::unsound(corners_, scratch_); !what.empty())
                return fail(what, ErrorCode::bad_mesh);
        if (most - script_.corners < static_cast<std::int64_t>(corners_.size()))
            return fail("is one too many: a mesh holds at most " + std::to_string(most) + " corners");
        // A face may come before its vertices, so its range can be checked at the end only. The first face beyond any
        // count is one that reaches further than all faces before it.
        if (highest >= script_.vertices() && (reaches_.empty() || highest > reaches_.back().vertex))
            reaches_.push_back({highest, face, scanner_.line()});
        scanner_.finish_statement();
        if (corners_.empty()) {
            script_.bare_faces.push_back(script_.faces);
        } else {
            for (const std::string_view piece : scanner_.pieces())
                append(piece);
        }
        script_.corners += static_cast<std::int64_t>(corners_.size());
        ++script_.faces;
        return std::nullopt;
    }

    std::optional<Error> check_whole() const {
        const std::int64_t vertices = script_.vertices();
        if (script_.faces == 0)
            return whole_file(vertices == 0 ? "this is not an OBJ file: it has neither v nor f lines"
                                            : "the file has no faces, only " + std::to_string(vertices) + " vertices");
        for (const Reach& reach : reaches_)
            if (reach.vertex >= vertices)
                return fault(io::at_line(reach.line), reach.face,
                             "face " + std::to_string(reach.face) + " has the index " +
                                 std::to_string(reach.vertex + 1) +
                                 " (counted from 1, as in the file), but the file has " + std::to_string(vertices) +
                                 " vertices");
        return std::nullopt;
    }

    /// Joins pieces that touch, so that a block of faces is one piece.
    void append(std::string_view piece) {
        auto& pieces = script_.statements;
        if (!pieces.empty() && pieces.back().data() + pieces.back().size() == piece.data())
            pieces.back() = {pieces.back().data(), pieces.back().size() + piece.size()};
        else
            pieces.push_back(piece);
    }

    struct Reach {
        std::int64_t vertex, face, line;
    };

    std::string_view text_;
    io::FaceRule rule_;
    io::Ticker ticker_;
    Scanner scanner_;
    Script script_;
    std::vector<Reach> reaches_;
    std::vector<Index> corners_, scratch_;
};

}  // namespace

Result<Script> check(std::string_view text, io::FaceRule rule, Monitor monitor) {
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    if (auto refusal = io::refuse_foreign(text, "an OBJ file"); !refusal.empty()) return whole_file(std::move(refusal));
    if (const auto zero = text.find('\0'); zero != std::string_view::npos)
        return fault(io::at_line(io::line_of(text, zero)), -1, "a zero byte: this is a binary file, not an OBJ file");
    return Checker(text, rule, monitor).run();
}

}  // namespace polylap::obj

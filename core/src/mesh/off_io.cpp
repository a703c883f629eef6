// OFF as Geomview describes it (http://www.geomview.org/docs/html/OFF.html), but that each vertex and each face has a
// line of its own, as all writers do; so a wrong count cannot shift what follows without a word.
#include <cmath>

#include "load_bytes.hpp"
#include "raw_builder.hpp"
#include "text_lines.hpp"

namespace polylap::io {
namespace {

constexpr std::size_t most_face_colours = 4;
constexpr std::size_t most_vertex_extras = 3 + 4 + 2;  // normal, colour, texture

struct Keyword {
    bool known = false;
    bool other_dimension = false;   ///< `4` or `n`: the vertices are not x y z.
    std::size_t vertex_extras = 0;  ///< Numbers that a vertex has behind its position.
    std::string_view rest;          ///< Some writers forget the space before the counts.
};

/// `[ST][C][N][4][n]OFF`
Keyword parse_keyword(std::string_view token) {
    Keyword keyword;
    const auto take = [&token](std::string_view start) {
        if (!token.starts_with(start)) return false;
        token.remove_prefix(start.size());
        return true;
    };
    if (!take("off")) {
        if (take("ST")) keyword.vertex_extras += 2;
        if (take("C")) keyword.vertex_extras += 4;
        if (take("N")) keyword.vertex_extras += 3;
        if (take("4")) keyword.other_dimension = true;
        if (take("n")) keyword.other_dimension = true;
        if (!take("OFF")) return {};
    }
    keyword.known = token.empty() || (token[0] >= '0' && token[0] <= '9');
    keyword.rest = token;
    return keyword;
}

Error no_faces(std::int64_t vertices) {
    return whole_file("the file has no faces, only " + std::to_string(vertices) + " vertices");
}

Error more_follows(Place place, std::int64_t faces) {
    return fault(place, -1, "more follows than the " + std::to_string(faces) + " faces that the header announces");
}

class TextReader {
public:
    TextReader(LineScanner lines, std::string_view first_count, FaceRule rule, Ticker ticker)
        : lines_(lines), first_count_(first_count), builder_(rule), ticker_(ticker) {}

    Result<RawMesh> run() {
        if (auto error = read_counts()) return std::move(*error);
        while (builder_.vertex() < vertices_) {
            if (!lines_.next_line()) return cut_off("vertex", builder_.vertex(), vertices_);
            if (auto error = read_vertex()) return std::move(*error);
            if (!ticker_.proceed(lines_.position())) return cancelled();
        }
        while (builder_.face() < faces_) {
            if (!lines_.next_line()) return cut_off("face", builder_.face(), faces_);
            if (auto error = read_face()) return std::move(*error);
            if (!ticker_.proceed(lines_.position())) return cancelled();
        }
        if (lines_.next_line()) return more_follows(place(), faces_);
        return builder_.finish();
    }

private:
    Place place() const { return at_line(lines_.line()); }

    static Error cut_off(const char* what, std::int64_t next, std::int64_t count) {
        return whole_file("the file ends before " + std::string(what) + " " + std::to_string(next) + " of " +
                          std::to_string(count) + ", counted from 0");
    }

    /// Vertices, faces and perhaps edges, on the header's line or the next.
    std::optional<Error> read_counts() {
        std::string_view token = first_count_.empty() ? lines_.next_token() : first_count_;
        if (token.empty()) {
            if (!lines_.next_line()) return whole_file("the file ends before its counts of vertices and faces");
            token = lines_.next_token();
        }
        std::int64_t counts[3] = {0, 0, 0};
        std::size_t given = 0;
        for (; !token.empty(); token = lines_.next_token(), ++given)
            if (given == 3 || !parse_whole(token, counts[given]))
                return fault(place(), -1, quote(token) + " where the counts of vertices, faces and edges should stand");
        if (given < 2) return fault(place(), -1, "the count of faces is missing behind that of the vertices");
        vertices_ = counts[0];
        faces_ = counts[1];
        // "0 0 0\n" and "0\n" are the shortest; the last line may lack its end.
        if (auto error = refuse_count(place(), vertices_, "vertices", 6, lines_.bytes_left() + 1)) return error;
        if (auto error = refuse_count(place(), faces_, "faces", 2, lines_.bytes_left() + 1)) return error;
        if (faces_ == 0) return no_faces(vertices_);
        builder_.expect(vertices_, faces_);
        return std::nullopt;
    }

    std::optional<Error> read_vertex() {
        double xyz[3];
        for (int k = 0; k < 3; ++k) {
            const auto token = lines_.next_token();
            if (token.empty())
                return builder_.fault_of_vertex(place(), "has only " + std::to_string(k) + " of 3 coordinates");
            if (!parse_finite(token, xyz[k]))
                return builder_.fault_of_vertex(place(), "has " + quote(token) + ", which is no finite number");
        }
        // Normals and colours are not looked at: that of a vertex without faces may well be nan.
        std::size_t extras = 0;
        while (!lines_.next_token().empty())
            ++extras;
        if (extras > most_vertex_extras)
            return builder_.fault_of_vertex(place(), "has " + std::to_string(3 + extras) +
                                                         " numbers, more than position, normal, colour and texture");
        builder_.add_vertex(xyz);
        return std::nullopt;
    }

    std::optional<Error> read_face() {
        const auto size = lines_.next_token();
        std::int64_t corners = 0;
        if (!parse_whole(size, corners) || corners < 0)
            return builder_.fault_of_face(place(), "has " + quote(size) + " where its number of corners should stand");
        for (std::int64_t k = 0; k < corners; ++k) {
            const auto token = lines_.next_token();
            if (token.empty())
                return builder_.fault_of_face(
                    place(), "has only " + std::to_string(k) + " of " + std::to_string(corners) + " corners");
            std::int64_t vertex = 0;
            if (!parse_whole(token, vertex))
                return builder_.fault_of_face(place(), "has the corner " + quote(token) + ", which is no whole number");
            if (auto error = builder_.add_corner(place(), vertex)) return error;
        }
        std::size_t colours = 0;
        double ignored = 0;
        for (auto token = lines_.next_token(); !token.empty(); token = lines_.next_token(), ++colours)
            if (colours == most_face_colours || !parse_finite(token, ignored))
                return builder_.fault_of_face(place(), "has " + quote(token) + " behind its " +
                                                           std::to_string(corners) +
                                                           " corners, where up to four numbers of a colour may stand");
        return builder_.finish_face(place());
    }

    LineScanner lines_;
    std::string_view first_count_;
    RawBuilder builder_;
    Ticker ticker_;
    std::int64_t vertices_ = 0, faces_ = 0;
};

class BinaryReader {
public:
    BinaryReader(std::string_view bytes, std::size_t at, std::size_t vertex_extras, FaceRule rule, Ticker ticker)
        : bytes_(bytes), at_(at), vertex_bytes_(4 * (3 + vertex_extras)), builder_(rule), ticker_(ticker) {}

    Result<RawMesh> run() {
        if (auto error = read_counts()) return std::move(*error);
        while (builder_.vertex() < vertices_) {
            double xyz[3];
            for (std::size_t k = 0; k < 3; ++k) {
                xyz[k] = load<float>(bytes_, at_ + 4 * k, order_);
                if (!std::isfinite(xyz[k]))
                    return builder_.fault_of_vertex(at_byte(at_ + 4 * k), "has a coordinate that is no finite number");
            }
            builder_.add_vertex(xyz);
            at_ += vertex_bytes_;
            if (!ticker_.proceed(at_)) return cancelled();
        }
        while (builder_.face() < faces_) {
            if (auto error = read_face()) return std::move(*error);
            if (!ticker_.proceed(at_)) return cancelled();
        }
        if (at_ != bytes_.size()) return more_follows(at_byte(at_), faces_);
        return builder_.finish();
    }

private:
    static constexpr std::size_t count_bytes = 12;

    std::size_t bytes_left() const { return bytes_.size() - at_; }

    /// Geomview writes big-endian with a count of colours behind each face; others write the order of their machine and
    /// no such counts; and nothing tells. What ends with the file is meant, or else what could begin this way.
    std::optional<Error> read_counts() {
        if (bytes_left() < count_bytes) return fault(at_byte(bytes_.size()), -1, "the file ends within its counts");
        const auto choose = [this](ByteOrder order, bool coloured) {
            order_ = order;
            coloured_ = coloured;
            vertices_ = load<std::int32_t>(bytes_, at_, order);
            faces_ = load<std::int32_t>(bytes_, at_ + 4, order);
            return !refuse_counts();
        };
        bool found = false;
        for (const ByteOrder order : {ByteOrder::little, ByteOrder::big})
            for (const bool coloured : {false, true})
                found = found || (choose(order, coloured) && fits());
        if (!found && !choose(ByteOrder::little, false) && !choose(ByteOrder::big, true))
            choose(ByteOrder::little, false);
        if (auto refusal = refuse_counts()) return refusal;
        at_ += count_bytes;
        if (faces_ == 0) return no_faces(vertices_);
        builder_.expect(vertices_, faces_);
        return std::nullopt;
    }

    std::optional<Error> refuse_counts() const {
        const std::size_t left = bytes_left() - count_bytes;
        if (auto refusal = refuse_count(at_byte(at_), vertices_, "vertices", vertex_bytes_, left)) return refusal;
        return refuse_count(at_byte(at_ + 4), faces_, "faces", 4,
                            left - static_cast<std::size_t>(vertices_) * vertex_bytes_);
    }

    /// Whether the faces, as chosen, end where the file ends.
    bool fits() const {
        std::size_t at = at_ + count_bytes + static_cast<std::size_t>(vertices_) * vertex_bytes_;
        const auto skip_list = [&](std::int64_t longest) {
            if (bytes_.size() - at < 4) return false;
            const auto length = load<std::int32_t>(bytes_, at, order_);
            at += 4;
            if (length < 0 || length > longest || static_cast<std::size_t>(length) > (bytes_.size() - at) / 4)
                return false;
            at += 4 * static_cast<std::size_t>(length);
            return true;
        };
        for (std::int64_t f = 0; f < faces_; ++f)
            if (!skip_list(most) || (coloured_ && !skip_list(most_face_colours))) return false;
        return at == bytes_.size();
    }

    std::optional<Error> read_face() {
        const Place place = at_byte(at_);
        const auto cut_off = [&] { return builder_.fault_of_face(place, "is cut off by the end of the file"); };
        const auto next = [&] {
            const auto number = load<std::int32_t>(bytes_, at_, order_);
            at_ += 4;
            return number;
        };
        if (bytes_left() < 4) return cut_off();
        const std::int64_t corners = next();
        if (corners < 0) return builder_.fault_of_face(place, "has " + std::to_string(corners) + " corners");
        if (static_cast<std::size_t>(corners) > bytes_left() / 4) return cut_off();
        for (std::int64_t k = 0; k < corners; ++k) {
            const Place corner = at_byte(at_);
            if (auto error = builder_.add_corner(corner, next())) return error;
        }
        if (coloured_) {
            if (bytes_left() < 4) return cut_off();
            const std::int64_t colours = next();
            if (colours < 0 || colours > static_cast<std::int64_t>(most_face_colours))
                return builder_.fault_of_face(place, "has a colour of " + std::to_string(colours) + " numbers");
            if (static_cast<std::size_t>(colours) > bytes_left() / 4) return cut_off();
            at_ += 4 * static_cast<std::size_t>(colours);
        }
        return builder_.finish_face(place);
    }

    std::string_view bytes_;
    std::size_t at_, vertex_bytes_;
    RawBuilder builder_;
    Ticker ticker_;
    ByteOrder order_ = ByteOrder::little;
    bool coloured_ = false;
    std::int64_t vertices_ = 0, faces_ = 0;
};

}  // namespace

Result<RawMesh> read_off(std::string_view bytes, FaceRule rule, Monitor monitor) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    LineScanner lines(bytes, '#');
    const Ticker ticker(monitor, bytes.size());
    if (!lines.next_line()) return whole_file("the file is empty");
    const auto word = lines.next_token();
    const Keyword keyword = parse_keyword(word);
    if (!keyword.known) {
        if (auto refusal = refuse_foreign(bytes, "an OFF file"); !refusal.empty())
            return whole_file(std::move(refusal));
        return fault(at_line(lines.line()), -1, quote(word) + " where the keyword OFF should stand");
    }
    if (keyword.other_dimension)
        return fault(at_line(lines.line()), -1, quote(word) + ": vertices of other dimensions than three are not read");
    LineScanner ahead = lines;
    if (keyword.rest.empty() && ahead.next_token() == "BINARY") {
        ahead.skip_line();
        return BinaryReader(bytes, ahead.position(), keyword.vertex_extras, rule, ticker).run();
    }
    return TextReader(lines, keyword.rest, rule, ticker).run();
}

}  // namespace polylap::io

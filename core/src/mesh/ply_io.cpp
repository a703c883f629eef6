#include <cmath>

#include "ply_header.hpp"
#include "raw_builder.hpp"
#include "text_lines.hpp"

namespace polylap::io {
namespace {

using ply::Element;
using ply::Property;
using ply::Role;
using ply::Type;

// The two sources of values: each gives the next one, or says in a clause why there is none.

/// Each element on a line of its own, so that a wrong count cannot shift what follows without a word.
class TextSource {
public:
    explicit TextSource(LineScanner lines) : lines_(lines) {}

    Place place() const { return at_line(lines_.line()); }
    std::size_t position() const { return lines_.position(); }

    bool begin_element() { return lines_.next_line(); }
    std::string number(Type, double& value) {
        const auto token = lines_.next_token();
        if (token.empty()) return ends;
        return parse_finite(token, value) ? std::string() : "has " + quote(token) + ", which is no finite number";
    }
    std::string whole(Type, std::int64_t& value) {
        const auto token = lines_.next_token();
        if (token.empty()) return ends;
        return parse_whole(token, value) ? std::string() : "has " + quote(token) + ", which is no whole number";
    }
    std::string skip(Type, std::int64_t count) {
        for (; count > 0; --count)
            if (lines_.next_token().empty()) return ends;
        return {};
    }
    std::string end_element() {
        const auto token = lines_.next_token();
        return token.empty() ? std::string() : "has " + quote(token) + " behind its last property";
    }
    bool at_end() { return !lines_.next_line(); }

private:
    static constexpr const char* ends = "has fewer values than its properties";

    LineScanner lines_;
};

class BinarySource {
public:
    BinarySource(std::string_view bytes, std::size_t at, ByteOrder order) : bytes_(bytes), at_(at), order_(order) {}

    Place place() const { return at_byte(at_); }
    std::size_t position() const { return at_; }

    bool begin_element() { return true; }
    std::string number(Type type, double& value) {
        if (bytes_.size() - at_ < type.bytes) return ends;
        if (type.kind != Type::Kind::real) {
            value = static_cast<double>(load_whole(type));
        } else {
            value = type.bytes == 4 ? double{load<float>(bytes_, at_, order_)} : load<double>(bytes_, at_, order_);
            if (!std::isfinite(value)) return "has a coordinate that is no finite number";
        }
        at_ += type.bytes;
        return {};
    }
    std::string whole(Type type, std::int64_t& value) {
        if (bytes_.size() - at_ < type.bytes) return ends;
        value = load_whole(type);
        at_ += type.bytes;
        return {};
    }
    std::string skip(Type type, std::int64_t count) {
        if (static_cast<std::uint64_t>(count) > (bytes_.size() - at_) / type.bytes) return ends;
        at_ += static_cast<std::size_t>(count) * type.bytes;
        return {};
    }
    std::string end_element() { return {}; }
    /// Some writers add a line end.
    bool at_end() { return bytes_.find_first_not_of("\r\n", at_) == std::string_view::npos; }

private:
    static constexpr const char* ends = "is cut off by the end of the file";

    std::int64_t load_whole(Type type) const {
        const bool natural = type.kind == Type::Kind::natural;
        switch (type.bytes) {
            case 1:
                return natural ? std::int64_t{load<std::uint8_t>(bytes_, at_, order_)}
                               : std::int64_t{load<std::int8_t>(bytes_, at_, order_)};
            case 2:
                return natural ? std::int64_t{load<std::uint16_t>(bytes_, at_, order_)}
                               : std::int64_t{load<std::int16_t>(bytes_, at_, order_)};
            default:
                return natural ? std::int64_t{load<std::uint32_t>(bytes_, at_, order_)}
                               : std::int64_t{load<std::int32_t>(bytes_, at_, order_)};
        }
    }

    std::string_view bytes_;
    std::size_t at_;
    ByteOrder order_;
};

template <class Source>
class BodyReader {
public:
    BodyReader(const ply::Header& header, Source source, FaceRule rule, Ticker ticker)
        : header_(header), source_(std::move(source)), builder_(rule), ticker_(ticker) {
        builder_.expect(header.vertices, header.faces);
    }

    Result<RawMesh> run() {
        for (const Element& element : header_.elements) {
            if (element.properties.empty()) continue;
            for (number_ = 0; number_ < element.count; ++number_) {
                if (!source_.begin_element())
                    return whole_file("the file ends before " + name_of(element) + " of " +
                                      std::to_string(element.count) + ", counted from 0");
                if (auto error = read_element(element)) return std::move(*error);
                if (!ticker_.proceed(source_.position())) return cancelled();
            }
        }
        if (!source_.at_end()) return fault(source_.place(), -1, "more follows than the header announces");
        return builder_.finish();
    }

private:
    std::string name_of(const Element& element) const {
        const bool known = element.is("vertex") || element.is("face");
        return (known ? std::string(element.name) : "element " + quote(element.name)) + " " + std::to_string(number_);
    }

    Error fail(const Element& element, Place place, const std::string& what) const {
        const bool known = element.is("vertex") || element.is("face");
        return fault(place, known ? number_ : -1, name_of(element) + " " + what);
    }

    std::optional<Error> read_element(const Element& element) {
        const Place start = source_.place();
        double xyz[3] = {0, 0, 0};
        for (const Property& property : element.properties) {
            const Place place = source_.place();
            std::string problem;
            std::int64_t count = 1;
            if (property.count) {
                problem = source_.whole(*property.count, count);
                if (problem.empty() && count < 0)
                    problem = "has a list of " + std::to_string(count) + " items, a negative number";
                if (!problem.empty()) return fail(element, place, problem);
            }
            switch (property.role) {
                case Role::none:
                    problem = source_.skip(property.type, count);
                    break;
                case Role::x:
                case Role::y:
                case Role::z:
                    problem =
                        source_.number(property.type, xyz[static_cast<int>(property.role) - static_cast<int>(Role::x)]);
                    break;
                case Role::corners:
                    for (std::int64_t k = 0; k < count && problem.empty(); ++k) {
                        const Place corner = source_.place();
                        std::int64_t vertex = 0;
                        problem = source_.whole(property.type, vertex);
                        if (!problem.empty()) break;
                        if (auto error = builder_.add_corner(corner, vertex)) return error;
                    }
            }
            if (!problem.empty()) return fail(element, place, problem);
        }
        if (const auto problem = source_.end_element(); !problem.empty()) return fail(element, start, problem);
        if (element.is("vertex")) builder_.add_vertex(xyz);
        if (element.is("face")) return builder_.finish_face(start);
        return std::nullopt;
    }

    const ply::Header& header_;
    Source source_;
    RawBuilder builder_;
    Ticker ticker_;
    std::int64_t number_ = 0;  ///< Of the element that is being read, among its kind.
};

}  // namespace

Result<RawMesh> read_ply(std::string_view bytes, FaceRule rule, Monitor monitor) {
    const auto header = ply::read_header(bytes);
    if (!header) return header.error();
    const Ticker ticker(monitor, bytes.size());
    if (header->text) {
        const LineScanner lines(bytes.substr(header->end), 0, header->data_line);
        return BodyReader(*header, TextSource(lines), rule, ticker).run();
    }
    return BodyReader(*header, BinarySource(bytes, header->end, header->order), rule, ticker).run();
}

}  // namespace polylap::io

// PLY as Greg Turk's description has it ("The PLY Polygon File Format", 1994), with the newer names of types.
#include "ply_header.hpp"

#include <algorithm>

#include "raw_builder.hpp"
#include "text_lines.hpp"

namespace polylap::ply {
namespace {

using io::at_line;
using io::fault;
using io::quote;

struct NamedType {
    std::string_view name, newer_name;
    Type type;
};
constexpr NamedType types[] = {
    {"char", "int8", {1, Type::Kind::whole}},    {"uchar", "uint8", {1, Type::Kind::natural}},
    {"short", "int16", {2, Type::Kind::whole}},  {"ushort", "uint16", {2, Type::Kind::natural}},
    {"int", "int32", {4, Type::Kind::whole}},    {"uint", "uint32", {4, Type::Kind::natural}},
    {"float", "float32", {4, Type::Kind::real}}, {"double", "float64", {8, Type::Kind::real}},
};

Role role_of(const Element& element, const Property& property) {
    if (element.is("vertex")) {
        if (property.name == "x") return Role::x;
        if (property.name == "y") return Role::y;
        if (property.name == "z") return Role::z;
    }
    if (element.is("face") && (property.name == "vertex_indices" || property.name == "vertex_index"))
        return Role::corners;
    return Role::none;
}

bool has_role(const Element& element, Role role) {
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [role](const Property& property) { return property.role == role; });
}

class HeaderReader {
public:
    explicit HeaderReader(std::string_view bytes) : bytes_(bytes), lines_(bytes) {}

    Result<Header> run() {
        lines_.next_line();
        if (lines_.next_token() != "ply") {
            auto refusal = io::refuse_foreign(bytes_, "a PLY file");
            if (refusal.empty()) refusal = "this is not a PLY file: its first line is not ply";
            return io::whole_file(std::move(refusal));
        }
        if (auto error = read_format()) return std::move(*error);
        for (;;) {
            if (!lines_.next_line()) return io::whole_file("the file ends within its header: there is no end_header");
            const auto word = lines_.next_token();
            if (word == "end_header") break;
            std::optional<Error> error;
            if (word == "element")
                error = read_element();
            else if (word == "property")
                error = read_property();
            else if (word != "comment" && word != "obj_info")
                error = here(quote(word) + " where a declaration should stand");
            if (error) return std::move(*error);
        }
        find_data();
        if (auto error = check()) return std::move(*error);
        return std::move(header_);
    }

private:
    Error here(const std::string& what) const { return fault(at_line(lines_.line()), -1, what); }

    std::optional<Error> read_format() {
        std::string_view word;
        while (lines_.next_line()) {
            word = lines_.next_token();
            if (word != "comment" && word != "obj_info") break;
        }
        if (word != "format") return here(quote(word) + " where the format should stand");
        const auto format = lines_.next_token();
        header_.text = format == "ascii";
        if (format == "binary_big_endian")
            header_.order = io::ByteOrder::big;
        else if (!header_.text && format != "binary_little_endian")
            return here("the format " + quote(format) + " is none of ascii, binary_little_endian, binary_big_endian");
        if (const auto version = lines_.next_token(); version != "1.0")
            return here("the version " + quote(version) + " is not 1.0");
        return std::nullopt;
    }

    std::optional<Error> read_element() {
        Element element;
        element.name = lines_.next_token();
        element.line = lines_.line();
        if (!io::parse_whole(lines_.next_token(), element.count) || !lines_.next_token().empty())
            return here("an element is declared by its name and how many there are");
        for (const Element& other : header_.elements)
            if (other.is(element.name)) return here("the element " + quote(element.name) + " is declared twice");
        header_.elements.push_back(std::move(element));
        return std::nullopt;
    }

    std::optional<Error> read_type(std::string_view name, Type& type) const {
        for (const NamedType& known : types) {
            if (name != known.name && name != known.newer_name) continue;
            type = known.type;
            return std::nullopt;
        }
        return here(quote(name) + " is no type of a property");
    }

    std::optional<Error> read_property() {
        if (header_.elements.empty()) return here("a property stands before the first element");
        Element& element = header_.elements.back();
        Property property;
        auto word = lines_.next_token();
        const bool list = word == "list";
        if (list) {
            if (auto error = read_type(lines_.next_token(), property.count.emplace())) return error;
            if (property.count->kind == Type::Kind::real) return here("a list is counted by a type of fractions");
            word = lines_.next_token();
        }
        if (auto error = read_type(word, property.type)) return error;
        property.name = lines_.next_token();
        if (property.name.empty() || !lines_.next_token().empty())
            return here("a property is declared by its type and its name");
        property.role = role_of(element, property);
        if (property.role != Role::none) {
            if (has_role(element, property.role)) return here(quote(property.name) + " is declared twice");
            const bool corners = property.role == Role::corners;
            if (corners != list) return here(quote(property.name) + (corners ? " must be a list" : " must be no list"));
            if (corners && property.type.kind == Type::Kind::real)
                return here(quote(property.name) + " has a type of fractions");
        }
        element.properties.push_back(property);
        return std::nullopt;
    }

    /// A binary file's first byte may look like a line end: only the kind of end that the first line has counts.
    void find_data() {
        const std::size_t first_end = std::min(bytes_.find_first_of("\r\n"), bytes_.size());
        const bool crlf = bytes_.substr(first_end, 2) == "\r\n";
        const std::string_view line_end = crlf ? "\r\n" : bytes_.substr(first_end, 1);
        const std::size_t at = line_end.empty() ? std::string_view::npos : bytes_.find(line_end, lines_.position());
        header_.end = std::min(at, bytes_.size() - line_end.size()) + line_end.size();
        header_.data_line = lines_.line() + 1;
    }

    std::optional<Error> check() {
        bool vertices = false, faces = false;
        for (const Element& element : header_.elements) {
            const auto missing = [&](Role role, const char* name) -> std::optional<Error> {
                if (has_role(element, role)) return std::nullopt;
                return fault(at_line(element.line), -1,
                             "the element " + quote(element.name) + " has no property " + std::string(name));
            };
            const std::string plural = element.is("vertex") ? "vertices" : element.is("face") ? "faces" : "elements";
            // In a text, a value and the space or line end before it.
            const std::size_t least = header_.text ? 2 * element.properties.size() : element.least_bytes();
            if (auto error = io::refuse_count(at_line(element.line), element.count, plural.c_str(), least,
                                              bytes_.size() - header_.end + (header_.text ? 1 : 0)))
                return error;
            if (element.is("vertex")) {
                vertices = true;
                header_.vertices = element.count;
                if (auto error = missing(Role::x, "x")) return error;
                if (auto error = missing(Role::y, "y")) return error;
                if (auto error = missing(Role::z, "z")) return error;
            } else if (element.is("face")) {
                faces = true;
                header_.faces = element.count;
                if (auto error = missing(Role::corners, "vertex_indices")) return error;
            }
        }
        if (!vertices) return io::whole_file("the file has no element vertex");
        if (!faces || header_.faces == 0)
            return io::whole_file("the file has no faces, only " + std::to_string(header_.vertices) + " vertices");
        return std::nullopt;
    }

    std::string_view bytes_;
    io::LineScanner lines_;
    Header header_;
};

}  // namespace

std::size_t Element::least_bytes() const {
    std::size_t sum = 0;
    for (const Property& property : properties)
        sum += property.count ? property.count->bytes : property.type.bytes;
    return sum;
}

Result<Header> read_header(std::string_view bytes) {
    return HeaderReader(bytes).run();
}

}  // namespace polylap::ply

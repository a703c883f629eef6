#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "load_bytes.hpp"
#include "polylap/base/result.hpp"

namespace polylap::ply {

struct Type {
    std::uint8_t bytes = 0;
    enum class Kind : std::uint8_t { whole, natural, real } kind = Kind::whole;
};

/// What a property is for us.
enum class Role : std::uint8_t { none, x, y, z, corners };

struct Property {
    std::string_view name;
    Type type;                  ///< Of the items of a list.
    std::optional<Type> count;  ///< Of a list.
    Role role = Role::none;
};

struct Element {
    std::string_view name;
    std::int64_t count = 0;
    std::int64_t line = 0;  ///< Where it is declared.
    std::vector<Property> properties;

    bool is(std::string_view what) const { return name == what; }
    /// The bytes that one takes at least, in a binary file.
    std::size_t least_bytes() const;
};

struct Header {
    bool text = false;
    io::ByteOrder order = io::ByteOrder::little;
    std::vector<Element> elements;
    std::size_t end = 0;         ///< Where the data begins.
    std::int64_t data_line = 1;  ///< Its line.
    std::int64_t vertices = 0, faces = 0;
};

/// Reads the header of a PLY file and checks that its counts can be. Names are pieces of `bytes`.
/// @error parse_error (line).   Throws std::bad_alloc
Result<Header> read_header(std::string_view bytes);

}  // namespace polylap::ply

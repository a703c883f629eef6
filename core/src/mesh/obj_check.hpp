#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "polylap/base/monitor.hpp"
#include "polylap/base/result.hpp"
#include "raw_builder.hpp"

namespace polylap::obj {

/// An OBJ text that passed the strict check, and what the parser behind it needs.
struct Script {
    std::vector<double> coordinates;  ///< 3 a vertex, correctly rounded.
    std::vector<std::string_view>
        statements;  ///< One after the other: the `f` lines, and a bare `v` for each vertex, in the file's order.
    std::vector<std::int64_t> bare_faces;  ///< Faces without corners, which have no statement.
    std::int64_t faces = 0;
    std::int64_t corners = 0;

    std::int64_t vertices() const { return static_cast<std::int64_t>(coordinates.size() / 3); }
};

/// Checks every `v` and `f` of a text. The statements of the script are pieces of `text`: comments, continuations and
/// other lines are left out.
/// @error parse_error (line; element = vertex or face), bad_mesh (a face that is not sound), cancelled.   Throws
/// std::bad_alloc
Result<Script> check(std::string_view text, io::FaceRule rule, Monitor monitor);

/// What a text is if it is certainly no OBJ, e.g. "an HTML page"; otherwise empty.
std::string_view recognise_foreign(std::string_view text);

}  // namespace polylap::obj

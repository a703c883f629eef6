#pragma once

#include <vector>

#include "obj_check.hpp"
#include "polylap/base/types.hpp"

namespace polylap::obj {

struct Faces {
    std::vector<Index> offsets;  ///< F+1
    std::vector<Index> corners;  ///< From 0; relative indices resolved.
};

/// Parses the faces of a checked text with tinyobjloader, whose callbacks keep faces of any size.
/// @error parse_error if it does not see what the check saw, cancelled.   Throws std::bad_alloc
Result<Faces> read_faces(const Script& script, Monitor monitor);

}  // namespace polylap::obj

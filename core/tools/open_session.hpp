#pragma once

#include "commands.hpp"
#include "polylap/session.hpp"

namespace polylap::tool {

/// The side that commands work on.
inline constexpr auto side = Session::Side::a;

/// A library error with the file it is about in front.
Error in_file(const std::string& path, Error error);

Result<Session> open_session(const MeshChoice& mesh);

/// A session on the mesh whose side has the operator.
Result<Session> open_with_operator(const MeshChoice& mesh, const OperatorChoice& choice);

/// What reading the file has changed or left out, and each repair: a line each.
std::string reading_text(const Session& session);

/// The surface in the format that the ending of `path` says; OBJ for standard output and names without an ending.
Result<Output> mesh_output(const PolygonMesh& mesh, const std::string& path);

}  // namespace polylap::tool

#pragma once

#include <filesystem>

#include "files.hpp"
#include "polylap/session.hpp"

namespace polylap::tool {

/// A library error with the file it is about in front.
inline Error in_file(const std::string& path, Error error) {
    error.message = (path == "-" ? "standard input" : path) + ": " + error.message;
    return error;
}

/// Opens a mesh file; "-" is an OBJ on standard input.
inline Result<Session> open_session(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes) return bytes.error();
    auto session = Session::open(std::as_bytes(std::span(*bytes)),
                                 path == "-" ? "stdin.obj" : std::filesystem::path(path).filename().string());
    if (!session) return in_file(path, session.error());
    return session;
}

}  // namespace polylap::tool

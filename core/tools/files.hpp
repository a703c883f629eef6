#pragma once

#include <span>
#include <string>

#include "polylap/base/result.hpp"

namespace polylap::tool {

/// The whole of a file; "-" is standard input.
Result<std::string> read_file(const std::string& path);

/// What a command wants to have written. The path "-" is standard output.
struct Output {
    std::string path;
    std::string text;
};

/// Writes all outputs or none: beside each file first, then renames. A link stays a link: the file it names is written.
/// What is no regular file (a pipe, a device) is written directly.
Status write_outputs(std::span<const Output> outputs);

/// Whether two outputs would overwrite each other, however their paths are spelled and whether the file exists or not.
bool same_output(const std::string& a, const std::string& b);

}  // namespace polylap::tool

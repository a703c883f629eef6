#include <algorithm>
#include <cstdint>

#include "obj_check.hpp"

namespace polylap::obj {
namespace {

/// Compares a start in ASCII without regard to case; `start` is in lower case.
bool starts_with(std::string_view text, std::string_view start) {
    return text.size() >= start.size() && std::equal(start.begin(), start.end(), text.begin(), [](char s, char t) {
               return s == (t >= 'A' && t <= 'Z' ? static_cast<char>(t - 'A' + 'a') : t);
           });
}

/// 80 bytes of anything, the number of triangles, and 50 bytes for each.
bool is_binary_stl(std::string_view text) {
    if (text.size() < 84) return false;
    std::uint64_t triangles = 0;
    for (std::size_t i = 0; i < 4; ++i)
        triangles |= std::uint64_t{static_cast<unsigned char>(text[80 + i])} << (8 * i);
    return text.size() == 84 + 50 * triangles;
}

struct Start {
    std::string_view bytes, what;
};
constexpr Start starts[] = {
    {"\xff\xfe", "UTF-16 text"},    {"\xfe\xff", "UTF-16 text"},     {"ply\n", "a PLY file"},
    {"ply\r", "a PLY file"},        {"off\n", "an OFF file"},        {"off\r", "an OFF file"},
    {"off ", "an OFF file"},        {"coff", "an OFF file"},         {"noff", "an OFF file"},
    {"stoff", "an OFF file"},       {"solid", "an STL file"},        {"gltf", "a binary glTF file"},
    {"kaydara fbx", "an FBX file"}, {"pk\x03\x04", "a ZIP archive"}, {"\x1f\x8b", "a gzip archive"},
    {"%pdf", "a PDF document"},     {"\x89png", "a PNG image"},      {"\xff\xd8\xff", "a JPEG image"},
};

}  // namespace

std::string_view recognise_foreign(std::string_view text) {
    for (const auto& [start, what] : starts)
        if (starts_with(text, start)) return what;
    const std::string_view content = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (starts_with(content, "<!doctype html") || starts_with(content, "<html")) return "an HTML page";
    if (starts_with(content, "<")) return "an XML or HTML file";
    if (starts_with(content, "{")) return "a JSON file";
    if (is_binary_stl(text)) return "an STL file";
    return {};
}

}  // namespace polylap::obj

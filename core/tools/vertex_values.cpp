// Numbers out of text.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fast_float/fast_float.h>

#include "tables.hpp"

namespace polylap::tool {
namespace {

std::string_view trim(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// A cell without the quotes that some programs put around every one.
std::string_view bare(std::string_view cell) {
    cell = trim(cell);
    if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return cell;
    return trim(cell.substr(1, cell.size() - 2));
}

bool is_word(std::string_view cell, std::string_view lower_case) {
    const auto same = [](char c, char lower) { return c == lower || (c >= 'A' && c <= 'Z' && c - 'A' + 'a' == lower); };
    return std::equal(cell.begin(), cell.end(), lower_case.begin(), lower_case.end(), same);
}

bool parse_whole(std::string_view text, std::int64_t& value) {
    const auto [rest, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    return status == std::errc() && rest == text.data() + text.size();
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0;
    const auto [rest, status] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
    // Some versions call underflow out of range, too; then the value is 0.
    const bool number = status == std::errc() || status == std::errc::result_out_of_range;
    if (!number || rest != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

Result<VertexValues> parse_vertex_values(std::string_view text, Index vertex_count, std::string_view what) {
    const std::string name(what), row_form = "'vertex," + name + "'";
    VertexValues fixed;
    std::vector<std::int64_t> line_of(static_cast<std::size_t>(vertex_count), 0);
    std::int64_t line = 0;
    bool header_possible = true;
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    while (!text.empty()) {
        const auto end = std::min(text.find_first_of("\r\n"), text.size());
        const std::size_t line_end = text.substr(end, 2) == "\r\n" ? 2 : 1;
        std::string_view row = text.substr(0, end);
        row = trim(row.substr(0, row.find('#')));
        text.remove_prefix(std::min(end + line_end, text.size()));
        ++line;
        if (row.empty()) continue;

        const auto fail = [line](const std::string& why, std::int64_t vertex = -1) {
            return Error{ErrorCode::parse_error, "line " + std::to_string(line) + ": " + why, vertex, line};
        };
        const auto comma = row.find(',');
        const std::string_view first = bare(row.substr(0, comma));
        const std::string_view second = comma == std::string_view::npos ? "" : bare(row.substr(comma + 1));
        if (std::exchange(header_possible, false) && is_word(first, "vertex") && is_word(second, what)) continue;

        std::int64_t vertex = 0;
        if (comma == std::string_view::npos || !parse_whole(first, vertex))
            return fail("expected a row " + row_form + " with a whole number first");
        if (vertex < 0 || vertex >= vertex_count)
            return fail("there is no vertex " + std::to_string(vertex) + "; the mesh has " +
                            std::to_string(vertex_count) + " vertices, counted from 0",
                        vertex);
        const auto value = parse_number(second);
        if (!value)
            return fail("the " + name + " of vertex " + std::to_string(vertex) + " is no finite number", vertex);
        std::int64_t& before = line_of[static_cast<std::size_t>(vertex)];
        if (before != 0)
            return fail(
                "vertex " + std::to_string(vertex) + " has a " + name + " already, in line " + std::to_string(before),
                vertex);
        before = line;
        fixed.vertices.push_back(static_cast<Index>(vertex));
        fixed.values.push_back(*value);
    }
    if (fixed.vertices.empty()) return Error{ErrorCode::parse_error, "no rows " + row_form, -1, -1};
    return fixed;
}

}  // namespace polylap::tool

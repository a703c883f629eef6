// Numbers in and out of text: MatrixMarket and comma-separated values.
#include <charconv>
#include <cmath>
#include <utility>

#include "files.hpp"

namespace polylap::tool {
namespace {

std::string_view trim(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

template <class T>
bool parse(std::string_view text, T& value) {
    const auto [rest, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    return status == std::errc() && rest == text.data() + text.size();
}

bool is_title(std::string_view cell) {
    return !cell.empty() &&
           (cell[0] == '"' || (cell[0] >= 'A' && cell[0] <= 'Z') || (cell[0] >= 'a' && cell[0] <= 'z'));
}

void append_index(std::string& text, std::int64_t value) {
    char digits[24];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

}  // namespace

void append_number(std::string& text, double value) {
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 17).ptr);
}

std::string matrix_market(const SparseMatrix& matrix, bool symmetric, std::string_view comment) {
    std::string entries;
    std::int64_t count = 0;
    for (Index column = 0; column < matrix.outerSize(); ++column) {
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
            if (symmetric && entry.row() < column) continue;
            append_index(entries, std::int64_t{entry.row()} + 1);
            entries += ' ';
            append_index(entries, std::int64_t{column} + 1);
            entries += ' ';
            append_number(entries, entry.value());
            entries += '\n';
            ++count;
        }
    }
    std::string text = "%%MatrixMarket matrix coordinate real ";
    text += symmetric ? "symmetric\n% " : "general\n% ";
    text += comment;
    text +=
        '\n' + std::to_string(matrix.rows()) + ' ' + std::to_string(matrix.cols()) + ' ' + std::to_string(count) + '\n';
    return text + entries;
}

Result<FixedValues> parse_fixed_values(std::string_view text, Index vertex_count) {
    FixedValues fixed;
    std::vector<std::int64_t> line_of(static_cast<std::size_t>(vertex_count), 0);
    std::int64_t line = 0;
    bool header_possible = true;
    if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        const std::string_view row = trim(text.substr(0, std::min(text.find('#'), end)));
        text.remove_prefix(std::min(end + 1, text.size()));
        ++line;
        if (row.empty()) continue;

        const auto fail = [line](const std::string& what, std::int64_t vertex = -1) {
            return Error{ErrorCode::parse_error, "line " + std::to_string(line) + ": " + what, vertex, line};
        };
        const auto comma = row.find(',');
        const std::string_view first = trim(row.substr(0, comma));
        const std::string_view second = comma == std::string_view::npos ? "" : trim(row.substr(comma + 1));
        if (std::exchange(header_possible, false) && is_title(first) && is_title(second)) continue;

        std::int64_t vertex = 0;
        double value = 0;
        if (comma == std::string_view::npos || !parse(first, vertex))
            return fail("expected a row 'vertex,value' with a whole number first");
        if (vertex < 0 || vertex >= vertex_count)
            return fail("there is no vertex " + std::to_string(vertex) + "; the mesh has " +
                            std::to_string(vertex_count) + " vertices, counted from 0",
                        vertex);
        if (!parse(second, value) || !std::isfinite(value))
            return fail("the value of vertex " + std::to_string(vertex) + " is no finite number", vertex);
        std::int64_t& before = line_of[static_cast<std::size_t>(vertex)];
        if (before != 0)
            return fail("vertex " + std::to_string(vertex) + " has a value already, in line " + std::to_string(before),
                        vertex);
        before = line;
        fixed.vertices.push_back(static_cast<Index>(vertex));
        fixed.values.push_back(value);
    }
    if (fixed.vertices.empty()) return Error{ErrorCode::parse_error, "no rows 'vertex,value'", -1, -1};
    return fixed;
}

std::string values_csv(const Vector& values) {
    std::string text = "vertex,value\n";
    for (Eigen::Index v = 0; v < values.size(); ++v) {
        append_index(text, v);
        text += ',';
        append_number(text, values[v]);
        text += '\n';
    }
    return text;
}

}  // namespace polylap::tool

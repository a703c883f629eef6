// Numbers into text: MatrixMarket and comma-separated values.
#include "tables.hpp"

#include <charconv>
#include <cstdint>

namespace polylap::tool {
namespace {

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
            if (entry.value() == 0 && entry.row() != column) continue;  // vertices that only share a face
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

std::string modes_csv(const Matrix& modes) {
    std::string text = "vertex";
    for (Eigen::Index k = 0; k < modes.cols(); ++k)
        text += ",mode" + std::to_string(k);
    text += '\n';
    for (Eigen::Index v = 0; v < modes.rows(); ++v) {
        append_index(text, v);
        for (Eigen::Index k = 0; k < modes.cols(); ++k) {
            text += ',';
            append_number(text, modes(v, k));
        }
        text += '\n';
    }
    return text;
}

}  // namespace polylap::tool

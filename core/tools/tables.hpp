#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap::tool {

/// 17 significant digits in any locale: reading them back gives the same double.
void append_number(std::string& text, double value);

/// All of the text as a finite decimal number in any locale; what is too small for a double is 0.
std::optional<double> parse_number(std::string_view text);

/// A matrix in MatrixMarket's `coordinate real` form, whose indices count from 1.
/// @param symmetric write the lower triangle as `symmetric`; otherwise everything as `general`
std::string matrix_market(const SparseMatrix& matrix, bool symmetric, std::string_view comment);

struct VertexValues {
    std::vector<Index> vertices;
    std::vector<double> values;
};

/// Rows `vertex,value`, cells quoted or not; a first row that says just that, blank lines and `#` comments are read
/// past.
/// @param what the name of the second column, "value" or another
/// @error parse_error (line; element = vertex): a row that is none, a vertex out of range or twice, a value that is no
/// finite number, no rows
Result<VertexValues> parse_vertex_values(std::string_view text, Index vertex_count, std::string_view what);

/// `vertex,value` rows for all vertices.
std::string values_csv(const Vector& values);

/// `vertex,mode0,…` rows for all vertices.
/// @param modes V×k
std::string modes_csv(const Matrix& modes);

}  // namespace polylap::tool

#include "operators/sparse_pattern.hpp"

#include <algorithm>
#include <numeric>

namespace polylap {
namespace {

void set_size(Index size, std::size_t entries, SparseMatrix& matrix) {
    matrix.resize(size, size);
    matrix.resizeNonZeros(static_cast<Eigen::Index>(entries));
    std::fill_n(matrix.valuePtr(), entries, 0.0);
}

}  // namespace

void set_pattern(const FacePairs& pairs, SparseMatrix& matrix) {
    set_size(static_cast<Index>(pairs.offsets.size()) - 1, pairs.neighbours.size(), matrix);
    std::copy(pairs.offsets.begin(), pairs.offsets.end(), matrix.outerIndexPtr());
    std::copy(pairs.neighbours.begin(), pairs.neighbours.end(), matrix.innerIndexPtr());
}

void set_diagonal(Index vertex_count, SparseMatrix& matrix) {
    set_size(vertex_count, static_cast<std::size_t>(vertex_count), matrix);
    std::iota(matrix.outerIndexPtr(), matrix.outerIndexPtr() + vertex_count + 1, 0);
    std::iota(matrix.innerIndexPtr(), matrix.innerIndexPtr() + vertex_count, 0);
}

}  // namespace polylap

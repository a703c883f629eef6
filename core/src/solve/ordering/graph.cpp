#include "solve/ordering/graph.hpp"

#include <limits>
#include <stdexcept>

namespace polylap {

Graph::Graph(const SparseMatrix& a) {
    const auto n = static_cast<std::size_t>(a.cols());
    const Index* const outer = a.outerIndexPtr();
    const Index* const inner = a.innerIndexPtr();
    diagonal.assign(n, -1);
    std::vector<std::size_t> count(n + 1, 0);
    const auto each_lower = [&](auto&& take) {
        for (std::size_t column = 0; column < n; ++column) {
            for (Index k = outer[column]; k < outer[column + 1]; ++k) {
                const auto row = static_cast<std::size_t>(inner[k]);
                if (row == column) diagonal[column] = k;
                if (row > column) take(row, column, k);
            }
        }
    };
    each_lower([&](std::size_t row, std::size_t column, Index) {
        ++count[row];
        ++count[column];
    });
    std::size_t total = 0;
    for (std::size_t& c : count) {
        const std::size_t degree = c;
        c = total;
        total += degree;
    }
    if (total > static_cast<std::size_t>(std::numeric_limits<Index>::max())) throw std::length_error("too many edges");
    start.assign(count.begin(), count.end());
    neighbours.resize(total);
    source.resize(total);
    each_lower([&](std::size_t row, std::size_t column, Index k) {
        neighbours[count[row]] = static_cast<Index>(column);
        source[count[row]++] = k;
        neighbours[count[column]] = static_cast<Index>(row);
        source[count[column]++] = k;
    });
}

}  // namespace polylap

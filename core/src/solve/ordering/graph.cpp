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

std::vector<Index> Graph::induce(const Graph& whole, std::span<const Index> vertices, std::vector<Index>& local) {
    std::vector<Index> global(vertices.begin(), vertices.end());
    for (std::size_t k = 0; k < vertices.size(); ++k)
        local[static_cast<std::size_t>(vertices[k])] = static_cast<Index>(k);
    start.assign(1, 0);
    neighbours.clear();
    for (const Index v : vertices) {
        for (const Index u : whole.around(v)) {
            Index& number = local[static_cast<std::size_t>(u)];
            if (number < 0) {
                number = static_cast<Index>(global.size());
                global.push_back(u);
            }
            neighbours.push_back(number);
        }
        start.push_back(static_cast<Index>(neighbours.size()));
    }
    start.resize(global.size() + 1, start.back());
    for (const Index v : global)
        local[static_cast<std::size_t>(v)] = -1;
    return global;
}

}  // namespace polylap

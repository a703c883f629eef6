#pragma once

#include <cstdint>
#include <vector>

#include "polylap/base/monitor.hpp"
#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"
#include "solve/ordering/nested_dissection.hpp"
#include "solve/supernodal/panels.hpp"

namespace polylap {

/// The order of elimination and the pattern of L, by supernodes: columns of L that follow each other and share their
/// rows below. A front is the dense trapezoid of a supernode: its own columns first among its rows.
struct Symbolic {
    struct Supernode {
        Index first;       ///< Column of L; its columns end where the next supernode's begin.
        Index parent;      ///< Supernode of the first row below, or -1.
        Index children;    ///< How many supernodes have this one for a parent.
        Index below;       ///< Rows beneath the diagonal block.
        std::size_t rows;  ///< Where they begin in `rows`.
    };

    Index size = 0;
    std::vector<Index> original;        ///< n: matrix row of each column of L.
    std::vector<Supernode> supernodes;  ///< In postorder, and one past the last.
    std::vector<Index> rows;            ///< Rows below, rising, of each supernode.
    std::size_t values = 0;             ///< Doubles in all trapezoids.
    std::size_t stack = 0;              ///< Most doubles that contributions to other fronts take at once.
    Index largest_front = 0;            ///< Rows.
    Index widest = 0;                   ///< Columns of the widest supernode.
    std::int64_t entries = 0;           ///< nnz(L) without padding.
    double flops = 0;                   ///< Of one factorisation, padding included.

    /// Where the matrix's entries go: of column j of L those from entry_start[j], the diagonal one first.
    struct Entry {
        Index source;  ///< Place among the matrix's values, -1: not stored, zero.
        Index row;     ///< In the front.
    };
    std::vector<Index> entry_start;  ///< n + 1
    std::vector<Entry> entries_in;

    Panels panels(std::size_t s) const { return {columns(s) + supernodes[s].below, columns(s)}; }
    Index columns(std::size_t s) const { return supernodes[s + 1].first - supernodes[s].first; }
};

/// @param a square, compressed   @param positions n×3 or no rows   @param dissect_above see fill_reducing_order
/// @error out_of_memory, cancelled
Result<Symbolic> analyse_pattern(const SparseMatrix& a, const Points& positions, const Monitor& monitor,
                                 Index dissect_above = minimum_degree_size);

}  // namespace polylap

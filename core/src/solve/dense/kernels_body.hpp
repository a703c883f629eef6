// The body of kernels_*.cpp, each compiled for another instruction set: everything in it has internal linkage, and it
// calls no inline function of a header, so that no wider instruction leaks into code that runs everywhere.
//
// Matrix products are tiles of a few vector registers by a few columns whose sums stay in registers; blocks that are
// used often are packed first: Goto & van de Geijn, Anatomy of high-performance matrix multiplication, 2008.
//
// POLYLAP_LANES doubles make a vector; a tile has up to POLYLAP_TILE_VECTORS of them by POLYLAP_TILE_COLUMNS.

#include "solve/dense/kernels.hpp"
#include "solve/dense/kernels_solve.hpp"
#include "solve/dense/kernels_vectors.hpp"

namespace polylap::dense {
namespace {

constexpr Long tile_rows = POLYLAP_TILE_VECTORS * lanes;
constexpr Long tile_columns = POLYLAP_TILE_COLUMNS;

/// A matrix as tiles see it: entry (i, p) at data[i + p stride].
struct View {
    const double* data;
    Long stride;
};

/// sum(v, j) = Σ_p a(v, p) b(j, p).
template <Long V, Long N>
inline void multiply(Lanes (&sum)[N][V], View a, View b, Long depth) {
    for (Long p = 0; p < depth; ++p) {
        Lanes x[V];
        for (Long v = 0; v < V; ++v)
            x[v] = packed<lanes>(a.data + v * lanes);
        for (Long j = 0; j < N; ++j) {
            for (Long v = 0; v < V; ++v)
                sum[j][v] += x[v] * b.data[j];
        }
        a.data += a.stride;
        b.data += b.stride;
    }
}

/// The first `rows` of the lanes.
template <Long V>
inline void store_rows(double* c, const Lanes (&x)[V], Long rows) {
    if (rows >= V * lanes) {
        for (Long v = 0; v < V; ++v)
            packed<lanes>(c + v * lanes) = x[v];
        return;
    }
    for (Long v = 0; v < V; ++v) {
        if (rows >= (v + 1) * lanes) {
            packed<lanes>(c + v * lanes) = x[v];
        } else {
            for (Long i = v * lanes; i < rows; ++i)
                c[i] = x[v][i - v * lanes];
        }
    }
}

struct Target {
    double* data;
    Long stride, rows, columns;  ///< What of the tile is stored.
    bool overwrite;
};

template <Long V, Long N>
void update_tile(Target c, View a, View b, Long depth) {
    Lanes sum[N][V] = {};
    multiply<V, N>(sum, a, b, depth);
    for (Long j = 0; j < N; ++j) {
        if (j >= c.columns) break;
        double* column = c.data + j * c.stride;
        Lanes x[V];
        for (Long v = 0; v < V; ++v)
            x[v] = c.overwrite ? -sum[j][v] : packed<lanes>(column + v * lanes) - sum[j][v];
        store_rows<V>(column, x, c.rows);
    }
}

template <Long V>
inline void update_columns(const Target& c, View a, View b, Long depth) {
    if (tile_columns > 4 && c.columns > 4) return update_tile<V, tile_columns>(c, a, b, depth);
    if (c.columns > 2) return update_tile<V, 4>(c, a, b, depth);
    return update_tile<V, 2>(c, a, b, depth);
}

inline void update(const Target& c, View a, View b, Long depth) {
    if (c.rows <= lanes) return update_columns<1>(c, a, b, depth);
    if (POLYLAP_TILE_VECTORS == 2 || c.rows <= 2 * lanes) return update_columns<2>(c, a, b, depth);
    return update_columns<POLYLAP_TILE_VECTORS>(c, a, b, depth);
}

/// Rows and columns that are packed together: a block of A stays in the second cache, a slice of B in the first.
constexpr Long packed_rows = 8 * tile_rows, packed_columns = 1024;

/// Slices of `width` rows, each depth×width row-major.
inline void pack(double* out, const double* a, Long stride, Long rows, Long depth, Long width) {
    for (Long i = 0; i < rows; i += width) {
        const Long filled = min(width, rows - i);
        for (Long p = 0; p < depth; ++p) {
            const double* column = a + i + p * stride;
            Long k = 0;
            for (; k < filled; ++k)
                out[k] = column[k];
            for (; k < width; ++k)
                out[k] = 0;
            out += width;
        }
    }
}

void downdate_packed(double* c, Long c_stride, Long rows, Long columns, const double* a, Long a_stride, Long depth,
                     bool overwrite, double* scratch) {
    double* const packed_b = scratch;
    double* const packed_a = scratch + packed_columns * block_columns;
    for (Long j0 = 0; j0 < columns; j0 += packed_columns) {
        const Long width = min(packed_columns, columns - j0);
        pack(packed_b, a + j0, a_stride, width, depth, tile_columns);
        for (Long i0 = j0; i0 < rows; i0 += packed_rows) {
            const Long height = min(packed_rows, rows - i0);
            pack(packed_a, a + i0, a_stride, height, depth, tile_rows);
            const Long last = min(j0 + width, i0 + height);
            for (Long j = j0; j < last; j += tile_columns) {
                const View b{packed_b + (j - j0) * depth, tile_columns};
                const Long above = j > i0 ? (j - i0) / tile_rows * tile_rows : 0;  // the diagonal's tile comes first
                for (Long i = i0 + above; i < i0 + height; i += tile_rows) {
                    const Target target{c + i + j * c_stride, c_stride, min(tile_rows, i0 + height - i),
                                        min(tile_columns, j0 + width - j), overwrite};
                    update(target, {packed_a + (i - i0) * depth, tile_rows}, b, depth);
                }
            }
        }
    }
}

void downdate(double* c, Long c_stride, Long rows, Long columns, const double* a, Long a_stride, Long depth,
              bool overwrite, double* scratch) {
    constexpr Long worth_packing = 24;  // times that a row of A is used; measured
    if (columns >= worth_packing * tile_columns / 2 && depth >= 32) {
        return downdate_packed(c, c_stride, rows, columns, a, a_stride, depth, overwrite, scratch);
    }
    for (Long j = 0; j < columns; j += tile_columns) {
        const Long width = min(tile_columns, columns - j);
        for (Long i = j; i < rows; i += tile_rows) {
            update({c + i + j * c_stride, c_stride, min(tile_rows, rows - i), width, overwrite}, {a + i, a_stride},
                   {a + j, a_stride}, depth);
        }
    }
}

/// Unblocked Cholesky of the leading n×n block after `depth` columns to its left were eliminated.
/// @return the column refused, or -1
Long factor_diagonal(double* a, Long stride, Long n, Long depth, const double* least, double* inverse) {
    for (Long j = 0; j < n; ++j) {
        for (Long p = -depth; p < j; ++p) {
            const double* left = a + p * stride;
            for (Long i = j; i < n; ++i)
                a[i + j * stride] -= left[i] * left[j];
        }
        const double pivot = a[j + j * stride];
        if (!(pivot > least[j])) return j;
        const double root = __builtin_sqrt(pivot);
        a[j + j * stride] = root;
        inverse[j] = 1 / root;
        for (Long i = j + 1; i < n; ++i)
            a[i + j * stride] *= inverse[j];
    }
    return -1;
}

/// N columns of the rows below their diagonal block: downdated by the `depth` columns to the left, then solved.
/// @param a the rows, first of the N columns   @param b the diagonal block's row of the first column
template <Long V, Long N>
void solve_tile(double* a, const double* b, Long stride, Long rows, Long depth, const double* inverse) {
    Lanes sum[N][V] = {};
    multiply<V, N>(sum, {a - depth * stride, stride}, {b - depth * stride, stride}, depth);
    Lanes x[N][V];
    for (Long j = 0; j < N; ++j) {
        for (Long v = 0; v < V; ++v)
            x[j][v] = packed<lanes>(a + j * stride + v * lanes) - sum[j][v];
        for (Long p = 0; p < j; ++p) {
            for (Long v = 0; v < V; ++v)
                x[j][v] -= x[p][v] * b[j + p * stride];
        }
        for (Long v = 0; v < V; ++v)
            x[j][v] = x[j][v] * inverse[j];
        store_rows<V>(a + j * stride, x[j], rows);
    }
}

template <Long N>
Long factor_columns(double* a, Long stride, Long rows, Long depth, const double* least) {
    double inverse[N];
    if (const Long refused = factor_diagonal(a, stride, N, depth, least, inverse); refused >= 0) return refused;
    Long i = N;
    for (; i + lanes < rows; i += 2 * lanes) {
        solve_tile<2, N>(a + i, a, stride, rows - i, depth, inverse);
    }
    if (i < rows) solve_tile<1, N>(a + i, a, stride, rows - i, depth, inverse);
    return -1;
}

/// A few columns, each group of them when those to its left are done.
Long factor_strip(double* a, Long stride, Long rows, Long columns, const double* least) {
    for (Long j = 0; j < columns;) {
        double* corner = a + j + j * stride;
        const Long left = columns - j;
        const Long width = left >= tile_columns ? tile_columns : left >= 4 ? 4 : left >= 2 ? 2 : 1;
        Long refused = -1;
        if (width == tile_columns) {
            refused = factor_columns<tile_columns>(corner, stride, rows - j, j, least + j);
        } else if (width == 4) {
            refused = factor_columns<4>(corner, stride, rows - j, j, least + j);
        } else if (width == 2) {
            refused = factor_columns<2>(corner, stride, rows - j, j, least + j);
        } else {
            refused = factor_columns<1>(corner, stride, rows - j, j, least + j);
        }
        if (refused >= 0) return j + refused;
        j += width;
    }
    return -1;
}

Long factor(double* a, Long stride, Long rows, Long columns, const double* least, double* scratch) {
    constexpr Long strip = 32;
    if (columns <= strip) return factor_strip(a, stride, rows, columns, least);
    const Long left = min(block_columns, (columns / 2 + tile_columns - 1) / tile_columns * tile_columns);
    if (const Long refused = factor(a, stride, rows, left, least, scratch); refused >= 0) return refused;
    double* corner = a + left + left * stride;
    downdate(corner, stride, rows - left, columns - left, a + left, stride, left, false, scratch);
    const Long refused = factor(corner, stride, rows - left, columns - left, least + left, scratch);
    return refused < 0 ? refused : left + refused;
}

constexpr std::size_t scratch_doubles = (packed_columns + packed_rows) * block_columns;

}  // namespace
}  // namespace polylap::dense

// The triangular solves of kernels_body.hpp. They are bound by the memory that L comes from: each pass over four
// columns of it serves all right-hand sides at hand.

#pragma once

#include "solve/dense/kernels.hpp"
#include "solve/dense/kernels_vectors.hpp"

namespace polylap::dense {
namespace {

/// One right-hand side: vectors along the columns of L, four of them at a time.
void forward_one(const double* l, Long stride, Long rows, Long columns, double* x) {
    for (Long j = 0; j < columns; j += 4) {
        const Long width = min(4, columns - j);
        const double* corner = l + j + j * stride;
        double* y = x + j;
        double value[4] = {};
        for (Long q = 0; q < width; ++q) {
            for (Long p = 0; p < q; ++p)
                y[q] -= corner[q + p * stride] * value[p];
            value[q] = y[q] / corner[q + q * stride];
            y[q] = value[q];
        }
        const Long below = rows - j;
        Long i = width;
        const double *l0 = corner, *l1 = corner + min(1, width - 1) * stride, *l2 = corner + min(2, width - 1) * stride,
                     *l3 = corner + (width - 1) * stride;  // columns past the last count as zero
        for (; i + lanes <= below; i += lanes) {
            Lanes sum = packed<lanes>(y + i);
            sum -= packed<lanes>(l0 + i) * value[0];
            sum -= packed<lanes>(l1 + i) * value[1];
            sum -= packed<lanes>(l2 + i) * value[2];
            sum -= packed<lanes>(l3 + i) * value[3];
            packed<lanes>(y + i) = sum;
        }
        for (; i < below; ++i) {
            y[i] -= l0[i] * value[0] + l1[i] * value[1] + l2[i] * value[2] + l3[i] * value[3];
        }
    }
}

void backward_one(const double* l, Long stride, Long rows, Long columns, double* x) {
    for (Long end = columns; end > 0;) {
        const Long width = end % 4 == 0 ? 4 : end % 4;
        const Long j = end - width;
        const double* corner = l + j + j * stride;
        double* y = x + j;
        const Long below = rows - j;
        const double* column[4];
        for (Long q = 0; q < 4; ++q)
            column[q] = corner + min(q, width - 1) * stride;
        Lanes sums[4] = {};
        Long i = width;
        for (; i + lanes <= below; i += lanes) {
            const Lanes at = packed<lanes>(y + i);
            for (Long q = 0; q < 4; ++q)
                sums[q] += packed<lanes>(column[q] + i) * at;
        }
        double value[4] = {};
        for (Long q = 0; q < 4; ++q) {
            for (Long k = 0; k < lanes; ++k)
                value[q] += sums[q][k];
            for (Long k = i; k < below; ++k)
                value[q] += column[q][k] * y[k];
        }
        for (Long q = width - 1; q >= 0; --q) {
            double sum = y[q] - value[q];
            for (Long p = q + 1; p < width; ++p)
                sum -= corner[p + q * stride] * y[p];
            y[q] = sum / corner[q + q * stride];
        }
        end = j;
    }
}

/// W right-hand sides: vectors along them.
template <Long W>
void forward_many(const double* l, Long stride, Long rows, Long columns, double* x) {
    for (Long j = 0; j < columns; j += 4) {
        const Long width = min(4, columns - j);
        const double* corner = l + j + j * stride;
        double* y = x + j * W;
        Pack<W> value[4] = {};
        for (Long q = 0; q < width; ++q) {
            Pack<W> sum = packed<W>(y + q * W);
            for (Long p = 0; p < q; ++p)
                sum -= value[p] * corner[q + p * stride];
            value[q] = sum * (1 / corner[q + q * stride]);
            packed<W>(y + q * W) = value[q];
        }
        const double *l0 = corner, *l1 = corner + min(1, width - 1) * stride, *l2 = corner + min(2, width - 1) * stride,
                     *l3 = corner + (width - 1) * stride;
        for (Long i = width; i < rows - j; ++i) {
            Pack<W> sum = packed<W>(y + i * W);
            sum -= value[0] * l0[i];
            sum -= value[1] * l1[i];
            sum -= value[2] * l2[i];
            sum -= value[3] * l3[i];
            packed<W>(y + i * W) = sum;
        }
    }
}

template <Long W>
void backward_many(const double* l, Long stride, Long rows, Long columns, double* x) {
    for (Long end = columns; end > 0;) {
        const Long width = end % 4 == 0 ? 4 : end % 4;
        const Long j = end - width;
        const double* corner = l + j + j * stride;
        double* y = x + j * W;
        const double *l0 = corner, *l1 = corner + min(1, width - 1) * stride, *l2 = corner + min(2, width - 1) * stride,
                     *l3 = corner + (width - 1) * stride;
        Pack<W> sums[4] = {};
        for (Long i = width; i < rows - j; ++i) {
            const Pack<W> at = packed<W>(y + i * W);
            sums[0] += at * l0[i];
            sums[1] += at * l1[i];
            sums[2] += at * l2[i];
            sums[3] += at * l3[i];
        }
        for (Long q = width - 1; q >= 0; --q) {
            Pack<W> sum = packed<W>(y + q * W) - sums[q];
            for (Long p = q + 1; p < width; ++p)
                sum -= packed<W>(y + p * W) * corner[p + q * stride];
            packed<W>(y + q * W) = sum * (1 / corner[q + q * stride]);
        }
        end = j;
    }
}

void forward(const double* l, Long stride, Long rows, Long columns, double* x, Long width) {
    if (width == 1) return forward_one(l, stride, rows, columns, x);
    if (width == 4) return forward_many<4>(l, stride, rows, columns, x);
    forward_many<rhs_block>(l, stride, rows, columns, x);
}

void backward(const double* l, Long stride, Long rows, Long columns, double* x, Long width) {
    if (width == 1) return backward_one(l, stride, rows, columns, x);
    if (width == 4) return backward_many<4>(l, stride, rows, columns, x);
    backward_many<rhs_block>(l, stride, rows, columns, x);
}

}  // namespace
}  // namespace polylap::dense

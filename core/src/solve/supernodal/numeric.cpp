// Multifrontal Cholesky: Duff & Reid, The multifrontal solution of indefinite sparse symmetric linear equations, 1983;
// Liu, The multifrontal method for sparse matrix solution: theory and practice, 1992. A front is assembled from the
// matrix and from what its children contribute, its own columns are eliminated, and the rest of it waits on a stack for
// its parent. The columns are assembled right where the factor keeps them.

#include "solve/supernodal/numeric.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "polylap/solve/spd_factor.hpp"

namespace polylap {
namespace {

std::size_t at(Index v) {
    return static_cast<std::size_t>(v);
}

std::unique_ptr<double[]> allocate(std::size_t count) {
    if (count > std::numeric_limits<std::ptrdiff_t>::max() / sizeof(double) - dense::slack) throw std::bad_alloc();
    return std::unique_ptr<double[]>(new double[count + dense::slack]);  // not zeroed: a front is, when its turn comes
}

class Elimination {
public:
    Elimination(const Symbolic& symbolic, const SparseMatrix& a, const dense::Kernels& kernels, double* values,
                const Monitor& monitor)
        : symbolic_(symbolic),
          a_(a),
          kernels_(kernels),
          monitor_(monitor),
          values_(values),
          stack_(allocate(symbolic.stack)),
          scratch_(symbolic.largest_front > 64 ? allocate(kernels.scratch_doubles) : nullptr),
          least_(at(symbolic.widest)),
          in_front_(at(symbolic.size)),
          relative_(at(symbolic.largest_front)) {}

    Status run() {
        top_ = stack_.get();
        for (std::size_t s = 0; s + 1 < symbolic_.supernodes.size(); ++s) {
            if (Status status = eliminate(s); !status) return status;
        }
        return Done{};
    }

private:
    Status eliminate(std::size_t s) {
        const auto& supernode = symbolic_.supernodes[s];
        const auto columns = static_cast<std::ptrdiff_t>(symbolic_.columns(s));
        const std::ptrdiff_t below = supernode.below;
        const std::ptrdiff_t rows = columns + below;
        double* const front = values_ + supernode.values;
        if (!assemble(s, front, rows)) return not_finite();
        double* const rest = top_;  // what this front leaves to its parent
        double* bottom = top_;
        if (supernode.children > 0) {
            std::memset(rest, 0, sizeof(double) * static_cast<std::size_t>(below * below));
            bottom = add_children(s, front, rows, rest);
        }
        // Blocks of columns from the left; each is done with when those to its right know of it.
        for (std::ptrdiff_t j = 0; j < columns;) {
            const std::ptrdiff_t width = std::min(dense::block_columns, columns - j);
            const std::ptrdiff_t end = j + width;
            double* const corner = front + j * rows + j;
            const std::ptrdiff_t refused =
                kernels_.factor(corner, rows, rows - j, width, least_.data() + j, scratch_.get());
            if (refused >= 0) return not_positive_definite(supernode.first + static_cast<Index>(j + refused));
            kernels_.downdate(front + end * rows + end, rows, rows - end, columns - end, corner + width, rows, width,
                              false, scratch_.get());
            const bool first = j == 0 && supernode.children == 0;
            kernels_.downdate(rest, below, below, below, corner + columns - j, rows, width, first, scratch_.get());
            const double right = static_cast<double>(rows - j);
            done_ += static_cast<double>(width) * right * right;
            if (!proceed()) return Error{ErrorCode::cancelled, "cancelled"};
            j = end;
        }
        if (bottom != rest) std::memmove(bottom, rest, sizeof(double) * static_cast<std::size_t>(below * below));
        top_ = bottom + below * below;
        pending_.push_back(static_cast<Index>(s));
        return Done{};
    }

    /// The matrix's own entries. @return false if one is not finite
    bool assemble(std::size_t s, double* front, std::ptrdiff_t rows) {
        const auto& supernode = symbolic_.supernodes[s];
        const Index columns = symbolic_.columns(s);
        std::memset(front, 0, sizeof(double) * static_cast<std::size_t>(columns * rows));
        const double* const values = a_.valuePtr();
        double check = 0;
        for (Index k = 0; k < columns; ++k) {
            const std::size_t j = at(supernode.first + k);
            const auto* entry = symbolic_.entries_in.data() + symbolic_.entry_start[j];
            const auto* const end = symbolic_.entries_in.data() + symbolic_.entry_start[j + 1];
            double* const column = front + k * rows;
            const double diagonal = entry->source < 0 ? 0 : values[entry->source];
            column[k] = diagonal;
            check += diagonal * 0;
            least_[at(k)] = pivot_tolerance * std::abs(diagonal);
            for (++entry; entry != end; ++entry) {
                const double value = values[entry->source];
                check += value * 0;
                column[entry->row] = value;
            }
        }
        return check == 0;
    }

    /// Adds what the children left on the stack. @return where that begins
    double* add_children(std::size_t s, double* front, std::ptrdiff_t rows, double* rest) {
        const auto& supernode = symbolic_.supernodes[s];
        const Index columns = symbolic_.columns(s);
        for (Index k = 0; k < columns; ++k)
            in_front_[at(supernode.first + k)] = k;
        for (Index k = 0; k < supernode.below; ++k) {
            in_front_[at(symbolic_.rows[supernode.rows + at(k)])] = columns + k;
        }
        double* from = rest;
        for (Index k = 0; k < supernode.children; ++k) {
            const auto& child = symbolic_.supernodes[at(pending_.back())];
            pending_.pop_back();
            from -= at(child.below) * at(child.below);
            for (Index i = 0; i < child.below; ++i) {
                relative_[at(i)] = in_front_[at(symbolic_.rows[child.rows + at(i)])];
            }
            add_child(from, child.below, columns, front, rows, rest, supernode.below);
        }
        return from;
    }

    void add_child(const double* from, Index size, Index columns, double* front, std::ptrdiff_t rows, double* rest,
                   std::ptrdiff_t below) {
        const Index* const relative = relative_.data();
        for (Index j = 0; j < size; ++j) {
            const Index column = relative[j];
            double* const to = column < columns ? front + column * rows : rest + (column - columns) * below - columns;
            const double* const source = from + static_cast<std::ptrdiff_t>(j) * size;
            for (Index i = j; i < size; ++i)
                to[relative[i]] += source[i];
        }
    }

    bool proceed() {
        constexpr double tick_flops = 2e7;
        if (done_ - told_ < tick_flops) return true;
        told_ = done_;
        return monitor_.proceed(std::min(1.0, done_ / symbolic_.flops));
    }

    Error not_positive_definite(Index column) const {
        const Index row = symbolic_.original[at(column)];
        return {ErrorCode::not_positive_definite,
                "the matrix is not positive definite (pivot of row " + std::to_string(row) + ")", row};
    }

    Error not_finite() const {
        for (Index column = 0; column < a_.cols(); ++column) {
            for (SparseMatrix::InnerIterator it(a_, column); it; ++it) {
                if (it.row() < column || std::isfinite(it.value())) continue;
                return {ErrorCode::bad_argument, "the matrix is not finite in row " + std::to_string(it.row()),
                        it.row()};
            }
        }
        return {ErrorCode::bad_argument, "the matrix is not finite"};
    }

    const Symbolic& symbolic_;
    const SparseMatrix& a_;
    const dense::Kernels& kernels_;
    const Monitor& monitor_;
    double* values_;
    std::unique_ptr<double[]> stack_, scratch_;
    double* top_ = nullptr;
    std::vector<Index> pending_;  ///< Supernodes whose contributions are on the stack.
    std::vector<double> least_;
    std::vector<Index> in_front_, relative_;
    double done_ = 0, told_ = 0;
};

}  // namespace

Status Numeric::factor(const Symbolic& symbolic, const SparseMatrix& a, const Monitor& monitor) {
    if (capacity_ != symbolic.values) {
        values_.reset();
        capacity_ = 0;
        values_ = allocate(symbolic.values);
        capacity_ = symbolic.values;
    }
    return Elimination(symbolic, a, *kernels_, values_.get(), monitor).run();
}

Matrix Numeric::solve(const Symbolic& symbolic, const Eigen::Ref<const Matrix>& rhs) const {
    const auto n = static_cast<std::size_t>(symbolic.size);
    Matrix result(rhs.rows(), rhs.cols());
    const Eigen::Index widest = rhs.cols() == 1 ? 1 : rhs.cols() <= 4 ? 4 : dense::rhs_block;
    std::vector<double> x(n * static_cast<std::size_t>(widest));
    std::vector<double> front(static_cast<std::size_t>(symbolic.largest_front) * static_cast<std::size_t>(widest));
    const std::size_t supernodes = symbolic.supernodes.size() - 1;
    for (Eigen::Index first = 0; first < rhs.cols(); first += widest) {
        const Eigen::Index count = std::min(widest, rhs.cols() - first);
        const Eigen::Index width = count == 1 ? 1 : count <= 4 ? 4 : dense::rhs_block;
        const auto w = static_cast<std::size_t>(width);
        for (std::size_t j = 0; j < n; ++j) {
            for (Eigen::Index k = 0; k < width; ++k) {
                x[j * w + static_cast<std::size_t>(k)] = k < count ? rhs(symbolic.original[j], first + k) : 0;
            }
        }
        for (std::size_t s = 0; s < supernodes; ++s) {
            const auto& supernode = symbolic.supernodes[s];
            const std::size_t columns = at(symbolic.columns(s));
            const std::size_t below = at(supernode.below);
            double* const own = x.data() + at(supernode.first) * w;
            std::memcpy(front.data(), own, columns * w * sizeof(double));
            std::memset(front.data() + columns * w, 0, below * w * sizeof(double));
            const auto rows = static_cast<std::ptrdiff_t>(columns + below);
            kernels_->forward(values_.get() + supernode.values, rows, rows, static_cast<std::ptrdiff_t>(columns),
                              front.data(), width);
            std::memcpy(own, front.data(), columns * w * sizeof(double));
            const double* from = front.data() + columns * w;
            for (std::size_t i = 0; i < below; ++i) {
                double* const to = x.data() + at(symbolic.rows[supernode.rows + i]) * w;
                for (std::size_t k = 0; k < w; ++k)
                    to[k] += *from++;
            }
        }
        for (std::size_t s = supernodes; s-- > 0;) {
            const auto& supernode = symbolic.supernodes[s];
            const std::size_t columns = at(symbolic.columns(s));
            const std::size_t below = at(supernode.below);
            double* const own = x.data() + at(supernode.first) * w;
            std::memcpy(front.data(), own, columns * w * sizeof(double));
            double* to = front.data() + columns * w;
            for (std::size_t i = 0; i < below; ++i) {
                const double* const from = x.data() + at(symbolic.rows[supernode.rows + i]) * w;
                for (std::size_t k = 0; k < w; ++k)
                    *to++ = from[k];
            }
            const auto rows = static_cast<std::ptrdiff_t>(columns + below);
            kernels_->backward(values_.get() + supernode.values, rows, rows, static_cast<std::ptrdiff_t>(columns),
                               front.data(), width);
            std::memcpy(own, front.data(), columns * w * sizeof(double));
        }
        for (std::size_t j = 0; j < n; ++j) {
            for (Eigen::Index k = 0; k < count; ++k) {
                result(symbolic.original[j], first + k) = x[j * w + static_cast<std::size_t>(k)];
            }
        }
    }
    return result;
}

}  // namespace polylap

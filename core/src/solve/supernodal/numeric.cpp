// Multifrontal Cholesky: Duff & Reid, The multifrontal solution of indefinite sparse symmetric linear equations, 1983;
// Liu, The multifrontal method for sparse matrix solution: theory and practice, 1992. A front is assembled from the
// matrix and from what its children contribute, its own columns are eliminated, and the rest of it waits on a stack for
// its parent. The columns are assembled right where the factor keeps them; the stack grows down from the end of the
// same memory, towards the part of the factor that is not yet there.

#include "solve/supernodal/numeric.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "polylap/solve/spd_factor.hpp"
#include "solve/supernodal/panels.hpp"

namespace polylap {
namespace {

std::size_t at(Index v) {
    return static_cast<std::size_t>(v);
}

std::unique_ptr<double[]> allocate(std::size_t count) {
    return std::unique_ptr<double[]>(new double[count + dense::slack]);  // not zeroed: a front is, when its turn comes
}

class Elimination {
public:
    Elimination(const Symbolic& symbolic, const SparseMatrix& a, const dense::Kernels& kernels,
                const std::vector<double*>& fronts, const Monitor& monitor)
        : symbolic_(symbolic),
          a_(a),
          kernels_(kernels),
          monitor_(monitor),
          fronts_(fronts),
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
        const Panels own = symbolic_.panels(s);
        const std::ptrdiff_t columns = own.columns;
        const std::ptrdiff_t below = supernode.below;
        const Panels rest{below, below};  // what this front leaves to its parent
        double* const front = fronts_[s];
        double* const remainder = top_;
        const auto left = static_cast<std::size_t>(rest.doubles());
        if (!assemble(s, front, own)) return not_finite();
        if (supernode.children > 0) {
            std::memset(remainder, 0, sizeof(double) * left);
            add_children(s, front, own, remainder, rest);
        }
        // Panels from the left; each is done with when those to its right know of it.
        for (std::ptrdiff_t j = 0; j < columns; j += Panels::width) {
            double* const panel = front + own.panel(j);
            const std::ptrdiff_t stride = own.stride(j);
            const std::ptrdiff_t width = own.columns_of(j);
            const std::ptrdiff_t refused =
                kernels_.factor(panel, stride, stride, width, least_.data() + j, scratch_.get());
            if (refused >= 0) return not_positive_definite(supernode.first + static_cast<Index>(j + refused));
            const bool first = j == 0 && supernode.children == 0;
            downdate(front, own, j + width, panel + width, stride, width, false);
            downdate(remainder, rest, 0, panel + columns - j, stride, width, first);
            done_ += static_cast<double>(width) * static_cast<double>(stride) * static_cast<double>(stride);
            if (!proceed()) return Error{ErrorCode::cancelled, "cancelled"};
        }
        if (supernode.children > 0) std::memmove(top_, remainder, sizeof(double) * left);
        top_ += left;
        pending_.push_back(static_cast<Index>(s));
        return Done{};
    }

    /// Takes A Aᵀ from the panels from column `from` on. @param a A's row of column `from`
    void downdate(double* c, const Panels& layout, std::ptrdiff_t from, const double* a, std::ptrdiff_t stride,
                  std::ptrdiff_t depth, bool overwrite) {
        for (std::ptrdiff_t j = from; j < layout.columns; j += Panels::width) {
            kernels_.downdate(c + layout.panel(j), layout.stride(j), layout.stride(j), layout.columns_of(j),
                              a + (j - from), stride, depth, overwrite, scratch_.get());
        }
    }

    /// The matrix's own entries. @return false if one is not finite
    bool assemble(std::size_t s, double* front, const Panels& own) {
        const auto& supernode = symbolic_.supernodes[s];
        const Index columns = symbolic_.columns(s);
        std::memset(front, 0, sizeof(double) * static_cast<std::size_t>(own.doubles()));
        const double* const values = a_.valuePtr();
        double check = 0;
        for (Index k = 0; k < columns; ++k) {
            const std::size_t j = at(supernode.first + k);
            const auto* entry = symbolic_.entries_in.data() + symbolic_.entry_start[j];
            const auto* const end = symbolic_.entries_in.data() + symbolic_.entry_start[j + 1];
            double* const column = front + own.column(k);
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

    /// Adds what the children left on the stack, and takes it from there.
    void add_children(std::size_t s, double* front, const Panels& own, double* remainder, const Panels& rest) {
        const auto& supernode = symbolic_.supernodes[s];
        const Index columns = symbolic_.columns(s);
        for (Index k = 0; k < columns; ++k)
            in_front_[at(supernode.first + k)] = k;
        for (Index k = 0; k < supernode.below; ++k)
            in_front_[at(symbolic_.rows[supernode.rows + at(k)])] = columns + k;
        for (Index c = 0; c < supernode.children; ++c) {
            const auto& child = symbolic_.supernodes[at(pending_.back())];
            pending_.pop_back();
            for (Index i = 0; i < child.below; ++i) {
                relative_[at(i)] = in_front_[at(symbolic_.rows[child.rows + at(i)])];
            }
            const Panels given{child.below, child.below};
            top_ -= given.doubles();
            for (Index j = 0; j < child.below; ++j) {
                const Index column = relative_[at(j)];
                double* const to =
                    column < columns ? front + own.column(column) : remainder + rest.column(column - columns) - columns;
                add_column(to, top_ + given.column(j), j, child.below);
            }
        }
    }

    void add_column(double* to, const double* from, Index begin, Index end) {
        const Index* const relative = relative_.data();
        for (Index i = begin; i < end; ++i)
            to[relative[i]] += from[i];
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
    const std::vector<double*>& fronts_;
    std::unique_ptr<double[]> stack_, scratch_;
    double* top_ = nullptr;       ///< Of the stack.
    std::vector<Index> pending_;  ///< Supernodes whose contributions are on the stack.
    std::vector<double> least_;
    std::vector<Index> in_front_, relative_;
    double done_ = 0, told_ = 0;
};

}  // namespace

Status Numeric::factor(const Symbolic& symbolic, const SparseMatrix& a, const Monitor& monitor) {
    make_room(symbolic);
    return Elimination(symbolic, a, *kernels_, fronts_, monitor).run();
}

/// Several pieces find room where one block would not: between what else is in the memory of a WebAssembly module,
/// which never shrinks.
void Numeric::make_room(const Symbolic& symbolic) {
    constexpr std::size_t full = std::size_t{1} << 21;
    const std::size_t count = symbolic.supernodes.size() - 1;
    std::vector<std::size_t> sizes;
    for (std::size_t s = 0; s < count; ++s) {
        if (sizes.empty() || sizes.back() >= full) sizes.push_back(0);
        sizes.back() += static_cast<std::size_t>(symbolic.panels(s).doubles());
    }
    if (sizes != sizes_) {
        sizes_.clear();
        pieces_.clear();
        std::vector<std::unique_ptr<double[]>> pieces;
        pieces.reserve(sizes.size());
        for (const std::size_t size : sizes)
            pieces.push_back(allocate(size));
        pieces_ = std::move(pieces);
        sizes_ = std::move(sizes);
    }
    fronts_.resize(count);
    auto piece = pieces_.begin();
    std::size_t used = 0;
    for (std::size_t s = 0; s < count; ++s) {
        if (used >= full) {
            ++piece;
            used = 0;
        }
        fronts_[s] = piece->get() + used;
        used += static_cast<std::size_t>(symbolic.panels(s).doubles());
    }
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
            double* const mine = x.data() + at(supernode.first) * w;
            std::memcpy(front.data(), mine, columns * w * sizeof(double));
            std::memset(front.data() + columns * w, 0, below * w * sizeof(double));
            const Panels panels = symbolic.panels(s);
            for (std::ptrdiff_t j = 0; j < panels.columns; j += Panels::width) {
                kernels_->forward(fronts_[s] + panels.panel(j), panels.stride(j), panels.stride(j),
                                  panels.columns_of(j), front.data() + j * width, width);
            }
            std::memcpy(mine, front.data(), columns * w * sizeof(double));
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
            double* const mine = x.data() + at(supernode.first) * w;
            std::memcpy(front.data(), mine, columns * w * sizeof(double));
            double* to = front.data() + columns * w;
            for (std::size_t i = 0; i < below; ++i) {
                const double* const from = x.data() + at(symbolic.rows[supernode.rows + i]) * w;
                for (std::size_t k = 0; k < w; ++k)
                    *to++ = from[k];
            }
            const Panels panels = symbolic.panels(s);
            for (std::ptrdiff_t end = panels.columns; end > 0;) {
                const std::ptrdiff_t j = (end - 1) / Panels::width * Panels::width;
                kernels_->backward(fronts_[s] + panels.panel(j), panels.stride(j), panels.stride(j), end - j,
                                   front.data() + j * width, width);
                end = j;
            }
            std::memcpy(mine, front.data(), columns * w * sizeof(double));
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

// Block Lanczos with thick restart: K. Wu, H. Simon, Thick-restart Lanczos method for large symmetric eigenvalue
// problems, SIAM J. Matrix Anal. Appl. 22(2), 2000; in blocks: Y. Zhou, Y. Saad, Block Krylov-Schur method for large
// symmetric eigenvalue problems, Numer. Algorithms 47, 2008. Why blocks: a triangular solve with up to four right-hand
// sides takes little longer than one with a single one, and eigenvalues with several copies, which every symmetric mesh
// has, come at once; a single vector meets the second copy only through rounding.
#include "solve/block_lanczos.hpp"

#include <algorithm>
#include <limits>
#include <random>

#include <Eigen/Eigenvalues>

namespace polylap {
namespace {

/// Columns that shrink by more than this on their way to orthonormality take what others left in them out once more.
constexpr double cancellation = 0.1;

/// A column that is smaller against |A| than this has nothing new: the block has met an invariant subspace.
constexpr double rounding = std::numeric_limits<double>::epsilon();

/// Rows of the basis, some 400 kB of 100 columns, that stay in the cache while all columns of a block pass.
constexpr Eigen::Index rows_at_once = 512;

/// Restarts, so that it ends.
constexpr int most_restarts = 1000;

class BlockLanczos {
public:
    BlockLanczos(const BlockOperator& apply, const Matrix& deflated, const LanczosOptions& options)
        : apply_(apply),
          n_(deflated.rows()),
          fixed_(deflated.cols()),
          pairs_(std::min<Eigen::Index>(options.pairs, n_ - fixed_)),
          block_(options.block),
          tolerance_(options.tolerance),
          random_(options.start),
          most_(std::min<Eigen::Index>(2 * pairs_ + 10 * block_ + 10, n_ - fixed_)),
          basis_(n_, std::min(n_, fixed_ + most_ + block_)),
          projected_(Matrix::Zero(basis_.cols() - fixed_, basis_.cols() - fixed_)) {
        basis_.leftCols(fixed_) = deflated;
    }

    Result<Eigenpairs> run() {
        if (pairs_ == 0) return Eigenpairs{Vector(0), Matrix(n_, 0)};
        Matrix nothing = Matrix::Zero(n_, block_);
        append(nothing);
        next_look_ = 2 * pairs_;
        for (int restarts = 0; restarts < most_restarts;) {
            if (Status status = extend(); !status) return status.error();
            const bool full = done_ + fresh_ > most_ || fresh_ == 0;
            if (!full && done_ < next_look_) continue;
            next_look_ = done_ + std::max(block_, pairs_ / 4);
            const Ritz ritz = look();
            if (ritz.converged) {
                return Eigenpairs{ritz.values.head(pairs_),
                                  basis_.middleCols(fixed_, done_) * ritz.vectors.leftCols(pairs_)};
            }
            if (!full) continue;
            if (fresh_ == 0) break;
            restart(ritz);
            ++restarts;
        }
        return Error{ErrorCode::not_converged, "the eigenvalues did not converge"};
    }

private:
    struct Ritz {
        Vector values;   ///< Descending.
        Matrix vectors;  ///< In the basis.
        bool converged = false;
    };

    /// A on the newest block; what is new in it becomes the next block.
    Status extend() {
        auto image = apply_(basis_.middleCols(fixed_ + done_, fresh_));
        if (!image) return image.error();
        Matrix& w = *image;
        if (!w.allFinite()) return Error{ErrorCode::not_converged, "the eigenvalues are out of range"};
        size_ = std::max(size_, w.colwise().norm().maxCoeff());
        const Eigen::Index all = fixed_ + done_ + fresh_;
        Matrix h = Matrix::Zero(all, fresh_);
        // In exact arithmetic only the last two blocks are met; the sweep over all of them takes rounding out.
        const Eigen::Index near = coupled_ ? all : std::min(all, before_ + fresh_);
        take_out(all - near, near, w, h);
        take_out(0, all, w, h);
        projected_.block(0, done_, done_ + fresh_, fresh_) = h.bottomRows(done_ + fresh_);
        projected_.block(done_, 0, fresh_, done_) = h.middleRows(fixed_, done_).transpose();
        const Eigen::Index from = done_;
        const Eigen::Index width = fresh_;
        before_ = fresh_;
        done_ += fresh_;
        coupled_ = false;
        const Matrix r = append(w);
        projected_.block(done_, from, fresh_, width) = r;
        projected_.block(from, done_, width, fresh_) = r.transpose();
        return Done{};
    }

    /// w -= Q Qᵀ w, Q being columns of the basis; h += Qᵀ w
    void take_out(Eigen::Index first, Eigen::Index count, Matrix& w, Matrix& h) const {
        // Row by row of blocks that stay in the cache for all columns of w; Eigen's product of matrices is slower for
        // few.
        Matrix part = Matrix::Zero(count, w.cols());
        for (Eigen::Index row = 0; row < n_; row += rows_at_once) {
            const auto q = basis_.block(row, first, std::min(rows_at_once, n_ - row), count);
            for (Eigen::Index j = 0; j < w.cols(); ++j)
                part.col(j).noalias() += q.transpose() * w.col(j).segment(row, q.rows());
        }
        for (Eigen::Index row = 0; row < n_; row += rows_at_once) {
            const auto q = basis_.block(row, first, std::min(rows_at_once, n_ - row), count);
            for (Eigen::Index j = 0; j < w.cols(); ++j)
                w.col(j).segment(row, q.rows()).noalias() -= q * part.col(j);
        }
        h.middleRows(first, count) += part;
    }

    /// Appends an orthonormal basis of columns that are orthogonal to all before: w = Q R.
    /// @return R
    Matrix append(Matrix& w) {
        const Eigen::Index begin = fixed_ + done_;
        const double before = w.colwise().norm().maxCoeff();
        fresh_ = std::min(w.cols(), n_ - begin);
        Matrix r = Matrix::Zero(fresh_, w.cols());
        for (Eigen::Index j = 0; j < w.cols(); ++j) {
            const Eigen::Index known = std::min(j, fresh_);
            for (int pass = 0; pass < 2; ++pass) {
                const auto q = basis_.middleCols(begin, known);
                const Vector part = q.transpose() * w.col(j);
                w.col(j).noalias() -= q * part;
                r.col(j).head(known) += part;
            }
            if (j >= fresh_) continue;  // there are no more directions
            const double length = w.col(j).norm();
            if (length > rounding * size_) {
                r(j, j) = length;
                basis_.col(begin + j) = w.col(j) / length;
                if (length < cancellation * before) purify(begin + j);
            } else {
                for (double& x : basis_.col(begin + j))
                    x = 2 * (static_cast<double>(random_() >> 11) * 0x1p-53) - 1;
                purify(begin + j);
            }
        }
        return r;
    }

    /// Makes a column orthogonal to all before, and of length 1.
    void purify(Eigen::Index column) {
        const auto q = basis_.leftCols(column);
        auto x = basis_.col(column);
        for (int pass = 0; pass < 2; ++pass) {
            x.normalize();
            const Vector part = q.transpose() * x;
            x.noalias() -= q * part;
        }
        x.normalize();
    }

    Ritz look() const {
        const Eigen::SelfAdjointEigenSolver<Matrix> solver(projected_.topLeftCorner(done_, done_));
        Ritz ritz{solver.eigenvalues().reverse(), solver.eigenvectors().rowwise().reverse()};
        if (done_ < pairs_ || solver.info() != Eigen::Success) return ritz;
        const Matrix left = projected_.block(done_, 0, fresh_, done_) * ritz.vectors.leftCols(pairs_);
        ritz.converged =
            (left.colwise().norm().transpose().array() <= tolerance_ * ritz.values.head(pairs_).array().abs()).all();
        return ritz;
    }

    /// Goes on from the best Ritz vectors alone; the newest block stays.
    void restart(const Ritz& ritz) {
        const Eigen::Index keep = std::min(pairs_ + (done_ - pairs_) / 2, done_);
        const auto best = ritz.vectors.leftCols(keep);
        const Matrix kept = basis_.middleCols(fixed_, done_) * best;
        const Matrix coupling = projected_.block(done_, 0, fresh_, done_) * best;
        const Matrix newest = basis_.middleCols(fixed_ + done_, fresh_);
        basis_.middleCols(fixed_, keep) = kept;
        basis_.middleCols(fixed_ + keep, fresh_) = newest;
        projected_.setZero();
        projected_.diagonal().head(keep) = ritz.values.head(keep);
        projected_.block(keep, 0, fresh_, keep) = coupling;
        projected_.block(0, keep, keep, fresh_) = coupling.transpose();
        done_ = keep;
        coupled_ = true;
    }

    const BlockOperator& apply_;
    const Eigen::Index n_, fixed_, pairs_, block_;
    const double tolerance_;
    std::mt19937_64 random_;
    const Eigen::Index most_;  ///< Columns that A is applied to between restarts.
    Matrix basis_;             ///< What is deflated, what A has been applied to, and the newest block.
    Matrix projected_;         ///< A in the basis; with a row and a column for each of the newest block.
    Eigen::Index done_ = 0, fresh_ = 0, before_ = 0;  ///< Columns: A applied, newest block, the one before.
    Eigen::Index next_look_ = 0;
    bool coupled_ = false;  ///< The newest block meets all of the basis, as after a restart.
    double size_ = 0;       ///< |A| as far as it is known.
};

}  // namespace

Result<Eigenpairs> largest_eigenpairs(const BlockOperator& apply, const Matrix& deflated,
                                      const LanczosOptions& options) {
    return guard_memory([&] { return BlockLanczos(apply, deflated, options).run(); });
}

}  // namespace polylap

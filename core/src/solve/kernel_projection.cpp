#include "solve/kernel_projection.hpp"

#include <cmath>
#include <limits>

#include <Eigen/SparseCholesky>

namespace polylap {
namespace {

/// Added to KKᵀ, whose diagonal is of order 1, so that it has a factor: far below the singular values squared that
/// matter, far above the rounding of sums.
constexpr double factor_shift = 1e-11;

/// Residuals below this multiple of the largest coordinate are the rounding of b.
constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();

/// Conjugate gradients end where their own gradient has shrunk by this, or has brought nothing for so many steps; a new
/// round begins from the true residual.
constexpr double gradient_reduction = 1e-12;
constexpr int patience = 10;
constexpr int most_steps = 200;
constexpr int most_rounds = 5;

Error cancelled() {
    return {ErrorCode::cancelled, "cancelled"};
}

using Factor = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>>;

/// Eigenvalues of `a` beyond the threshold.
Index count_eigenvalues_above(double threshold, const SparseMatrix& a, Factor& factor) {
    do {
        factor.setShift(-threshold);
        factor.factorize(a);
        threshold *= 1.0625;  // only where a pivot was exactly 0
    } while (factor.info() != Eigen::Success);
    return static_cast<Index>((factor.vectorD().array() > 0).count());
}

}  // namespace

Result<KernelProjection> project_onto_kernel(const SparseMatrix& transposed, const Vector& b, double mu,
                                             Monitor monitor) {
    return guard_memory([&]() -> Result<KernelProjection> {
        KernelProjection result{.shift = Vector::Zero(transposed.rows())};
        if (!monitor.proceed(0)) return cancelled();
        if (transposed.cols() == 0) return result;
        const SparseMatrix k = transposed.transpose();
        const SparseMatrix gram = k * transposed;
        if (!monitor.proceed(0.1)) return cancelled();
        Factor factor;
        factor.analyzePattern(gram);
        if (!monitor.proceed(0.2)) return cancelled();
        result.rank = count_eigenvalues_above(kernel_rank_tolerance * kernel_rank_tolerance, gram, factor);
        if (!monitor.proceed(0.5)) return cancelled();
        const bool exact = 1 / mu < factor_shift;
        factor.setShift(exact ? factor_shift : 1 / mu);
        factor.factorize(gram);
        // Kᵀ(KKᵀ + shift)⁻¹K: nearly the projection onto the rows of K, with eigenvalues σ²/(σ² + shift).
        const auto filter = [&](const Vector& x) { return Vector(transposed * factor.solve(k * x)); };
        if (!exact) {
            result.shift = -filter(b);
            return result;
        }
        const auto error_of = [&](const Vector& x) { return (k * x).lpNorm<Eigen::Infinity>(); };
        const double enough = rounding * b.lpNorm<Eigen::Infinity>();
        Vector best = b;
        double least = error_of(b);
        for (int round = 0; least > enough && round < most_rounds; ++round) {
            const double before = least;
            Vector x = best;
            Vector gradient = filter(x);
            Vector direction = gradient;
            double slope = gradient.squaredNorm();
            const double flat = gradient_reduction * gradient_reduction * slope;
            for (int step = 0, idle = 0; least > enough && slope > flat && idle < patience && step < most_steps;
                 ++step) {
                if (!monitor.proceed(0.8 + 0.2 * (round + step / double{most_steps}) / most_rounds)) return cancelled();
                const Vector bent = filter(direction);
                const double length = slope / direction.dot(bent);
                if (!std::isfinite(length)) break;
                x -= length * direction;
                gradient -= length * bent;
                const double error = error_of(x);
                ++idle;
                if (error < least) {
                    best = x;
                    least = error;
                    idle = 0;
                }
                const double flatter = gradient.squaredNorm();
                direction = gradient + flatter / slope * direction;
                slope = flatter;
            }
            if (least > 0.5 * before) break;
        }
        result.shift = best - b;
        return result;
    });
}

}  // namespace polylap

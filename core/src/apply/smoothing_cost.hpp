#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "polylap/solve/spd_factor.hpp"
#include "solve/dense/kernels.hpp"

namespace polylap {

/// What a smoothing step costs by either solver, in seconds on one core of the machine that the rates were measured on;
/// others change all of them alike, and only ratios decide. Measured on quad tori of 10⁴, 10⁵ and 2.5·10⁵ vertices with
/// t from 0.1 to 100 h², with SSE2 and AVX-512 kernels (`npm run bench`, group iterative): there the solver chosen
/// takes at most a quarter longer than the other one would.
struct SmoothingCost {
    double rows = 0;
    double entries = 0;                  ///< Of the system.
    const SpdAnalysis* known = nullptr;  ///< Null: the analysis is still to be made.
    double lost = 0;                     ///< By steps that an analysis would have made cheaper.

    /// Iterations per root of the mean of (M_ii + t Σ|S_ij|) / M_ii. Measured: 4 to 5 for t from 0.1 to 100 h² on tori,
    /// spheres and Voronoi cells, 3 where iterations are few, 8 with slivers.
    static constexpr double iterations_per_root_condition = 4.5;

    /// What conjugate gradients do before the first iteration, in iterations.
    static constexpr double preparing = 3;

    /// An entry takes 1.8 ns where the matrix stays in the cache (10⁵ entries), 2.6 at 10⁶, 2.9 at 2·10⁶.
    double iteration() const { return entries * (1.8e-9 + 0.8e-9 * std::max(0.0, std::log10(entries / 1e5))); }
    double factor() const { return analysis() + numeric(); }
    double solve() const { return 3e-9 * factor_entries(); }
    /// What a step of so many iterations cost beyond a step with the analysis at hand.
    double loss(int iterations) const {
        return std::max(0.0, (iterations + preparing) * iteration() - numeric() - solve());
    }

private:
    // Nested dissection takes 0.7 µs a row where the graph stays in the cache, 1.8 beyond. As it serves all later
    // steps, what went without it counts towards it.
    double analysis() const {
        const double seconds = 1.8e-6 * rows * std::min(1.0, std::sqrt(rows / 6e4));
        return known == nullptr ? std::max(0.0, seconds - lost) : 0;
    }
    double numeric() const { return seconds_per_flop() * flops() + 6e-9 * factor_entries(); }
    // Nested dissection of a grid, of which surfaces have the separators: O(n^1.5) and O(n log n) (George 1973).
    double flops() const { return known == nullptr ? 55 * std::pow(rows, 1.5) : known->factor_flops(); }
    double factor_entries() const {
        return known == nullptr ? 3.5 * rows * std::log2(rows + 1) : static_cast<double>(known->factor_entries());
    }
    /// The wider the machine's registers, the faster dense blocks are; sparse sweeps wait for memory.
    static double seconds_per_flop() {
        constexpr std::array from_baseline_up{0.063e-9, 0.02e-9, 0.01e-9};
        return from_baseline_up[dense::kernels().size() - 1];
    }
};

}  // namespace polylap

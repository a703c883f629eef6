#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Cholesky>

#include "polylap/solve/spd_factor.hpp"

namespace polylap {

/// The problem of DirichletProblem for pins that come and go: S u = 0 but at pins, u given there. One factor serves any
/// pins: a new one costs a solve, other values at the same pins cost none.
///
/// For S symmetric positive semi-definite with the constants of each connected part as kernel. In each part one vertex
/// g is grounded: S_g = S + Σ s e_g e_gᵀ with s = S_gg is positive definite. Let U_p = S_g⁻¹ e_p be the potential of a
/// unit source at pin p. From 1ᵀ S_g = s e_gᵀ follows s u_g = Σ c for u = Σ c_p U_p: sources whose sum is 0 in each
/// part leave the ground alone, S u = S_g u = Σ c_p e_p. So do constants k, added in each part. What the pins' values
/// ask of c and k is a dense system, positive definite when one pin of each part is expressed by the others.
class PinnedProblem {
public:
    /// Analyses, but factors nothing yet.
    /// @param stiffness V×V, compressed
    /// @param positions V×3, where the vertices lie, for a better ordering; without rows, the graph alone decides
    /// @param known     analyses of other factors, tried before a new one is made
    /// @error bad_argument (S not square or not compressed, another number of positions), out_of_memory, cancelled
    static Result<PinnedProblem> create(const SparseMatrix& stiffness, const Points& positions = {},
                                        std::span<const std::shared_ptr<const SpdAnalysis>> known = {},
                                        Monitor monitor = {});

    /// Fits the lower triangle of S wherever S stores its whole diagonal.
    const std::shared_ptr<const SpdAnalysis>& analysis() const noexcept { return factor_.analysis(); }

    /// Of the factor's numbers and the potentials.
    std::int64_t bytes() const noexcept;

    /// Beyond this, only potentials that the last solve needed are kept.
    static constexpr std::int64_t most_bytes = std::int64_t{128} << 20;
    /// Whether that many pins may pay where nothing is known yet: their potentials keep within most_bytes, and are not
    /// so many that eliminating takes less time on any mesh.
    static bool may_pay(std::size_t pins, Eigen::Index vertices) noexcept;
    /// Whether the potentials of these pins keep within most_bytes, and those not known yet take less time than
    /// eliminating the pins. Where nothing is factored yet, both begin with a factorisation: what is chosen takes at
    /// most twice the time of the better choice, and the next pins have the factor.
    bool pays(std::span<const Index> pins) const;

    /// @param pins distinct vertices   @param values one per pin, finite
    /// @return V values. A vertex that is in no equation and no pin gets NaN.
    /// @error bad_argument (a pin out of range or twice, another number of values, a value not finite, values too far
    ///        apart for the solution to be finite), unconstrained_component (element = lowest vertex of a connected
    ///        part without a pin), not_positive_definite (element = vertex; the kernel is larger, or too nearly so to
    ///        tell), not_converged (pins so strongly coupled that their potentials' difference has lost its digits),
    ///        out_of_memory, cancelled. After the last two but one, elimination may still find an answer.
    Result<Vector> solve(std::span<const Index> pins, const Eigen::Ref<const Vector>& values, Monitor monitor = {});

private:
    struct Potential {
        Index vertex;
        Vector values;
    };

    PinnedProblem() = default;
    Status choose(std::span<const Index> pins, Monitor monitor);
    Status fetch_potentials(std::span<const Index> pins, Monitor monitor);
    Status reduce();
    std::vector<Potential>::const_iterator find(Index vertex) const;

    std::unique_ptr<SparseMatrix> grounded_;  ///< Lower triangle of S_g, until it is factored. Eigen copies what it
                                              ///< should move.
    std::vector<Index> part_;                 ///< Per vertex; -1: in no equation.
    std::vector<Index> part_lowest_;          ///< Per part, its lowest vertex.
    SpdFactor factor_;

    std::vector<Potential> potentials_;         ///< Those of pins_ first and in that order, then what was used before.
    bool chosen_ = false;                       ///< Whether what follows stands.
    std::vector<Index> pins_;                   ///< Of the last solve.
    std::vector<Index> anchor_;                 ///< Per part, the place in pins_ of its first pin.
    std::vector<Index> reduced_;                ///< Places in pins_ of the parts' other pins.
    std::optional<Eigen::LLT<Matrix>> system_;  ///< Of the reduced pins. Eigen leaves an empty one's state unset.
};

}  // namespace polylap

#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "polylap/operators/operator.hpp"
#include "polylap/solve/linear_factor.hpp"

namespace polylap {

struct SmoothingCost;

/// Diagonal: nothing to solve, as in explicit steps with a lumped mass.
enum class SmoothingSolver : std::uint8_t { cholesky, lu, conjugate_gradients, diagonal };

/// E.g. "conjugate-gradients": what JavaScript and the command line show.
std::string_view solver_name(SmoothingSolver solver) noexcept;

/// What solved the last step.
struct SmoothingSolve {
    SmoothingSolver solver = SmoothingSolver::cholesky;
    int iterations = 0;  ///< Of conjugate gradients.
};

/// Where a step led.
struct SmoothingStep {
    Points points;  ///< V×3
    SmoothingSolve solve;
};

struct SmootherOptions {
    /// Automatic: whichever a model of their costs expects to be the faster one. Iterative: conjugate gradients, but
    /// for operators that are not positive semi-definite. Where these fail, a factor takes over.
    enum class Choice : std::uint8_t { automatic, direct, iterative } choice = Choice::automatic;
    int steps = 1;  ///< How many the system will serve, as far as is known.
    /// V×3, for a better ordering of the factor; to last until the next update. Null: the graph alone decides.
    const Points* positions = nullptr;
    /// Analyses of other factors, tried before one is made: null or as analysis() gives them.
    std::span<const std::shared_ptr<const SpdAnalysis>> known = {};
    /// Vertices that stay where they are (Dirichlet conditions), distinct.
    std::span<const Index> fixed = {};
};

/// One implicit Euler step of the heat flow, (M + t S) x' = M x (Desbrun, Meyer, Schröder & Barr 1999). The smaller t,
/// the closer the system is to the diagonal, and the sooner conjugate gradients from x beat a factor; the more steps
/// it serves, the sooner the factor pays. Both meet |M x - (M + tS) x'| ≤ residual_tolerance · |M x| in each
/// coordinate, as far as rounding allows.
class ImplicitSmoother {
public:
    /// @param matrices any S; M diagonal or sparse, symmetric positive definite   @param time t > 0, length²
    /// @error bad_argument (t not positive, sizes that do not fit, a fixed vertex out of range or twice),
    ///        mass_not_positive (element = vertex: its diagonal entry of M), not_positive_definite (M + t S is not, or
    ///        is singular if S is not positive semi-definite; element = vertex, -1 where none can be named; step says
    ///        so where conjugate gradients were to serve), out_of_memory, cancelled
    static Result<ImplicitSmoother> create(const OperatorMatrices& matrices, double time,
                                           const SmootherOptions& options = {}, Monitor monitor = {});

    /// Nothing to solve before an update.
    ImplicitSmoother();

    /// The same for other values of S, M and t: keeps the ordering and symbolic analysis while the pattern stands.
    Status update(const OperatorMatrices& matrices, double time, const SmootherOptions& options = {},
                  Monitor monitor = {});
    /// The same, but a factor is left to the first step that needs one: the matrices may go before it takes memory.
    Status update_later(const OperatorMatrices& matrices, double time, const SmootherOptions& options = {});
    /// Whether the next step begins with a factor, as far as is known.
    bool needs_factor() const;
    /// Of memory for the factor's numbers.
    std::int64_t bytes() const noexcept { return factor_.bytes(); }

    /// Fits M + t S, where S is positive semi-definite its lower triangle. Null before there was a Cholesky factor.
    const std::shared_ptr<const SpdAnalysis>& analysis() const noexcept;

    /// @param points V×3   @return V×3. Vertices without an equation (in no face) stay, and fixed ones.
    /// @error bad_argument (another number of rows, a point not finite, no system without an update that went well),
    ///        not_positive_definite (see create), out_of_memory, cancelled
    Result<Points> step(const Points& points, Monitor monitor = {});

    /// How the last step was solved.
    const SmoothingSolve& last_solve() const noexcept { return last_; }

private:
    Status build(const OperatorMatrices& matrices, double time, const SmootherOptions& options);
    SmoothingCost cost() const;
    /// Up to how many a step cost less than the factor, of what it takes to go on from here.
    double iterations_worth_a_factor() const;
    bool iterations_pay() const;
    Status factor(Monitor monitor);
    Result<Points> solve(const Points& points, Monitor monitor);
    Result<Points> iterate(const Points& points, const Points& rhs, Monitor monitor);

    SparseMatrix mass_;  ///< With 1 on the diagonal of vertices in no face.
    /// M + tS for that mass; only its lower triangle where a Cholesky factor is all that reads it, nothing once it is
    /// factored.
    SparseMatrix system_;
    /// t S_IB: what free vertices have from the fixed ones; system_ leaves it out.
    std::vector<Eigen::Triplet<double, Index>> coupling_;
    std::vector<Index> fixed_;
    bool whole_ = false;  ///< Whether system_ is all of it.
    double entries_ = 0;  ///< Of all of M + tS.
    Structure structure_ = Structure::positive_semidefinite;
    bool keeps_constants_ = false;  ///< S 1 = 0
    double condition_ = 1;          ///< Mean over the rows of (M_ii + t Σ|S_ij|) / M_ii.
    SmootherOptions::Choice choice_ = SmootherOptions::Choice::automatic;
    int steps_to_come_ = 1;
    const Points* positions_ = nullptr;

    LinearFactor factor_;
    bool ready_ = false;                    ///< There is a system to solve.
    bool analysed_ = false;                 ///< analysis() is of its pattern.
    bool factored_ = false;                 ///< factor_ is its factor.
    double iterations_per_root_condition_;  ///< As the last iterative step had them.
    double lost_without_analysis_ = 0;      ///< Seconds, over all systems.
    int iterations_spent_ = 0;              ///< On this system.
    SmoothingSolve last_;
};

}  // namespace polylap

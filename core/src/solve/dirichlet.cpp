#include "polylap/solve/dirichlet.hpp"

#include <limits>
#include <string>

namespace polylap {
namespace {

enum class Role : std::uint8_t { free, fixed, isolated };

/// Checks that each equation leads to a fixed vertex, going from a row to its entries and their rows; marks vertices
/// without an equation, and in none, as isolated.
Status reach_all(const SparseMatrix& s, Structure structure, std::vector<Role>& role) {
    std::vector<char> reached(role.size(), 0);
    std::vector<char> in_use(role.size(), 0);
    std::vector<Index> stack;
    const auto visit = [&](Index v) {
        if (reached[static_cast<std::size_t>(v)] != 0) return;
        reached[static_cast<std::size_t>(v)] = 1;
        stack.push_back(v);
    };
    for (Index v = 0; v < s.cols(); ++v) {
        if (role[static_cast<std::size_t>(v)] == Role::fixed) visit(v);
        for (SparseMatrix::InnerIterator it(s, v); it; ++it) {
            if (it.value() == 0) continue;
            in_use[static_cast<std::size_t>(it.index())] = 1;
            in_use[static_cast<std::size_t>(v)] = 1;
        }
    }
    while (!stack.empty()) {
        const Index v = stack.back();
        stack.pop_back();
        for (SparseMatrix::InnerIterator it(s, v); it; ++it) {  // the rows that depend on v
            if (it.value() != 0) visit(it.index());
        }
    }
    for (Index v = 0; v < s.cols(); ++v) {
        if (reached[static_cast<std::size_t>(v)] != 0) continue;
        if (in_use[static_cast<std::size_t>(v)] != 0) {
            const std::string name = "vertex " + std::to_string(v);
            return Error{ErrorCode::unconstrained_component,
                         structure == Structure::general ? name + " does not depend on any fixed vertex"
                                                         : "the connected part with " + name + " has no fixed vertex",
                         v};
        }
        role[static_cast<std::size_t>(v)] = Role::isolated;
    }
    return Done{};
}

/// The factor's refusal in terms of vertices.
Error name_vertex(Error error, const std::vector<Index>& free) {
    if (error.code != ErrorCode::not_positive_definite) return error;
    error.message = "the fixed values do not determine the solution";
    if (error.element >= 0) {
        error.element = free[static_cast<std::size_t>(error.element)];
        error.message += ": its equations leave the value at vertex " + std::to_string(error.element) +
                         " open, or contradict each other there";
    }
    return error;
}

}  // namespace

Result<DirichletProblem> DirichletProblem::create(const SparseMatrix& stiffness, std::span<const Index> fixed,
                                                  Structure structure) {
    return guard_memory([&]() -> Result<DirichletProblem> {
        const auto n = static_cast<Index>(stiffness.cols());
        if (stiffness.rows() != stiffness.cols()) {
            return Error{ErrorCode::bad_argument, "the stiffness has " + std::to_string(stiffness.rows()) +
                                                      " rows and " + std::to_string(n) + " columns"};
        }
        std::vector<Role> role(static_cast<std::size_t>(n), Role::free);
        std::vector<Index> local(static_cast<std::size_t>(n), -1);  // row among the free, or among the fixed
        for (std::size_t k = 0; k < fixed.size(); ++k) {
            const Index v = fixed[k];
            if (v < 0 || v >= n) {
                return Error{ErrorCode::bad_argument,
                             "vertex " + std::to_string(v) + " cannot be fixed: there are " + std::to_string(n) +
                                 " vertices (counted from 0)",
                             v};
            }
            if (role[static_cast<std::size_t>(v)] == Role::fixed) {
                return Error{ErrorCode::bad_argument, "vertex " + std::to_string(v) + " is fixed twice", v};
            }
            role[static_cast<std::size_t>(v)] = Role::fixed;
            local[static_cast<std::size_t>(v)] = static_cast<Index>(k);
        }
        if (Status status = reach_all(stiffness, structure, role); !status) return status.error();

        DirichletProblem problem;
        problem.size_ = n;
        problem.fixed_.assign(fixed.begin(), fixed.end());
        for (Index v = 0; v < n; ++v) {
            if (role[static_cast<std::size_t>(v)] != Role::free) continue;
            local[static_cast<std::size_t>(v)] = static_cast<Index>(problem.free_.size());
            problem.free_.push_back(v);
        }
        std::vector<Eigen::Triplet<double, Index>> inner;
        std::vector<Eigen::Triplet<double, Index>> outer;
        for (Index column = 0; column < n; ++column) {
            const Role kind = role[static_cast<std::size_t>(column)];
            if (kind == Role::isolated) continue;
            auto& block = kind == Role::free ? inner : outer;
            for (SparseMatrix::InnerIterator it(stiffness, column); it; ++it) {
                const auto row = static_cast<std::size_t>(it.index());
                if (role[row] == Role::free) {
                    block.emplace_back(local[row], local[static_cast<std::size_t>(column)], it.value());
                }
            }
        }
        const auto free_count = static_cast<Index>(problem.free_.size());
        SparseMatrix inner_matrix(free_count, free_count);
        inner_matrix.setFromTriplets(inner.begin(), inner.end());
        problem.coupling_.resize(free_count, static_cast<Index>(fixed.size()));
        problem.coupling_.setFromTriplets(outer.begin(), outer.end());
        if (Status status = problem.factor_.factor(inner_matrix, structure); !status) {
            return name_vertex(status.error(), problem.free_);
        }
        return problem;
    });
}

Result<Matrix> DirichletProblem::solve(const Eigen::Ref<const Matrix>& fixed_values) const {
    if (fixed_values.rows() != static_cast<Eigen::Index>(fixed_.size())) {
        return Error{ErrorCode::bad_argument, std::to_string(fixed_.size()) + " vertices are fixed, but " +
                                                  std::to_string(fixed_values.rows()) + " values were given"};
    }
    for (Eigen::Index k = 0; k < fixed_values.rows(); ++k) {
        if (fixed_values.row(k).allFinite()) continue;
        const Index v = fixed_[static_cast<std::size_t>(k)];
        return Error{ErrorCode::bad_argument, "the value at vertex " + std::to_string(v) + " is not a finite number",
                     v};
    }
    return guard_memory([&]() -> Result<Matrix> {
        const auto free_values = factor_.solve(-(coupling_ * fixed_values));
        if (!free_values) return free_values.error();
        if (!free_values->allFinite()) {
            return Error{ErrorCode::bad_argument, "the fixed values are too far apart for double precision"};
        }
        Matrix u = Matrix::Constant(size_, fixed_values.cols(), std::numeric_limits<double>::quiet_NaN());
        for (std::size_t k = 0; k < free_.size(); ++k) {
            u.row(free_[k]) = free_values->row(static_cast<Eigen::Index>(k));
        }
        for (std::size_t k = 0; k < fixed_.size(); ++k) {
            u.row(fixed_[k]) = fixed_values.row(static_cast<Eigen::Index>(k));
        }
        return u;
    });
}

}  // namespace polylap

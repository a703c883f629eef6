#include "polylap/solve/dirichlet.hpp"

#include <limits>
#include <string>

#include "solve/fixed_vertices.hpp"

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
            if (structure != Structure::general) return unconstrained_part(v);
            return Error{ErrorCode::unconstrained_component,
                         "vertex " + std::to_string(v) + " does not depend on any fixed vertex", v};
        }
        role[static_cast<std::size_t>(v)] = Role::isolated;
    }
    return Done{};
}

/// Rows of the free vertices, in the columns that `local` numbers from 0; what `keep` refuses is left out. Two passes:
/// count, then fill.
template <class Keep>
SparseMatrix cut_out(const SparseMatrix& s, std::span<const Index> columns, const std::vector<Role>& role,
                     const std::vector<Index>& local, Index rows, Keep&& keep) {
    SparseMatrix block(rows, static_cast<Index>(columns.size()));
    const auto for_entries = [&](auto&& visit) {
        for (std::size_t j = 0; j < columns.size(); ++j) {
            for (SparseMatrix::InnerIterator it(s, columns[j]); it; ++it) {
                const auto row = static_cast<std::size_t>(it.index());
                if (role[row] == Role::free && keep(it.index(), columns[j])) visit(j, local[row], it.value());
            }
        }
    };
    Index* const start = block.outerIndexPtr();
    for_entries([&](std::size_t j, Index, double) { ++start[j + 1]; });
    for (std::size_t j = 0; j < columns.size(); ++j) {
        start[j + 1] += start[j];
    }
    block.resizeNonZeros(start[columns.size()]);
    Index next = 0;
    for_entries([&](std::size_t, Index row, double value) {
        block.innerIndexPtr()[next] = row;
        block.valuePtr()[next++] = value;
    });
    return block;
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
                                                  Structure structure, const Points& positions, Monitor monitor) {
    return guard_memory([&]() -> Result<DirichletProblem> {
        const auto n = static_cast<Index>(stiffness.cols());
        if (stiffness.rows() != stiffness.cols()) {
            return Error{ErrorCode::bad_argument, "the stiffness has " + std::to_string(stiffness.rows()) +
                                                      " rows and " + std::to_string(n) + " columns"};
        }
        if (positions.rows() != 0 && positions.rows() != stiffness.rows()) {
            return Error{ErrorCode::bad_argument, "the stiffness has " + std::to_string(n) + " rows, but " +
                                                      std::to_string(positions.rows()) + " positions were given"};
        }
        auto places = places_of(fixed, n);
        if (!places) return places.error();
        std::vector<Role> role(static_cast<std::size_t>(n), Role::free);
        for (const Index v : fixed) {
            role[static_cast<std::size_t>(v)] = Role::fixed;
        }
        if (Status status = reach_all(stiffness, structure, role); !status) return status.error();

        DirichletProblem problem;
        problem.size_ = n;
        problem.fixed_.assign(fixed.begin(), fixed.end());
        std::vector<Index>& local = *places;  // row among the free, or among the fixed
        for (Index v = 0; v < n; ++v) {
            if (role[static_cast<std::size_t>(v)] != Role::free) continue;
            local[static_cast<std::size_t>(v)] = static_cast<Index>(problem.free_.size());
            problem.free_.push_back(v);
        }
        const std::vector<Index>& free = problem.free_;
        const auto free_count = static_cast<Index>(free.size());
        problem.coupling_ =
            cut_out(stiffness, problem.fixed_, role, local, free_count, [](Index, Index) { return true; });
        // Cholesky reads no more than the lower triangle.
        const bool lower = structure == Structure::positive_semidefinite;
        const SparseMatrix inner = cut_out(stiffness, free, role, local, free_count,
                                           [&](Index row, Index column) { return !lower || row >= column; });
        Points places_in_space(positions.rows() == 0 ? 0 : free_count, 3);
        for (Eigen::Index k = 0; k < places_in_space.rows(); ++k) {
            places_in_space.row(k) = positions.row(free[static_cast<std::size_t>(k)]);
        }
        if (Status status = problem.factor_.factor(inner, structure, places_in_space, monitor); !status) {
            return name_vertex(status.error(), free);
        }
        return problem;
    });
}

Result<Matrix> DirichletProblem::solve(const Eigen::Ref<const Matrix>& fixed_values) const {
    if (Status status = check_values(fixed_, fixed_values); !status) return status.error();
    return guard_memory([&]() -> Result<Matrix> {
        const auto free_values = factor_.solve(-(coupling_ * fixed_values));
        if (!free_values) return free_values.error();
        if (!free_values->allFinite()) return values_too_far_apart();
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

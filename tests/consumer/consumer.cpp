#include <iostream>
#include <polylap/mesh/shapes.hpp>
#include <polylap/operators/operator.hpp>
#include <polylap/solve/dirichlet.hpp>

int main() {
    const auto mesh = polylap::make_grid(2, 2).value();  // vertices 0 1 2 | 3 4 5 | 6 7 8: 4 is the centre
    const std::vector<polylap::Index> fixed = {0, 1, 2, 3, 5, 6, 7, 8};
    const polylap::Vector values{{0, 1, 0, 1, 1, 0, 1, 0}};
    for (const polylap::OperatorInfo* info : polylap::operators()) {
        const auto matrices = polylap::build_operator(mesh, {.id = info->id}).value();
        const auto problem = polylap::DirichletProblem::create(matrices.stiffness, fixed).value();
        std::cout << info->id << ' ' << problem.solve(values).value()(4, 0) << '\n';
    }
}

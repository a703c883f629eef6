#pragma once

#include <string>
#include <vector>

#include "polylap/operators/operator.hpp"

namespace polylap {

/// One mesh of a sequence under refinement.
struct ConvergenceLevel {
    Index vertices = 0;
    double h = 0;      ///< Root of the mean squared edge length.
    double error = 0;  ///< L² error of the solution (the lumped mass at each vertex), relative to the exact one's norm.
    double order = 0;  ///< log(error ratio) / log(h ratio) to the level before; NaN at the first.
};

/// One family of meshes refined, and a problem with a known solution on it.
struct ConvergenceStudy {
    std::string family;   ///< E.g. "skewed quad grid".
    std::string problem;  ///< E.g. "Δu = 0, u = eˣ sin y on the boundary".
    bool only_triangles = false;
    bool planar_faces = false;  ///< All faces of all its meshes lie in planes.
    std::vector<ConvergenceLevel> levels;
    double order = 0;        ///< Of the last two levels.
    bool converges = false;  ///< The problem was solved on all levels, each time with an order > least_order.
    std::string failure;     ///< Why there are no more levels, e.g. the operator refused a mesh; else empty.
};

/// Below this order errors do not shrink reliably.
inline constexpr double least_order = 0.5;

/// Solves Dirichlet problems on refined planar meshes and Poisson problems on refined spheres with one operator: the
/// property Con of Wardetzky et al. 2007. Vertex weights are those of other meshes and do not enter.
/// @error unknown_operator, bad_argument, parameter_out_of_range, out_of_memory, cancelled; another failure of the
/// operator or of a solver ends its family, with the reason
Result<std::vector<ConvergenceStudy>> study_convergence(const OperatorSpec& spec, Monitor monitor = {});

}  // namespace polylap

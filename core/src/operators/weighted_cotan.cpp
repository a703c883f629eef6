#include "polylap/operators/weighted_cotan.hpp"

#include "operators/triangulated.hpp"

namespace polylap {

Result<OperatorMatrices> weighted_cotan_matrices(const PolygonMesh& mesh, std::span<const double> weights,
                                                 WeightedCotanOptions options, Monitor monitor) {
    return guard_memory([&]() -> Result<OperatorMatrices> {
        OperatorMatrices out;
        out.structure = Structure::symmetric;
        Status status = triangulated_operator(mesh, weights, options.rule, options.mass, out, monitor);
        if (!status) return status.error();
        return out;
    });
}

constinit const OperatorInfo weighted_cotan_info{
    .id = "weighted-cotan",
    .label = "Cotan, weighted",
    .formula_latex =
        R"(w_{ij} = \sum_k \frac{d_{ik} - d_{ij}\cos\gamma_i}{|e_{ij}|\,\sin\gamma_i},\; d_{ij} = \frac{|e_{ij}|^2 + \omega_i - \omega_j}{2\,|e_{ij}|})",
    .citation =
        "D. Glickenstein: A monotonicity property for weighted Delaunay triangulations. Discrete & Computational "
        "Geometry 38(4), 2007; Herholz 2012, eq. 3.24 and 3.25",
    .bibtex = R"(@article{glickenstein2007,
  author = {David Glickenstein},
  title = {A monotonicity property for weighted {D}elaunay triangulations},
  journal = {Discrete \& Computational Geometry},
  volume = {38},
  number = {4},
  year = {2007}
})",
    .summary =
        "Dual over primal lengths, as for the cotan operator, with dual edges that weights of the vertices move.",
    .parameters = triangulated_parameters,
    .takes_vertex_weights = true,
    .sum_over_faces = true,
    .rule = triangulated_rule,
    .claims = {.symmetric = {Claim::yes, "an edge and its dual have one length each"},
               .local = {Claim::yes, "a sum over triangles inside faces"},
               .positive_weights = {Claim::no, "dual edges may run backwards"},
               .positive_semidefinite = {Claim::no, "large weights turn dual edges around"},
               .constants_in_kernel = {Claim::yes, "only differences along edges enter"},
               .linear_precision = {Claim::yes, "the dual edges around a vertex, orthogonal to its edges, close up"},
               .maximum_principle = {Claim::no, "a negative weight lets values overshoot"},
               .convergent = {Claim::no, "large weights can even make it singular"}},
    .build =
        [](const PolygonMesh& mesh, const OperatorSpec& spec, OperatorMatrices& out, Monitor monitor) {
            return triangulated_operator(mesh, spec.vertex_weights, triangulated_rule(spec),
                                         static_cast<MassRule>(static_cast<int>(spec.values[1])), out, monitor);
        },
};

}  // namespace polylap

#include "polylap/operators/normalized_graph.hpp"

#include <cmath>

#include "operators/edge_graph.hpp"
#include "operators/sparse_pattern.hpp"

namespace polylap {

namespace {

Status stiffness(const PolygonMesh& mesh, SparseMatrix& out, Monitor monitor) {
    return graph_laplacian_over([](double d_i, double d_j) { return std::sqrt(d_i * d_j); }, mesh, out, monitor);
}

}  // namespace

Result<SparseMatrix> normalized_graph_stiffness(const PolygonMesh& mesh, Monitor monitor) {
    SparseMatrix out;
    if (Status status = stiffness(mesh, out, monitor); !status) return status.error();
    return out;
}

constinit const OperatorInfo normalized_graph_info{
    .id = "normalized-graph",
    .label = "Normalised graph",
    .formula_latex = R"(w_{ij} = 1 / \sqrt{d_i d_j})",
    .citation = "F. Chung: Spectral graph theory. AMS 1997; Herholz 2012, section 3.2",
    .bibtex = R"(@book{chung1997,
  author = {Fan R. K. Chung},
  title = {Spectral graph theory},
  series = {CBMS Regional Conference Series in Mathematics},
  volume = {92},
  publisher = {American Mathematical Society},
  year = {1997},
  doi = {10.1090/cbms/092}
})",
    .summary = "The graph Laplacian, scaled symmetrically by the numbers of neighbours.",
    .parameters = {},
    .claims = {.symmetric = {Claim::yes, "both ends of an edge enter alike"},
               .local = {Claim::yes, "only edges have weights"},
               .positive_weights = {Claim::yes, "every weight is one over a root"},
               .positive_semidefinite = {Claim::yes, "the graph Laplacian, scaled from both sides"},
               .constants_in_kernel = {Claim::no, "its kernel are the roots of the numbers of neighbours"},
               .linear_precision = {Claim::no, "a vertex need not lie at the mean of its neighbours"},
               .maximum_principle = {Claim::no, "vertices of many neighbours rise above the rest"},
               .convergent = {Claim::no, "it knows nothing of lengths and angles"}},
    .build =
        [](const PolygonMesh& mesh, const OperatorSpec&, OperatorMatrices& out, Monitor monitor) {
            assemble_lumped_mass(mesh, out.mass);
            return stiffness(mesh, out.stiffness, monitor);
        },
};

}  // namespace polylap

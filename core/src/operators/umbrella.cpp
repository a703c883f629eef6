#include "polylap/operators/umbrella.hpp"

#include "operators/edge_graph.hpp"
#include "operators/sparse_pattern.hpp"

namespace polylap {

namespace {

Status stiffness(const PolygonMesh& mesh, SparseMatrix& out, Monitor monitor) {
    return graph_laplacian(mesh, out, monitor);
}

}  // namespace

Result<SparseMatrix> umbrella_stiffness(const PolygonMesh& mesh, Monitor monitor) {
    SparseMatrix out;
    if (Status status = stiffness(mesh, out, monitor); !status) return status.error();
    return out;
}

constinit const OperatorInfo umbrella_info{
    .id = "umbrella",
    .label = "Umbrella",
    .formula_latex = R"(w_{ij} = 1)",
    .citation =
        "G. Taubin: A signal processing approach to fair surface design. SIGGRAPH 1995; Herholz 2012, section 3.2",
    .bibtex = R"(@inproceedings{taubin1995,
  author = {Gabriel Taubin},
  title = {A signal processing approach to fair surface design},
  booktitle = {Proceedings of the 22nd Annual Conference on Computer Graphics and Interactive Techniques (SIGGRAPH '95)},
  pages = {351--358},
  year = {1995},
  doi = {10.1145/218380.218473}
})",
    .summary = "The graph Laplacian of the edges: every neighbour counts alike, wherever it lies.",
    .parameters = {},
    .claims = {.symmetric = {Claim::yes, "an edge has the same weight from both ends"},
               .local = {Claim::yes, "only edges have weights"},
               .positive_weights = {Claim::yes, "every weight is 1"},
               .positive_semidefinite = {Claim::yes, "a sum of squared differences along edges"},
               .constants_in_kernel = {Claim::yes, "only differences along edges enter"},
               .linear_precision = {Claim::no, "a vertex need not lie at the mean of its neighbours"},
               .maximum_principle = {Claim::yes, "a harmonic value is the mean of its neighbours"},
               .convergent = {Claim::no, "it knows nothing of lengths and angles"}},
    .build =
        [](const PolygonMesh& mesh, const OperatorSpec&, OperatorMatrices& out, Monitor monitor) {
            assemble_lumped_mass(mesh, out.mass);
            return stiffness(mesh, out.stiffness, monitor);
        },
};

}  // namespace polylap

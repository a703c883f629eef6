#include "polylap/operators/tutte.hpp"

#include "operators/edge_graph.hpp"
#include "operators/sparse_pattern.hpp"

namespace polylap {

namespace {

Status stiffness(const PolygonMesh& mesh, SparseMatrix& out, Monitor monitor) {
    return graph_laplacian_over([](double d_i, double) { return d_i; }, mesh, out, monitor);
}

}  // namespace

Result<SparseMatrix> tutte_stiffness(const PolygonMesh& mesh, Monitor monitor) {
    SparseMatrix out;
    if (Status status = stiffness(mesh, out, monitor); !status) return status.error();
    return out;
}

constinit const OperatorInfo tutte_info{
    .id = "tutte",
    .label = "Tutte",
    .formula_latex = R"(w_{ij} = 1 / d_i)",
    .citation = "W. T. Tutte: How to draw a graph. Proc. London Math. Soc. 13, 1963; Herholz 2012, section 3.2",
    .bibtex = R"(@article{tutte1963,
  author = {William T. Tutte},
  title = {How to draw a graph},
  journal = {Proceedings of the London Mathematical Society},
  volume = {s3-13},
  number = {1},
  pages = {743--767},
  year = {1963},
  doi = {10.1112/plms/s3-13.1.743}
})",
    .summary = "The difference of each value from the mean of its neighbours along edges.",
    .parameters = {},
    .claims = {.symmetric = {Claim::no, "each end of an edge divides by its own number of neighbours"},
               .local = {Claim::yes, "only edges have weights"},
               .positive_weights = {Claim::yes, "every weight is one over a number of neighbours"},
               .positive_semidefinite = {Claim::no,
                                         "its spectrum lies in [0, 2], but uᵀSu can be negative where the "
                                         "numbers of neighbours differ"},
               .constants_in_kernel = {Claim::yes, "a constant equals the mean of its neighbours"},
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

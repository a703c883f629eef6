#include "polylap/operators/cotan.hpp"

#include "operators/triangulated.hpp"

namespace polylap {

Result<OperatorMatrices> cotan_matrices(const PolygonMesh& mesh, CotanOptions options, Monitor monitor) {
    return guard_memory([&]() -> Result<OperatorMatrices> {
        OperatorMatrices out;
        Status status = triangulated_operator(mesh, {}, options.rule, options.mass, out, monitor);
        if (!status) return status.error();
        return out;
    });
}

constinit const OperatorInfo cotan_info{
    .id = "cotan",
    .label = "Cotan",
    .formula_latex = R"(w_{ij} = \tfrac12\left(\cot\gamma_{ij} + \cot\gamma_{ji}\right))",
    .citation =
        "U. Pinkall, K. Polthier: Computing discrete minimal surfaces and their conjugates. Experimental Mathematics "
        "2(1), 1993; Herholz 2012, eq. 3.16",
    .bibtex = R"(@article{pinkall1993,
  author = {Ulrich Pinkall and Konrad Polthier},
  title = {Computing discrete minimal surfaces and their conjugates},
  journal = {Experimental Mathematics},
  volume = {2},
  number = {1},
  pages = {15--36},
  year = {1993},
  doi = {10.1080/10586458.1993.10504266}
})",
    .summary = "Linear finite elements on the triangles that the faces are cut into, in space.",
    .parameters = triangulated_parameters,
    .sum_over_faces = true,
    .rule = triangulated_rule,
    .claims = {.symmetric = {Claim::yes, "cotangents weigh both directions of an edge alike"},
               .local = {Claim::yes, "a sum over triangles inside faces"},
               .positive_weights = {Claim::no, "two angles opposite an edge can exceed 180° in sum"},
               .positive_semidefinite = {Claim::yes, "each triangle adds a Dirichlet energy"},
               .constants_in_kernel = {Claim::yes, "only differences along edges enter"},
               .linear_precision = {Claim::yes, "S x is the gradient of the area of the triangles"},
               .maximum_principle = {Claim::no, "a negative weight lets values overshoot"},
               .convergent = {Claim::some,
                              "linear finite elements; not with the mass ring, which is six times the area"}},
    .build =
        [](const PolygonMesh& mesh, const OperatorSpec& spec, OperatorMatrices& out, Monitor monitor) {
            return triangulated_operator(mesh, {}, triangulated_rule(spec),
                                         static_cast<MassRule>(static_cast<int>(spec.values[1])), out, monitor);
        },
};

}  // namespace polylap

#include "polylap/operators/alexa_wardetzky.hpp"

#include <array>
#include <cmath>

#include "operators/edge_gradient.hpp"

namespace polylap {

namespace {

Status build(const PolygonMesh& mesh, double lambda, OperatorMatrices& out, Monitor monitor) {
    if (!(lambda >= 0) || !std::isfinite(lambda)) {
        return Error{ErrorCode::parameter_out_of_range, "lambda must be a finite number ≥ 0"};
    }
    return assemble_faces(mesh, EdgeGradient(lambda), out, monitor);
}

constexpr std::array parameters{lambda_parameter("λ = ½ is the five-point star on squares")};

}  // namespace

Result<SparseMatrix> alexa_wardetzky_stiffness(const PolygonMesh& mesh, AlexaWardetzkyOptions options,
                                               Monitor monitor) {
    return stiffness_of([&](OperatorMatrices& out) { return build(mesh, options.lambda, out, monitor); });
}

constinit const OperatorInfo alexa_wardetzky_info{
    .id = "alexa-wardetzky",
    .label = "Alexa–Wardetzky",
    .formula_latex =
        R"(S_f = \delta^{\mathrm T}\Bigl(\tfrac{1}{|a|}\,B B^{\mathrm T} + \lambda\, C C^{\mathrm T}\Bigr)\delta)",
    .citation =
        "M. Alexa, M. Wardetzky: Discrete Laplacians on general polygonal meshes. ACM Trans. Graph. 30(4), 2011; "
        "Herholz 2012, eq. 4.29",
    .bibtex = R"(@article{alexa2011,
  author = {Marc Alexa and Max Wardetzky},
  title = {Discrete {L}aplacians on general polygonal meshes},
  journal = {ACM Transactions on Graphics},
  volume = {30},
  number = {4},
  year = {2011},
  doi = {10.1145/2010324.1964997}
})",
    .summary = "Edge vectors against the vector area of each face, stabilised by λ where they see nothing.",
    .parameters = parameters,
    .sum_over_faces = true,
    .claims = {.symmetric = {Claim::yes, "a sum of symmetric matrices of faces"},
               .local = {Claim::yes, "a sum over faces"},
               .positive_weights = {Claim::no, "λ > ½ makes every diagonal of a square negative"},
               .positive_semidefinite = {Claim::yes, "a sum of squares; λ = 0 has more in its kernel than constants"},
               .constants_in_kernel = {Claim::yes, "only differences along edges enter"},
               .linear_precision = {Claim::yes, "on planar faces S x is the gradient of the area"},
               .maximum_principle = {Claim::no, "negative weights let values overshoot"},
               .convergent = {Claim::some,
                              "consistent on linear functions; λ = 0 stabilises nothing, and large λ drowns the rest"}},
    .build = [](const PolygonMesh& mesh, const OperatorSpec& spec, OperatorMatrices& out,
                Monitor monitor) { return build(mesh, spec.values[0], out, monitor); },
};

}  // namespace polylap

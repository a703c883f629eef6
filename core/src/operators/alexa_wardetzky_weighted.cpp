#include "polylap/operators/alexa_wardetzky_weighted.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "operators/edge_gradient.hpp"
#include "operators/vertex_weights.hpp"
#include "polylap/operators/mass.hpp"

namespace polylap {
namespace {

Status check(const AlexaWardetzkyWeightedOptions& options) {
    if (options.lambda >= 0 && std::isfinite(options.lambda)) return Done{};
    return Error{ErrorCode::parameter_out_of_range, "lambda must be a finite number ≥ 0"};
}

Error edge_without_length(std::size_t i, std::size_t next) {
    return {ErrorCode::degenerate_face,
            "its edge between corners " + std::to_string(i) + " and " + std::to_string(next) + " has no length"};
}

}  // namespace

Result<SparseMatrix> alexa_wardetzky_weighted_stiffness(const PolygonMesh& mesh, std::span<const double> weights,
                                                        AlexaWardetzkyWeightedOptions options, Monitor monitor) {
    if (Status status = check(options); !status) return status.error();
    if (Status status = check_vertex_weights(mesh, weights); !status) return status.error();
    EdgeGradient face(options.lambda);
    std::vector<double> shift;
    return assemble_faces(mesh, monitor, [&](std::span<const Index> vertices, Corners x, LocalMatrix& s) -> Status {
        if (weights.empty()) return face(x, {}, s);
        shift.assign(x.size(), 0.0);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const std::size_t next = i + 1 == x.size() ? 0 : i + 1;
            const double difference =
                weights[static_cast<std::size_t>(vertices[i])] - weights[static_cast<std::size_t>(vertices[next])];
            if (difference == 0) continue;
            const double length = (x[next] - x[i]).stableNorm();
            if (length == 0) return edge_without_length(i, next);
            shift[i] = difference / length / (2 * length);
        }
        return face(x, shift, s);
    });
}

Result<Matrix> alexa_wardetzky_weighted_face(Corners corners, std::span<const double> distances,
                                             AlexaWardetzkyWeightedOptions options) {
    return guard_memory([&]() -> Result<Matrix> {
        if (Status status = check(options); !status) return status.error();
        const std::size_t n = corners.size();
        if (n < 3 || distances.size() != n) {
            return Error{ErrorCode::bad_argument, "a face needs three corners or more, and one distance for each"};
        }
        const auto finite = [](const auto& x) { return x.allFinite(); };
        if (!std::all_of(corners.begin(), corners.end(), finite)) {
            return Error{ErrorCode::bad_argument, "the corners must be finite"};
        }
        std::vector<double> shift(n);
        for (std::size_t i = 0; i < n; ++i) {
            if (!std::isfinite(distances[i])) return Error{ErrorCode::bad_argument, "the distances must be finite"};
            const std::size_t next = i + 1 == n ? 0 : i + 1;
            const double length = (corners[next] - corners[i]).stableNorm();
            if (length == 0) return edge_without_length(i, next);
            shift[i] = distances[i] / length - 0.5;
        }
        Matrix matrix = Matrix::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
        LocalMatrix s(matrix.data(), matrix.rows(), matrix.cols());
        if (Status status = EdgeGradient(options.lambda)(corners, shift, s); !status) return status.error();
        return matrix;
    });
}

namespace {

constexpr std::array parameters{lambda_parameter("the stabiliser of the unweighted operator")};

}  // namespace

constinit const OperatorInfo alexa_wardetzky_weighted_info{
    .id = "alexa-wardetzky-weighted",
    .label = "Alexa–Wardetzky, weighted",
    .formula_latex =
        R"(S_f = \delta^{\mathrm T}\Bigl(\tfrac{1}{|a|}\,B (B^w)^{\mathrm T} + \lambda\, C C^{\mathrm T}\Bigr)\delta,\; b^w_i = x_i + \tfrac{|e_i|^2 + \omega_i - \omega_{i+1}}{2|e_i|^2}\, e_i)",
    .citation =
        "P. Herholz: General discrete Laplace operators on polygonal meshes. Diploma thesis, Humboldt-Universität zu "
        "Berlin, 2012, Lemma 4 and eq. 4.31",
    .summary = "Alexa and Wardetzky's operator with points on the edges that weights of the vertices move.",
    .parameters = parameters,
    .takes_vertex_weights = true,
    .claims = {.symmetric = {Claim::triangles, "on larger faces only few weights leave it symmetric"},
               .local = {Claim::yes, "a sum over faces"},
               .positive_weights = {Claim::no, "already without weights of vertices, λ > ½ makes diagonals negative"},
               .positive_semidefinite = {Claim::no, "large weights turn dual edges around"},
               .constants_in_kernel = {Claim::yes, "only differences along edges enter"},
               .linear_precision = {Claim::triangles, "on larger faces only the transpose is precise"},
               .maximum_principle = {Claim::no, "negative weights let values overshoot"},
               .convergent = {Claim::no, "large weights can even make it singular"}},
    .build =
        [](const PolygonMesh& mesh, const OperatorSpec& spec, Monitor monitor) {
            return with_lumped_mass(mesh, alexa_wardetzky_weighted_stiffness(mesh, spec.vertex_weights,
                                                                             {.lambda = spec.values[0]}, monitor));
        },
};

}  // namespace polylap

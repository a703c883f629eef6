#include "polylap/operators/alexa_wardetzky_weighted.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "operators/bibliography.hpp"
#include "operators/edge_gradient.hpp"
#include "operators/vertex_weights.hpp"

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

/// The unweighted kernel with the shifts that weights make.
class WeightedGradient {
public:
    WeightedGradient(double lambda, std::span<const double> weights) : gradient_(lambda), weights_(weights) {}

    template <std::size_t n>
    Status operator()(const Face<n>& face, LocalMatrix<n>& s, std::span<double, n> masses) {
        if (weights_.empty()) return gradient_(face, s, masses);
        const auto& x = face.x;
        shift_.assign(x.size(), 0.0);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const std::size_t next = i + 1 == x.size() ? 0 : i + 1;
            const double difference = weights_[static_cast<std::size_t>(face.vertices[i])] -
                                      weights_[static_cast<std::size_t>(face.vertices[next])];
            if (difference == 0) continue;
            const double length = (x[next] - x[i]).stableNorm();
            if (length == 0) return edge_without_length(i, next);
            shift_[i] = difference / length / (2 * length);
        }
        gradient_.fill_shifted(face, shift_, s);
        return Done{};
    }

private:
    EdgeGradient gradient_;
    std::span<const double> weights_;
    std::vector<double> shift_;
};

Status build(const PolygonMesh& mesh, std::span<const double> weights, const AlexaWardetzkyWeightedOptions& options,
             OperatorMatrices& out, Monitor monitor) {
    if (Status status = check(options); !status) return status;
    if (Status status = check_vertex_weights(mesh, weights); !status) return status;
    return assemble_faces(mesh, WeightedGradient(options.lambda, weights), out, monitor);
}

}  // namespace

Result<SparseMatrix> alexa_wardetzky_weighted_stiffness(const PolygonMesh& mesh, std::span<const double> weights,
                                                        AlexaWardetzkyWeightedOptions options, Monitor monitor) {
    return stiffness_of([&](OperatorMatrices& out) { return build(mesh, weights, options, out, monitor); });
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
        Face<std::dynamic_extent> face{{}, corners, vector_area(corners), 0};
        face.area = safe_norm(face.vector_area);
        if (is_zero_area(corners, face.area)) {
            return Error{ErrorCode::degenerate_face, "its vector area is zero"};
        }
        LocalMatrix<std::dynamic_extent> s(matrix.data(), matrix.rows(), matrix.cols());
        EdgeGradient(options.lambda).fill_shifted(face, shift, s);
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
    .bibtex = herholz_2012,
    .summary = "Alexa and Wardetzky's operator with points on the edges that weights of the vertices move.",
    .parameters = parameters,
    .takes_vertex_weights = true,
    .sum_over_faces = true,
    .claims = {.symmetric = {Claim::triangles, "on larger faces only few weights leave it symmetric"},
               .local = {Claim::yes, "a sum over faces"},
               .positive_weights = {Claim::no, "already without weights of vertices, λ > ½ makes diagonals negative"},
               .positive_semidefinite = {Claim::no, "large weights turn dual edges around"},
               .constants_in_kernel = {Claim::yes, "only differences along edges enter"},
               .linear_precision = {Claim::triangles, "on larger faces only the transpose is precise"},
               .maximum_principle = {Claim::no, "negative weights let values overshoot"},
               .convergent = {Claim::no, "large weights can even make it singular"}},
    .build = [](const PolygonMesh& mesh, const OperatorSpec& spec, OperatorMatrices& out,
                Monitor monitor) { return build(mesh, spec.vertex_weights, {.lambda = spec.values[0]}, out, monitor); },
};

}  // namespace polylap

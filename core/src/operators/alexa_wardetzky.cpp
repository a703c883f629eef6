#include "polylap/operators/alexa_wardetzky.hpp"

#include <array>
#include <cmath>

#include "operators/assemble_faces.hpp"
#include "polylap/operators/mass.hpp"

namespace polylap {
namespace {

/// x minus its part along the unit vector q, twice: once leaves rounding errors of the size of what was removed.
template <class Column, class Unit>
void orthogonalise(Column&& x, const Unit& q) {
    x -= q * q.dot(x);
    x -= q * q.dot(x);
}

/// S_f = δᵀ(BBᵀ/|a| + λ(I - QQᵀ))δ, Q an orthonormal basis of the columns of the projected edges Ē.
///
/// With D = δᵀB (rows ½(xᵢ₋₁ - xᵢ₊₁)) and R = δᵀQ that is D Dᵀ/|a| + λ(δᵀδ - R Rᵀ).
class LocalStiffness {
public:
    explicit LocalStiffness(double lambda) : lambda_(lambda) {}

    Status operator()(Corners x, LocalMatrix& s) {
        if (!project_maximally(x, projection_)) {
            return Error{ErrorCode::degenerate_face, "its vector area is zero"};
        }
        const auto n = static_cast<Index>(x.size());
        const auto next = [n](Index i) { return i + 1 == n ? 0 : i + 1; };
        const auto& p = projection_.points;
        basis_.resize(n, 2);
        for (Index i = 0; i < n; ++i) {
            basis_.row(i) = p[static_cast<std::size_t>(next(i))] - p[static_cast<std::size_t>(i)];
        }
        // The longer column first: the other one cannot vanish against it unless the area does.
        if (basis_.col(0).squaredNorm() < basis_.col(1).squaredNorm()) basis_.col(0).swap(basis_.col(1));
        basis_.col(0).normalize();
        orthogonalise(basis_.col(1), basis_.col(0));
        basis_.col(1).normalize();

        rows_.resize(n, 5);
        const double lambda_root = std::sqrt(lambda_);
        const double area_root = std::sqrt(projection_.area);
        for (Index i = 0; i < n; ++i) {
            const Index before = i == 0 ? n - 1 : i - 1;
            rows_.row(i).head<3>() =
                (x[static_cast<std::size_t>(before)] - x[static_cast<std::size_t>(next(i))]) / (2 * area_root);
            rows_.row(i).tail<2>() = lambda_root * (basis_.row(before) - basis_.row(i));
        }
        for (Index j = 0; j < n; ++j) {
            for (Index i = j; i < n; ++i) {
                s(i, j) = rows_.row(i).head<3>().dot(rows_.row(j).head<3>()) -
                          rows_.row(i).tail<2>().dot(rows_.row(j).tail<2>());
                s(j, i) = s(i, j);
            }
        }
        for (Index i = 0; i < n; ++i) {
            s(i, i) += 2 * lambda_;
            s(i, next(i)) -= lambda_;
            s(next(i), i) -= lambda_;
        }
        return Done{};
    }

private:
    double lambda_;
    Projection projection_;
    Eigen::Matrix<double, Eigen::Dynamic, 2> basis_;
    Eigen::Matrix<double, Eigen::Dynamic, 5> rows_;
};

}  // namespace

Result<SparseMatrix> alexa_wardetzky_stiffness(const PolygonMesh& mesh, AlexaWardetzkyOptions options,
                                               Monitor monitor) {
    if (!(options.lambda >= 0) || !std::isfinite(options.lambda)) {
        return Error{ErrorCode::parameter_out_of_range, "lambda must be a finite number ≥ 0"};
    }
    return assemble_faces(mesh, monitor, LocalStiffness(options.lambda));
}

namespace {

constexpr std::array<Parameter, 1> parameters{{
    {.id = "lambda",
     .label = "λ",
     .kind = Parameter::Kind::real,
     .min = 0,
     .max = 1e6,
     .slider_max = 2,
     .step = 0.01,
     .initial = 1,
     .hint = "λ = ½ is the five-point star on squares"},
}};

}  // namespace

constinit const OperatorInfo alexa_wardetzky_info{
    .id = "alexa-wardetzky",
    .label = "Alexa–Wardetzky",
    .formula_latex =
        R"(S_f = \delta^{\mathrm T}\Bigl(\tfrac{1}{|a|}\,B B^{\mathrm T} + \lambda\, C C^{\mathrm T}\Bigr)\delta)",
    .citation =
        "M. Alexa, M. Wardetzky: Discrete Laplacians on general polygonal meshes. ACM Trans. Graph. 30(4), 2011; "
        "Herholz 2012, eq. 4.29",
    .summary = "Edge vectors against the vector area of each face, stabilised by λ where they see nothing.",
    .parameters = parameters,
    .claims = {.symmetric = {Claim::yes, "a sum of symmetric matrices of faces"},
               .local = {Claim::yes, "a sum over faces"},
               .positive_weights = {Claim::no, "λ > ½ makes every diagonal of a square negative"},
               .positive_semidefinite = {Claim::yes, "a sum of squares; λ = 0 has more in its kernel than constants"},
               .constants_in_kernel = {Claim::yes, "only differences along edges enter"},
               .linear_precision = {Claim::yes, "on planar faces S x is the gradient of the area"},
               .maximum_principle = {Claim::no, "negative weights let values overshoot"},
               .convergent = {Claim::yes, "consistent on linear functions, stabilised by λ > 0"}},
    .build =
        [](const PolygonMesh& mesh, const OperatorSpec& spec, Monitor monitor) {
            return with_lumped_mass(mesh, alexa_wardetzky_stiffness(mesh, {.lambda = spec.values[0]}, monitor));
        },
};

}  // namespace polylap

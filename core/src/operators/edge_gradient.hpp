#pragma once

#include <span>

#include "operators/assemble_faces.hpp"
#include "polylap/base/parameter.hpp"

namespace polylap {

/// The matrix of one face after Alexa & Wardetzky 2011, with free points on its edges [Herholz 2012, eq. 4.29 and
/// 4.31]: S_f = δᵀ( B (Bʷ)ᵀ/|a| + λ(I - QQᵀ) )δ. B are the midpoints of the edges, Bʷ the points xᵢ + (½ + shiftᵢ) eᵢ,
/// Q an orthonormal basis of the columns of the projected edges Ē.
///
/// With D = δᵀB (rows ½(xᵢ₋₁ - xᵢ₊₁)), Dʷ = δᵀBʷ and R = δᵀQ that is D Dʷᵀ/|a| + λ(δᵀδ - R Rᵀ).
class EdgeGradient {
public:
    explicit EdgeGradient(double lambda) : lambda_(lambda) {}

    /// @param shift n: how far the point of each edge lies past its middle, in lengths of the edge; empty: all 0
    /// @error degenerate_face
    Status operator()(Corners x, std::span<const double> shift, LocalMatrix& s);

private:
    double lambda_;
    Projection projection_;
    Eigen::Matrix<double, Eigen::Dynamic, 2> basis_;
    Eigen::Matrix<double, Eigen::Dynamic, 8> rows_;  ///< D | Dʷ, both over √|a|, | √λ R
};

constexpr Parameter lambda_parameter(const char* hint) {
    return {.id = "lambda",
            .label = "λ",
            .kind = Parameter::Kind::real,
            .min = 0,
            .max = 1e6,
            .slider_max = 2,
            .step = 0.01,
            .initial = 1,
            .hint = hint};
}

}  // namespace polylap

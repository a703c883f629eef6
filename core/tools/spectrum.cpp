// The command `spectrum`.
#include <cmath>
#include <iomanip>
#include <sstream>

#include "json_text.hpp"
#include "open_session.hpp"
#include "tables.hpp"

namespace polylap::tool {
namespace {

/// |S x - μ M x| of each pair in the norm of M⁻¹, for x of length 1 in that of M: an eigenvalue lies within it of μ.
Vector residuals(const OperatorMatrices& matrices, const Eigenpairs& pairs) {
    Vector inverse_root = matrices.mass.diagonal();
    for (double& mass : inverse_root)
        mass = mass > 0 ? 1 / std::sqrt(mass) : 0;  // vertices in no face are in no equation
    const Matrix left = matrices.stiffness * pairs.vectors - matrices.mass * pairs.vectors * pairs.values.asDiagonal();
    return (inverse_root.asDiagonal() * left).colwise().norm();
}

/// The same vectors, each with its largest entry positive.
Matrix with_fixed_signs(Matrix modes) {
    for (Eigen::Index k = 0; k < modes.cols(); ++k) {
        Eigen::Index largest = 0;
        modes.col(k).cwiseAbs().maxCoeff(&largest);
        if (modes(largest, k) < 0) modes.col(k) *= -1;
    }
    return modes;
}

}  // namespace

Result<Outputs> spectrum(const MeshChoice& mesh, const OperatorChoice& choice, Index count, bool json,
                         const std::string& modes_path) {
    auto session = open_with_operator(mesh, choice);
    if (!session) return session.error();
    const auto pairs = session->spectrum(side, count);
    if (!pairs) return in_file(mesh.path, pairs.error());
    const auto matrices = session->matrices(side);
    if (!matrices) return in_file(mesh.path, matrices.error());
    const Vector residual = residuals(**matrices, *pairs);

    ordered_json document{
        {"operator", choice.id}, {"vertices", session->mesh().vertex_count()}, {"pairs", ordered_json::array()}};
    std::ostringstream text;
    text << "S x = mu M x, mu in 1/length^2; an eigenvalue lies within the residual of each\n\n"
         << std::left << std::setw(8) << "mode" << std::setw(24) << "eigenvalue"
         << "residual\n";
    for (Eigen::Index k = 0; k < residual.size(); ++k) {
        document["pairs"].push_back({{"eigenvalue", pairs->values[k]}, {"residual", residual[k]}});
        text << std::setw(8) << k << std::setprecision(12) << std::setw(24) << pairs->values[k] << std::setprecision(2)
             << residual[k] << '\n';
    }
    Outputs outputs{{"-", json ? dump(document) : text.str()}};
    if (!modes_path.empty()) outputs.push_back({modes_path, modes_csv(with_fixed_signs(pairs->vectors))});
    return outputs;
}

}  // namespace polylap::tool

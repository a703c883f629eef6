#include "polylap/operators/planar.hpp"

#include <array>

#include "operators/bibliography.hpp"
#include "operators/triangle_sum.hpp"
#include "polylap/face/triangulate_mesh.hpp"

namespace polylap {
namespace {

/// Cotangents of the projected triangle, counter-clockwise (Pinkall & Polthier 1993; Herholz 2012, eq. 3.16).
inline Eigen::Matrix3d projected_cotan(const FaceTriangle& triangle) {
    const auto p = [&](std::size_t k) -> const Eigen::Vector2d& {
        return triangle.points[static_cast<std::size_t>(triangle.corners[k % 3])];
    };
    const double half_inverse = 0.5 / cross(p(1) - p(0), p(2) - p(0));
    Vector3 w;
    for (std::size_t k = 0; k < 3; ++k) {
        w[static_cast<Eigen::Index>(k)] = (p(k + 1) - p(k)).dot(p(k + 2) - p(k)) * half_inverse;
    }
    return triangle_laplacian(w);
}

Status build(const PolygonMesh& mesh, TriangulationRule rule, OperatorMatrices& out, Monitor monitor) {
    const auto local = [](const FaceTriangle& triangle) { return projected_cotan(triangle); };
    return assemble_triangles(mesh, rule, MassRule::lumped, local, out, monitor);
}

constexpr std::array parameters{
    choice_parameter("rule", "rule", triangulation_rule_names, "how the projected face is triangulated")};

TriangulationRule rule_of(const OperatorSpec& spec) {
    return static_cast<TriangulationRule>(static_cast<int>(spec.values[0]));
}

}  // namespace

Result<SparseMatrix> planar_stiffness(const PolygonMesh& mesh, PlanarOptions options, Monitor monitor) {
    return stiffness_of([&](OperatorMatrices& out) { return build(mesh, options.rule, out, monitor); });
}

constinit const OperatorInfo planar_info{
    .id = "planar",
    .label = "Planar",
    .formula_latex = R"(w_{ij} = \tfrac12\left(\cot\gamma_{ij} + \cot\gamma_{ji}\right))",
    .citation =
        "P. Herholz: General discrete Laplace operators on polygonal meshes. Diploma thesis, Humboldt-Universität zu "
        "Berlin, 2012, section 4.2.4",
    .bibtex = herholz_2012,
    .summary =
        "Each face is projected along its vector area and triangulated there; the cotangents of its triangles are "
        "summed.",
    .parameters = parameters,
    .sum_over_faces = true,
    .rule = rule_of,
    .claims = {.symmetric = {Claim::yes, "cotangents weigh both directions of an edge alike"},
               .local = {Claim::yes, "a sum over faces"},
               .positive_weights = {Claim::no, "two angles opposite an edge can exceed 180° in sum"},
               .positive_semidefinite = {Claim::yes, "each triangle adds a Dirichlet energy"},
               .constants_in_kernel = {Claim::yes, "only differences along edges enter"},
               .linear_precision = {Claim::yes, "planar faces are projected onto themselves"},
               .maximum_principle = {Claim::no, "a negative weight lets values overshoot"},
               .convergent = {Claim::yes, "linear finite elements on the projected triangles"}},
    .build = [](const PolygonMesh& mesh, const OperatorSpec& spec, OperatorMatrices& out,
                Monitor monitor) { return build(mesh, rule_of(spec), out, monitor); },
};

}  // namespace polylap

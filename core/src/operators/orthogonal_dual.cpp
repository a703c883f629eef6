#include "polylap/operators/orthogonal_dual.hpp"

#include <vector>

#include "operators/bibliography.hpp"
#include "operators/sparse_pattern.hpp"

namespace polylap {

Result<SparseMatrix> orthogonal_dual_stiffness(const PolygonMesh& mesh, DualOptions options, Monitor monitor) {
    const auto dual = orthogonal_dual(mesh, options, monitor);
    if (!dual) return dual.error();
    return guard_memory([&]() -> Result<SparseMatrix> {
        std::vector<Eigen::Triplet<double, Index>> entries;
        entries.reserve(4 * dual->edges.size());
        for (const DualEdge& e : dual->edges) {
            entries.emplace_back(e.v0, e.v0, e.weight);
            entries.emplace_back(e.v1, e.v1, e.weight);
            entries.emplace_back(e.v0, e.v1, -e.weight);
            entries.emplace_back(e.v1, e.v0, -e.weight);
        }
        SparseMatrix stiffness(mesh.vertex_count(), mesh.vertex_count());
        stiffness.setFromTriplets(entries.begin(), entries.end());
        return stiffness;
    });
}

// The compromise μ > 0 is no parameter here: it would cost linear precision, the reason to have this operator.
constinit const OperatorInfo orthogonal_dual_info{
    .id = "orthogonal-dual",
    .label = "Orthogonal dual",
    .formula_latex =
        R"(w_{ij} = \frac{d_k + d_l}{|e_{ij}|},\quad \langle v_k - v_l,\, e_{ij}\rangle = 0,\quad \sum_k |v_k - b_k|^2 \to \min)",
    .citation =
        "P. Herholz: General discrete Laplace operators on polygonal meshes. Diploma thesis, Humboldt-Universität zu "
        "Berlin, 2012, section 4.1",
    .bibtex = herholz_2012,
    .summary =
        "Dual edges are made orthogonal to the edges, with dual vertices as near to the barycentres as that allows; a "
        "weight is the signed length of the dual edge over that of the edge.",
    .parameters = {},
    .claims = {.symmetric = {Claim::yes, "one weight per edge"},
               .local = {Claim::yes, "weights sit on edges only"},
               .positive_weights = {Claim::no, "a dual vertex may lie beyond an edge of its face"},
               .positive_semidefinite = {Claim::no, "enough negative weights make the energy negative"},
               .constants_in_kernel = {Claim::yes, "only differences along edges enter"},
               .linear_precision = {Claim::yes, "dual edges orthogonal to the edges close up around a vertex"},
               .maximum_principle = {Claim::no, "negative weights let values overshoot"},
               .convergent = {Claim::no, "where the constraints fight, the nearest dual lies far from the mesh"}},
    .build = [](const PolygonMesh& mesh, const OperatorSpec&, OperatorMatrices& out, Monitor monitor) -> Status {
        auto stiffness = orthogonal_dual_stiffness(mesh, {}, monitor);
        if (!stiffness) return stiffness.error();
        out.stiffness.swap(*stiffness);
        assemble_lumped_mass(mesh, out.mass);
        return Done{};
    },
};

}  // namespace polylap

// Wardetzky et al.'s "no free lunch" table, executable: each property of each line of the operator table, at all its
// choices, several values of its parameters and random weights of vertices, holds on the whole zoo where it is claimed,
// and has a counter-example in the zoo where it is not. Convergence is studied elsewhere. Nothing here knows an
// operator.

#include <cmath>
#include <limits>
#include <map>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "operator_cases.hpp"

namespace polylap::test {
namespace {

// How far each property is from holding, relative to the matrix.
constexpr double holds = 1e-11;  // beyond rounding
constexpr double broken = 1e-6;  // a counter-example that no rounding makes

double asymmetry(const PolygonMesh&, const SparseMatrix& s) {
    return difference(s, s.transpose());
}

double reach(const PolygonMesh& mesh, const SparseMatrix& s) {
    const Index vertices = mesh.vertex_count();
    std::vector<char> near(static_cast<std::size_t>(vertices) * static_cast<std::size_t>(vertices), 0);
    const auto at = [vertices](Index i, Index j) {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(vertices) + static_cast<std::size_t>(j);
    };
    for (Index f = 0; f < mesh.face_count(); ++f) {
        for (const Index i : mesh.face(f)) {
            for (const Index j : mesh.face(f)) {
                near[at(i, j)] = 1;
            }
        }
    }
    double worst = 0;
    for (Index j = 0; j < s.cols(); ++j) {
        for (SparseMatrix::InnerIterator it(s, j); it; ++it) {
            if (near[at(static_cast<Index>(it.row()), j)] == 0) worst = std::max(worst, std::abs(it.value()));
        }
    }
    return worst;
}

double negativity(const PolygonMesh&, const SparseMatrix& s) {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(Matrix((s + SparseMatrix(s.transpose())) / 2),
                                                       Eigen::EigenvaluesOnly);
    return std::max(0.0, -solver.eigenvalues()[0]);
}

double constants(const PolygonMesh&, const SparseMatrix& s) {
    return (s * Vector::Ones(s.cols())).cwiseAbs().maxCoeff();
}

double imprecision(const PolygonMesh& mesh, const SparseMatrix& s) {
    const Points sx = s * (mesh.positions().rowwise() - mesh.positions().row(0));
    double worst = 0;
    for (const Index v : flat_inner_vertices(mesh)) {
        worst = std::max(worst, sx.row(v).norm() / bounding_size(mesh));
    }
    return worst;
}

double negative_weight(const PolygonMesh&, const SparseMatrix& s) {
    double worst = 0;
    for (Index j = 0; j < s.cols(); ++j) {
        for (SparseMatrix::InnerIterator it(s, j); it; ++it) {
            if (it.row() != j) worst = std::max(worst, it.value());
        }
    }
    return worst;
}

/// How far harmonic functions leave the range of their boundary values: u_I = H u_B with H = -S_II⁻¹ S_IB stays within
/// it for every u_B exactly where H ≥ 0 and H 1 = 1. The boundary is that of the mesh, and the first face of every
/// component.
double overshoot(const PolygonMesh& mesh, const SparseMatrix& s) {
    const Topology topology = build_topology(*mesh.connectivity());
    std::vector<char> fixed(static_cast<std::size_t>(mesh.vertex_count()), 0);
    std::vector<char> seen(static_cast<std::size_t>(topology.component_count), 0);
    for (const Index v : topology.boundary_vertices) {
        fixed[static_cast<std::size_t>(v)] = 1;
    }
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto component = static_cast<std::size_t>(topology.component[static_cast<std::size_t>(mesh.face(f)[0])]);
        if (seen[component] != 0) continue;
        seen[component] = 1;
        for (const Index v : mesh.face(f)) {
            fixed[static_cast<std::size_t>(v)] = 1;
        }
    }
    std::vector<Index> inner;
    std::vector<Index> outer;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        if (topology.component[static_cast<std::size_t>(v)] < 0) continue;
        (fixed[static_cast<std::size_t>(v)] != 0 ? outer : inner).push_back(v);
    }
    if (inner.empty()) return 0;
    const Matrix dense(s);
    const Eigen::FullPivLU<Matrix> lu(dense(inner, inner));
    if (!lu.isInvertible()) return std::numeric_limits<double>::infinity();  // harmonic functions are not unique
    const Matrix h = -lu.solve(dense(inner, outer));
    const double leaves = std::max(-h.minCoeff(), (h.rowwise().sum().array() - 1).abs().maxCoeff());
    return leaves * largest(s);  // unlike the others, it does not grow with S
}

struct Check {
    PropertyClaim PropertyClaims::*claim;
    double (*violation)(const PolygonMesh&, const SparseMatrix&);
    Index most_vertices;
};
constexpr Check checks[] = {{&PropertyClaims::symmetric, asymmetry, 1000},
                            {&PropertyClaims::local, reach, 1000},
                            {&PropertyClaims::positive_weights, negative_weight, 1000},
                            {&PropertyClaims::positive_semidefinite, negativity, 120},
                            {&PropertyClaims::constants_in_kernel, constants, 1000},
                            {&PropertyClaims::linear_precision, imprecision, 1000},
                            {&PropertyClaims::maximum_principle, overshoot, 170}};

class Claims : public testing::TestWithParam<std::size_t> {};

TEST_P(Claims, HoldWhereClaimedAndFailWhereNot) {
    const PropertyInfo& property = properties()[GetParam()];
    const auto* check =
        std::find_if(std::begin(checks), std::end(checks), [&](const Check& c) { return c.claim == property.claim; });
    ASSERT_NE(check, std::end(checks)) << property.id;
    std::map<std::string, int> held;
    std::map<std::string, std::string> counter_example;
    const auto claim_of = [&](const std::string& id) { return (get(find_operator(id))->claims.*check->claim).where; };
    for_all(
        [&](const Specimen& s, const OperatorSpec& spec, const OperatorMatrices& m, double scale) {
            const double violation = check->violation(s.mesh, m.stiffness) / scale;
            if (claimed(claim_of(spec.id), s.mesh)) {
                ++held[spec.id];
                EXPECT_LE(violation, holds) << property.id;
            } else if (violation > broken) {
                counter_example[spec.id] = s.name;
            }
        },
        check->most_vertices);
    for (const OperatorInfo* info : operators()) {
        if (claim_of(info->id) == Claim::yes) {
            EXPECT_GE(held[info->id], 30) << info->id << ", " << property.id;
        } else {
            EXPECT_NE(counter_example[info->id], "")
                << info->id << " never violates " << property.id << ", the claim is too weak";
        }
    }
}

std::string property_name(const testing::TestParamInfo<std::size_t>& test) {
    return properties()[test.param].id;
}
// All but the last one, convergence.
INSTANTIATE_TEST_SUITE_P(Table, Claims, testing::Range<std::size_t>(0, std::size(checks)), property_name);

TEST(Claims, CoverTheTableButConvergence) {
    ASSERT_EQ(properties().size(), std::size(checks) + 1);
    EXPECT_EQ(properties().back().claim, &PropertyClaims::convergent);
}

TEST(Claims, HaveReasons) {
    for (const OperatorInfo* info : operators()) {
        for (const PropertyInfo& property : properties()) {
            EXPECT_GT(std::string_view((info->claims.*property.claim).why).size(), 10u) << info->id << property.id;
        }
    }
}

// What solvers may rely on follows from the claims.
TEST(Claims, DecideTheStructure) {
    for_all([](const Specimen&, const OperatorSpec& spec, const OperatorMatrices& m, double) {
        const PropertyClaims& claims = get(find_operator(spec.id))->claims;
        const bool symmetric = claims.symmetric.where == Claim::yes;
        const bool semidefinite = symmetric && claims.positive_semidefinite.where == Claim::yes;
        EXPECT_EQ(m.structure, semidefinite ? Structure::positive_semidefinite
                               : symmetric  ? Structure::symmetric
                                            : Structure::general);
    });
}

TEST(Zoo, TestsWhatItShould) {
    Index flat = 0;
    for (const char* name : {"grid-8x8-skew", "zigzag", "cube-3"}) {
        EXPECT_TRUE(planar_faces(specimen(name))) << name;
        EXPECT_GE(flat_inner_vertices(specimen(name)).size(), 20u) << name;
    }
    for (const auto& [name, mesh] : zoo()) {
        flat += static_cast<Index>(flat_inner_vertices(mesh).size());
    }
    EXPECT_GE(flat, 100);
    EXPECT_TRUE(planar_faces(specimen("saddle-7"))) << "f(x) + g(y) has planar quads";
    EXPECT_TRUE(flat_inner_vertices(specimen("saddle-7")).empty());
    for (const char* name : {"saddle-12x12", "torus-10x7-noisy", "wavy-4", "moebius"}) {
        EXPECT_GT(non_planarity(specimen(name)), 1e-3) << name;
    }
    EXPECT_TRUE(only_triangles(specimen("triangle-sphere-2")));
    EXPECT_GE(all_specs().size(), 20u);
}

}  // namespace
}  // namespace polylap::test

// What is measured agrees with plain dense computations and never contradicts a claim of the table, for every operator
// on the whole zoo. Nothing here knows an operator.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "polylap/apply/properties.hpp"
#include "polylap/mesh/shapes.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using Verdict = Measurement::Verdict;

/// What the report says where it can be computed plainly.
void compare_with_dense(const PolygonMesh& mesh, const OperatorMatrices& matrices, const PropertyReport& report) {
    const Topology topology = build_topology(*mesh.connectivity());
    std::vector<Index> referenced;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        if (topology.component[static_cast<std::size_t>(v)] >= 0) referenced.push_back(v);
    }
    const Matrix s = Matrix(matrices.stiffness)(referenced, referenced);
    const double scale = s.diagonal().cwiseAbs().maxCoeff();
    const auto at = [&](PropertyClaim PropertyClaims::*claim) -> const Measurement& {
        for (const Measurement& m : report.measurements) {
            if (m.property->claim == claim) return m;
        }
        throw std::runtime_error("not measured");
    };
    const auto expect = [&](PropertyClaim PropertyClaims::*claim, bool holds, double value, double tolerance) {
        EXPECT_EQ(at(claim).verdict, holds ? Verdict::holds : Verdict::fails) << at(claim).text;
        EXPECT_NEAR(at(claim).value, value, tolerance) << at(claim).text;
        EXPECT_EQ(at(claim).vertices.empty(), holds) << at(claim).text;
    };

    const Matrix skew = s - s.transpose();
    expect(&PropertyClaims::symmetric, skew.cwiseAbs().maxCoeff() <= weight_tolerance * scale, skew.norm() / s.norm(),
           1e-13);
    const Vector sums = s.rowwise().sum().cwiseAbs();
    expect(&PropertyClaims::constants_in_kernel, sums.maxCoeff() <= weight_tolerance * scale, sums.maxCoeff() / scale,
           1e-13);
    Matrix weights = -s;
    weights.diagonal().setZero();
    const double lowest = weights.minCoeff();
    const bool positive = lowest >= -weight_tolerance * scale;
    expect(&PropertyClaims::positive_weights, positive, positive ? 0 : -lowest, 1e-13 * scale);

    const Eigen::SelfAdjointEigenSolver<Matrix> solver(0.5 * (s + s.transpose()), Eigen::EigenvaluesOnly);
    const Vector& mu = solver.eigenvalues();
    const double top = mu[mu.size() - 1];
    EXPECT_NEAR(report.smallest_eigenvalue, mu[0], 1e-9 * top);
    EXPECT_NEAR(report.largest_eigenvalue, top, 1e-6 * top);
    const bool semidefinite = mu[0] >= -kernel_tolerance * top;
    EXPECT_EQ(at(&PropertyClaims::positive_semidefinite).verdict, semidefinite ? Verdict::holds : Verdict::fails);
    const Vector sigma = s.jacobiSvd().singularValues();
    const auto kernel = (sigma.array() <= kernel_tolerance * sigma[0]).count();
    if (report.kernel_complete) {
        EXPECT_EQ(report.kernel_dimension, kernel);
        if (kernel < sigma.size()) {
            const double condition = sigma[0] / sigma[sigma.size() - kernel - 1];
            EXPECT_NEAR(report.condition, condition, 1e-5 * condition);
        }
    } else {
        EXPECT_GE(kernel, kernel_limit);
    }
    EXPECT_EQ(report.kernel_modes.cols(), report.kernel_dimension);
    EXPECT_LE((matrices.stiffness * report.kernel_modes).norm(), 1e-7 * top * std::sqrt(kernel_limit));
    EXPECT_EQ(report.smallest_mass, Vector(matrices.mass.diagonal())(referenced).minCoeff());

    const Measurement& maximum = at(&PropertyClaims::maximum_principle);
    if (topology.boundary_vertices.empty()) {
        // Any vertices may be the boundary, also all but one: means of the others obey, and nothing else does.
        const Matrix means = s.diagonal().cwiseInverse().asDiagonal() * weights;
        const bool determined = s.diagonal().cwiseAbs().minCoeff() > weight_tolerance * scale;
        const double below = determined ? -means.minCoeff() : 0;
        if (below > range_tolerance) {
            EXPECT_EQ(maximum.verdict, Verdict::fails) << maximum.text;
            EXPECT_GE(maximum.value, below * (1 - 1e-12)) << maximum.text;
            EXPECT_EQ(maximum.vertices.empty(), false) << maximum.text;
        } else if (determined && sums.maxCoeff() <= weight_tolerance * scale) {
            EXPECT_NE(maximum.verdict, Verdict::fails) << maximum.text;
        }
        return;
    }
    // Open surfaces: the exact extension of all boundary values.
    if (maximum.verdict == Verdict::not_measured) return;
    std::vector<Index> inner;
    for (const Index v : referenced) {
        if (!std::binary_search(topology.boundary_vertices.begin(), topology.boundary_vertices.end(), v)) {
            inner.push_back(v);
        }
    }
    const Matrix all(matrices.stiffness);
    const Eigen::FullPivLU<Matrix> lu(all(inner, inner));
    if (!lu.isInvertible() || lu.rcond() < 1e-9) return;
    const Matrix extension = -lu.solve(all(inner, topology.boundary_vertices));
    const Vector constant = extension.rowwise().sum();
    const double beyond =
        std::max({-extension.minCoeff(), extension.maxCoeff() - 1, constant.maxCoeff() - 1, 1 - constant.minCoeff()});
    expect(&PropertyClaims::maximum_principle, beyond <= range_tolerance, std::max(0.0, beyond), 1e-7);
}

/// The operator as it is, and with weights of vertices as large as edges where it takes them.
std::vector<OperatorSpec> with_and_without_weights(const OperatorSpec& spec, const PolygonMesh& mesh) {
    std::vector<OperatorSpec> specs{spec};
    if ((*find_operator(spec.id))->takes_vertex_weights) {
        const double h2 = measure_shape(mesh, build_topology(*mesh.connectivity())).mean_squared_edge;
        specs.push_back(spec);
        for (Index v = 0; v < mesh.vertex_count(); ++v) {
            specs.back().vertex_weights.push_back(2 * h2 * std::sin(1.7 * v));
        }
    }
    return specs;
}

struct Score {
    int held = 0;
    std::string counter_example;
};

TEST(Properties, AgreeWithDenseComputationsAndTheClaims) {
    std::map<const PropertyInfo*, std::map<std::string, Score>> scores;
    int compared = 0;
    for (const OperatorSpec& plain : all_specs()) {
        const OperatorInfo& info = **find_operator(plain.id);
        const auto visit = [&](const OperatorSpec& spec, const Specimen& s) {
            const auto matrices = build_operator(s.mesh, spec);
            if (!matrices) return;
            SCOPED_TRACE(spec_name(spec) + " on " + s.name);
            const PropertyReport report =
                get(check_properties(s.mesh, build_topology(*s.mesh.connectivity()), *matrices));
            if (s.mesh.vertex_count() <= 100) {
                compare_with_dense(s.mesh, *matrices, report);
                ++compared;
            }
            ASSERT_EQ(report.measurements.size() + 1, properties().size());
            for (const Measurement& m : report.measurements) {
                EXPECT_FALSE(m.text.empty());
                if (m.verdict == Verdict::not_measured) continue;
                Score& score = scores[m.property][spec.id];
                if (claimed((info.claims.*m.property->claim).where, s.mesh)) {
                    EXPECT_EQ(m.verdict, Verdict::holds) << m.property->id << ": " << m.text;
                    ++score.held;
                } else if (m.verdict == Verdict::fails) {
                    score.counter_example = s.name;
                }
            }
        };
        for (const Specimen& s : zoo()) {
            if (s.mesh.vertex_count() > 400) continue;
            for (const OperatorSpec& spec : with_and_without_weights(plain, s.mesh)) {
                visit(spec, s);
            }
        }
    }
    EXPECT_GE(compared, 100);
    for (const PropertyInfo& property : properties()) {
        if (property.claim == &PropertyClaims::convergent) continue;
        for (const OperatorInfo* info : operators()) {
            const Score& score = scores[&property][info->id];
            if ((info->claims.*property.claim).where == Claim::yes) {
                EXPECT_GE(score.held, 5) << info->id << ", " << property.id;
            } else {
                EXPECT_FALSE(score.counter_example.empty())
                    << info->id << " never violates " << property.id << ": the claim is too weak";
            }
        }
    }
}

TEST(Properties, FlatVerticesAreThoseOfThePlainDefinition) {
    for (const auto& [name, mesh] : zoo()) {
        EXPECT_EQ(polylap::flat_inner_vertices(mesh, build_topology(*mesh.connectivity())), flat_inner_vertices(mesh))
            << name;
    }
}

}  // namespace
}  // namespace polylap::test

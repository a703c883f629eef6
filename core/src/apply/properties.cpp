#include "polylap/apply/properties.hpp"

#include <algorithm>
#include <string>

#include "apply/measure.hpp"

namespace polylap {
namespace {

void measure_mass(const Subject& subject, PropertyReport& report) {
    const Vector mass = subject.matrices.mass.diagonal();
    for (Index v = 0; v < static_cast<Index>(mass.size()); ++v) {
        if (subject.topology.component[static_cast<std::size_t>(v)] < 0) continue;
        if (report.smallest_mass_vertex >= 0 && mass[v] >= report.smallest_mass) continue;
        report.smallest_mass = mass[v];
        report.smallest_mass_vertex = v;
    }
}

Status check_sizes(const PolygonMesh& mesh, const OperatorMatrices& matrices) {
    const auto fits = [&](const SparseMatrix& a) {
        return a.rows() == mesh.vertex_count() && a.cols() == mesh.vertex_count();
    };
    if (fits(matrices.stiffness) && fits(matrices.mass)) return Done{};
    return Error{ErrorCode::bad_argument, "stiffness and mass must have a row and a column for each of the " +
                                              std::to_string(mesh.vertex_count()) + " vertices"};
}

}  // namespace

Result<PropertyReport> check_properties(const PolygonMesh& mesh, const Topology& topology,
                                        const OperatorMatrices& matrices, Monitor monitor) {
    return guard_memory([&]() -> Result<PropertyReport> {
        if (Status status = check_sizes(mesh, matrices); !status) return status.error();
        if (!monitor.proceed(0)) return Error{ErrorCode::cancelled, "cancelled"};
        const double scale =
            matrices.stiffness.rows() == 0 ? 0 : Vector(matrices.stiffness.diagonal()).cwiseAbs().maxCoeff();
        const Subject subject{mesh, topology, matrices, scale};
        PropertyReport report;
        report.components = topology.component_count;
        measure_mass(subject, report);
        const WeightSummary weights = summarise_weights(subject.stiffness());
        report.negative_ordered = weights.negative_ordered;
        report.negative_pairs = static_cast<Index>(weights.negative.size());

        const Measurement symmetry = measure_symmetry(subject);
        Stretch first{monitor, 0.05, 0.6};
        auto semidefinite =
            measure_spectrum(subject, symmetry.verdict == Measurement::Verdict::holds, report, first.monitor());
        if (!semidefinite) return semidefinite.error();
        Stretch second{monitor, 0.6, 1};
        auto maximum = measure_maximum_principle(subject, second.monitor());
        if (!maximum) return maximum.error();

        const std::pair<PropertyClaim PropertyClaims::*, Measurement> found[] = {
            {&PropertyClaims::symmetric, symmetry},
            {&PropertyClaims::local, measure_locality(subject)},
            {&PropertyClaims::positive_weights, measure_positive_weights(subject, weights)},
            {&PropertyClaims::positive_semidefinite, *std::move(semidefinite)},
            {&PropertyClaims::constants_in_kernel, measure_constants(subject)},
            {&PropertyClaims::linear_precision, measure_linear_precision(subject)},
            {&PropertyClaims::maximum_principle, *std::move(maximum)},
        };
        for (const PropertyInfo& property : properties()) {
            const auto* it = std::find_if(std::begin(found), std::end(found),
                                          [&](const auto& entry) { return entry.first == property.claim; });
            if (it == std::end(found)) continue;
            report.measurements.push_back(it->second);
            report.measurements.back().property = &property;
        }
        if (!monitor.proceed(1)) return Error{ErrorCode::cancelled, "cancelled"};
        return report;
    });
}

}  // namespace polylap

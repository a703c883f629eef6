#pragma once

#include <string>

#include "polylap/apply/properties.hpp"

namespace polylap {

/// What is measured, and what all measurements share.
struct Subject {
    const PolygonMesh& mesh;
    const Topology& topology;
    const OperatorMatrices& matrices;
    double scale;  ///< Largest |S_ii|; what is measured against entries of S is measured relative to it.

    const SparseMatrix& stiffness() const { return matrices.stiffness; }
    double zero() const { return weight_tolerance * scale; }
    /// Relative to the diagonal; a matrix without one is measured absolutely.
    double relative(double entry) const { return scale > 0 ? entry / scale : entry; }
};

Measurement measure_symmetry(const Subject& subject);
Measurement measure_locality(const Subject& subject);
Measurement measure_positive_weights(const Subject& subject, const WeightSummary& weights);
Measurement measure_constants(const Subject& subject);
Measurement measure_linear_precision(const Subject& subject);

/// @error cancelled, out_of_memory
Result<Measurement> measure_maximum_principle(const Subject& subject, Monitor monitor);

/// Fills in eigenvalues, kernel and condition. @return of positive semi-definiteness
/// @error cancelled, out_of_memory
Result<Measurement> measure_spectrum(const Subject& subject, bool symmetric, PropertyReport& report, Monitor monitor);

/// Three digits, for people.
std::string figure(double value);
std::string vertex_name(Index v);

inline Measurement measured(bool holds, double value, std::string text, std::vector<Index> vertices) {
    Measurement m;
    m.verdict = holds ? Measurement::Verdict::holds : Measurement::Verdict::fails;
    m.value = value;
    m.text = std::move(text);
    if (!holds) m.vertices = std::move(vertices);
    return m;
}
inline Measurement not_measured(std::string reason) {
    Measurement m;
    m.text = std::move(reason);
    return m;
}
/// An error of a solver is the reason why something is not measured, but for those that end the whole check.
inline bool ends_check(const Error& error) {
    return error.code == ErrorCode::cancelled || error.code == ErrorCode::out_of_memory;
}

}  // namespace polylap

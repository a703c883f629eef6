#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "zoo.hpp"

namespace polylap::test {

/// Two faces at most share an edge, and they run along it in opposite directions.
inline bool is_oriented(const PolygonMesh& mesh) {
    const auto edges = build_topology(*mesh.connectivity()).edges;
    return std::all_of(edges.begin(), edges.end(), [](const Edge& e) { return e.oriented(); });
}

/// The matrices, or nothing where the operator refuses a face, or a mesh without orientation.
inline std::optional<OperatorMatrices> try_build(const PolygonMesh& mesh, const OperatorSpec& spec) {
    auto result = build_operator(mesh, spec);
    if (result) return *std::move(result);
    const Error& error = result.error();
    if (error.code == ErrorCode::non_manifold_edge) {
        EXPECT_FALSE(is_oriented(mesh)) << error.message;
        return std::nullopt;
    }
    if (error.code != ErrorCode::degenerate_face) throw std::runtime_error(error.message);
    EXPECT_GE(error.element, 0);
    EXPECT_LT(error.element, mesh.face_count());
    EXPECT_NE(error.message.find("face " + std::to_string(error.element)), std::string::npos) << error.message;
    return std::nullopt;
}

inline double largest(const SparseMatrix& a) {
    return a.nonZeros() == 0 ? 0 : a.coeffs().abs().maxCoeff();
}
inline double difference(const SparseMatrix& a, const SparseMatrix& b) {
    return largest(SparseMatrix(a - b));
}

/// Calls `visit(specimen, spec, matrices, scale)` for everything that can be built; scale is the largest entry of S.
template <class Visit>
void for_all(Visit&& visit, Index most_vertices = 1 << 20) {
    for (const Specimen& s : zoo()) {
        if (s.mesh.vertex_count() > most_vertices) continue;
        for (const OperatorSpec& spec : all_specs(s.mesh)) {
            const auto matrices = try_build(s.mesh, spec);
            if (!matrices) continue;
            SCOPED_TRACE(spec_name(spec) + " on " + s.name);
            visit(s, spec, *matrices, largest(matrices->stiffness));
        }
    }
}

/// What S may change by, relative to its largest entry, when coordinates move by the rounding of numbers of size
/// `reach`. Angles change by position errors over the shortest edge, and cotangents by their square times that: `scale`
/// stands for the largest cotangent.
inline double rounding_of(const PolygonMesh& mesh, double reach, double scale) {
    double shortest = bounding_size(mesh);
    for (const Edge& e : build_topology(*mesh.connectivity()).edges) {
        shortest = std::min(shortest, (mesh.position(e.v1) - mesh.position(e.v0)).norm());
    }
    return 1e3 * 1.1e-16 * reach / shortest * std::max(1.0, scale);
}

}  // namespace polylap::test

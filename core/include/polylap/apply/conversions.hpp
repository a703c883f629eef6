#pragma once

#include <span>
#include <string_view>

#include "polylap/base/monitor.hpp"
#include "polylap/base/parameter.hpp"
#include "polylap/face/triangulate.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// Cuts every face into triangles by diagonals, on its projection along the vector area.
/// @error degenerate_face (element = face), out_of_memory
Result<PolygonMesh> triangulate_faces(const PolygonMesh& mesh, TriangulationRule rule = TriangulationRule::delaunay);

/// One line of the conversion table: a mesh made of a mesh.
struct ConversionInfo {
    const char* id;  ///< Kebab case: dual, quads, pair-triangles, triangles, noise.
    const char* label;
    const char* summary;  ///< One sentence.
    std::span<const Parameter> parameters;
    /// @param values one per parameter, in range
    Result<PolygonMesh> (*convert)(const PolygonMesh& mesh, std::span<const double> values);
};

std::span<const ConversionInfo* const> conversions() noexcept;

/// @error bad_argument (no such conversion; the message lists the known ones)
Result<const ConversionInfo*> find_conversion(std::string_view id);

/// @error bad_argument, parameter_out_of_range, and what the conversion says
Result<PolygonMesh> convert(const PolygonMesh& mesh, std::string_view id, Settings settings = {});

}  // namespace polylap

#pragma once

#include <span>

#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// How many meshes a family has, each about half as coarse as the one before.
inline constexpr int refinements = 4;

/// Meshes of one kind under refinement: of the unit square (or nearly so), or of the unit sphere.
struct Family {
    const char* name;
    bool sphere;
    Result<PolygonMesh> (*make)(int level);
};

std::span<const Family> refined_families() noexcept;

}  // namespace polylap

#include "polylap/apply/rescaling.hpp"

#include <cmath>

#include "polylap/apply/diagnostics.hpp"
#include "polylap/face/vector_area.hpp"

namespace polylap {
namespace {

struct Extent {
    double area = 0;
    Vector3 centroid = Vector3::Zero();
};

Extent extent_of(const PolygonMesh& mesh) {
    // Relative to a vertex, so that meshes far from 0 keep their digits.
    const Vector3 origin = mesh.position(mesh.face(0)[0]);
    Extent extent;
    std::vector<Vector3> corners;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        gather_corners(mesh, f, corners);
        const double area = vector_area(corners).stableNorm();
        Vector3 centre = Vector3::Zero();
        for (const Vector3& x : corners)
            centre += x - origin;
        extent.area += area;
        extent.centroid += area / static_cast<double>(corners.size()) * centre;
    }
    if (extent.area > 0) extent.centroid /= extent.area;
    extent.centroid += origin;
    return extent;
}

/// Vertices in no face stay.
Result<PolygonMesh> scaled(const PolygonMesh& mesh, const Vector3& centre, double scale) {
    Points points = mesh.positions();
    for (const Index v : mesh.connectivity()->corners) {
        points.row(v) = (centre + scale * (mesh.position(v) - centre)).transpose();
    }
    return mesh.with_positions(std::move(points));
}

}  // namespace

Result<PolygonMesh> scaled_to_volume(const PolygonMesh& mesh, const Topology& topology, double volume) {
    const auto enclosed = enclosed_volume(mesh, topology);
    if (!enclosed) return enclosed.error();
    return guard_memory([&]() -> Result<PolygonMesh> {
        const Extent extent = extent_of(mesh);
        const double none = flat_volume_tolerance * std::pow(extent.area, 1.5);
        if (std::abs(*enclosed) > none && *enclosed / volume > 0 && std::isfinite(*enclosed / volume))
            return scaled(mesh, extent.centroid, std::cbrt(volume / *enclosed));
        return Error{ErrorCode::not_converged,
                     std::string("the volume cannot be kept: the surface ") +
                         (*enclosed / volume < 0 ? "would turn inside out" : "encloses none any more")};
    });
}

Result<PolygonMesh> scaled_to_area(const PolygonMesh& mesh, double area) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        const Extent extent = extent_of(mesh);
        if (extent.area > 0) return scaled(mesh, extent.centroid, std::sqrt(area / extent.area));
        return Error{ErrorCode::degenerate_face, "the surface has no area left"};
    });
}

double surface_area(const PolygonMesh& mesh) {
    return extent_of(mesh).area;
}

}  // namespace polylap

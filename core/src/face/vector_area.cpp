#include "polylap/face/vector_area.hpp"

#include "face/projection.hpp"

namespace polylap {

Vector3 vector_area(Corners corners) {
    return vector_area_of(corners);
}

bool has_zero_area(Corners corners, const Vector3& area) {
    return is_zero_area(corners, safe_norm(area));
}

bool project_maximally(Corners corners, Projection& out) {
    const Vector3 a = vector_area(corners);
    out.area = safe_norm(a);
    if (is_zero_area(corners, out.area)) return false;
    out.normal = a / out.area;
    out.points.resize(corners.size());
    project_along(corners, out.normal, out.points);
    return true;
}

void gather_corners(const PolygonMesh& mesh, Index f, std::vector<Vector3>& out) {
    out.clear();
    for (const Index v : mesh.face(f)) {
        out.push_back(mesh.position(v));
    }
}

}  // namespace polylap

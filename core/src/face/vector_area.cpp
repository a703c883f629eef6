#include "polylap/face/vector_area.hpp"

#include <Eigen/Geometry>

namespace polylap {

Vector3 vector_area(Corners corners) {
    // A fan from the first corner: differences cancel the position of the face in space.
    Vector3 twice = Vector3::Zero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        twice += (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
    }
    return 0.5 * twice;
}

bool has_zero_area(Corners corners, const Vector3& area) {
    double perimeter = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        perimeter += (corners[k + 1 < corners.size() ? k + 1 : 0] - corners[k]).norm();
    }
    return area.stableNorm() <= zero_area_ratio * perimeter * perimeter;
}

bool project_maximally(Corners corners, Projection& out) {
    const Vector3 a = vector_area(corners);
    if (has_zero_area(corners, a)) return false;
    out.area = a.stableNorm();
    out.normal = a / out.area;
    const Vector3 axis1 = out.normal.unitOrthogonal();
    const Vector3 axis2 = out.normal.cross(axis1);
    out.points.clear();
    for (const Vector3& x : corners) {
        const Vector3 d = x - corners[0];
        out.points.emplace_back(axis1.dot(d), axis2.dot(d));
    }
    return true;
}

void gather_corners(const PolygonMesh& mesh, Index f, std::vector<Vector3>& out) {
    out.clear();
    for (const Index v : mesh.face(f)) {
        out.push_back(mesh.position(v));
    }
}

}  // namespace polylap

#include "polylap/face/triangulate.hpp"

#include "face/triangulation_rules.hpp"

namespace polylap {

Status cut_fan(const PlanePolygon& polygon, std::vector<Triangle>& out) {
    const Index n = polygon.size();
    for (Index apex = 0; apex < n; ++apex) {
        out.clear();
        for (Index k = 1; k + 1 < n; ++k) {
            const Triangle t{apex, (apex + k) % n, (apex + k + 1) % n};
            if (polygon.side(t[0], t[1], t[2]) <= 0) break;
            out.push_back(t);
        }
        if (static_cast<Index>(out.size()) == n - 2) return Done{};
    }
    return Error{ErrorCode::degenerate_face,
                 "no corner has a fan of triangles that all lie inside and have area; another rule can cut this face"};
}

Status triangulate_polygon(std::span<const Eigen::Vector2d> points, TriangulationRule rule,
                           std::vector<Triangle>& out) {
    return guard_memory([&]() -> Status {
        if (points.size() < 3) return Error{ErrorCode::degenerate_face, "it has fewer than three corners"};
        const PlanePolygon polygon(points);
        if (!polygon.simple()) return Error{ErrorCode::degenerate_face, "its projection crosses or touches itself"};
        if (points.size() == 3) {
            if (polygon.side(0, 1, 2) <= 0) return Error{ErrorCode::degenerate_face, "its projection has no area"};
            out.assign({{0, 1, 2}});
            return Done{};
        }
        switch (rule) {
            case TriangulationRule::delaunay:
                return cut_delaunay(polygon, out);
            case TriangulationRule::min_max_angle:
                return cut_min_max_angle(polygon, out);
            case TriangulationRule::shortest_diagonal:
                return cut_shortest_diagonal(polygon, out);
            case TriangulationRule::fan:
                return cut_fan(polygon, out);
        }
        return Error{ErrorCode::bad_argument, "unknown triangulation rule"};
    });
}

}  // namespace polylap

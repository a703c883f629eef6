#include "polylap/apply/display.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "polylap/face/triangulate.hpp"
#include "polylap/face/vector_area.hpp"

namespace polylap {
namespace {

void cut_fan_blindly(Index corners, std::vector<Triangle>& out) {
    out.clear();
    for (Index k = 1; k + 1 < corners; ++k) {
        out.push_back({0, k, k + 1});
    }
}

/// The faces at each vertex: those of v are faces[offsets[v] … offsets[v+1]), ascending.
struct VertexFaces {
    std::vector<Index> offsets, faces;

    explicit VertexFaces(const Connectivity& connectivity)
        : offsets(static_cast<std::size_t>(connectivity.vertex_count) + 1, 0), faces(connectivity.corners.size()) {
        for (const Index v : connectivity.corners) {
            ++offsets[static_cast<std::size_t>(v) + 1];
        }
        for (std::size_t v = 1; v < offsets.size(); ++v) {
            offsets[v] += offsets[v - 1];
        }
        std::vector<Index> fill(offsets.begin(), offsets.end() - 1);
        for (Index f = 0; f < connectivity.face_count(); ++f) {
            for (const Index v : connectivity.face(f)) {
                faces[static_cast<std::size_t>(fill[static_cast<std::size_t>(v)]++)] = f;
            }
        }
    }

    std::span<const Index> at(Index v) const {
        const auto first = static_cast<std::size_t>(offsets[static_cast<std::size_t>(v)]);
        const auto last = static_cast<std::size_t>(offsets[static_cast<std::size_t>(v) + 1]);
        return std::span(faces).subspan(first, last - first);
    }
};

class Draper {
public:
    Draper(const PolygonMesh& mesh, const DisplayTriangles& display)
        : mesh_(mesh),
          display_(display),
          at_vertex_(*mesh.connectivity()),
          first_triangle_(static_cast<std::size_t>(mesh.face_count()) + 1, 0),
          corner_of_(static_cast<std::size_t>(mesh.vertex_count()), 0) {
        for (Index f = 0; f < mesh.face_count(); ++f) {
            const auto count = static_cast<Index>(mesh.face(f).size()) - 2;
            first_triangle_[static_cast<std::size_t>(f) + 1] = first_triangle_[static_cast<std::size_t>(f)] + count;
        }
    }

    void add(Index pair, Index i, Index j, SurfaceLines& lines) {
        path_.clear();
        if (const Index f = common_face(i, j); f >= 0) cross_diagonals(f, i, j);
        std::sort(path_.begin(), path_.end(), [](const Crossing& a, const Crossing& b) { return a.along < b.along; });
        path_.push_back({1, mesh_.position(j)});
        Vector3 from = mesh_.position(i);
        double start = 0;
        for (const Crossing& c : path_) {
            lines.segments.push_back({from, c.point});
            lines.start.push_back(start);
            lines.pair.push_back(pair);
            start += (c.point - from).norm();
            from = c.point;
        }
    }

private:
    struct Crossing {
        double along;
        Vector3 point;
    };

    /// The lowest face with both vertices; -1 if there is none, or if they are neighbours in one: an edge lies on the
    /// surface as it is.
    Index common_face(Index i, Index j) const {
        const auto at_i = at_vertex_.at(i);
        const auto at_j = at_vertex_.at(j);
        Index found = -1;
        for (auto p = at_i.begin(), q = at_j.begin(); p != at_i.end() && q != at_j.end();) {
            if (*p != *q) {
                ++(*p < *q ? p : q);
                continue;
            }
            const auto face = mesh_.face(*p);
            const auto n = static_cast<std::ptrdiff_t>(face.size());
            const auto gap = (std::find(face.begin(), face.end(), j) - std::find(face.begin(), face.end(), i) + n) % n;
            if (gap == 1 || gap == n - 1) return -1;
            if (found < 0) found = *p;
            ++p;
            ++q;
        }
        return found;
    }

    /// Projects face f and gathers its diagonals, unless it is the face of the last call.
    void enter(Index f) {
        if (f == entered_) return;
        entered_ = f;
        diagonals_.clear();
        gather_corners(mesh_, f, corners_);
        projected_ = project_maximally(corners_, projection_);
        const auto face = mesh_.face(f);
        for (std::size_t k = 0; k < face.size(); ++k) {
            corner_of_[static_cast<std::size_t>(face[k])] = k;
        }
        const Index last = first_triangle_[static_cast<std::size_t>(f) + 1];
        for (Index t = first_triangle_[static_cast<std::size_t>(f)]; t < last; ++t) {
            const auto& triangle = display_.triangles[static_cast<std::size_t>(t)];
            for (std::size_t k = 0; k < 3; ++k) {
                const Index a = triangle[k];
                const Index b = triangle[(k + 1) % 3];
                const bool edge = (display_.edges[static_cast<std::size_t>(t)] >> k & 1U) != 0;
                if (!edge && a < b) diagonals_.emplace_back(a, b);  // each is seen from both sides
            }
        }
    }

    /// Where the straight line i–j, seen along the vector area of face f, passes a diagonal of its display triangles.
    void cross_diagonals(Index f, Index i, Index j) {
        enter(f);
        if (!projected_) return;
        const auto place = [this](Index v) { return projection_.points[corner_of_[static_cast<std::size_t>(v)]]; };
        const auto cross = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
            return u.x() * v.y() - u.y() * v.x();
        };
        const Eigen::Vector2d p = place(i);
        const Eigen::Vector2d d = place(j) - p;
        for (const auto& [a, b] : diagonals_) {
            if (a == i || a == j || b == i || b == j) continue;
            const Eigen::Vector2d q = place(a);
            const Eigen::Vector2d e = place(b) - q;
            const double area = cross(d, e);
            const double along = cross(q - p, e) / area;
            const double across = cross(q - p, d) / area;
            if (!(along > 0 && along < 1 && across > 0 && across < 1)) continue;
            path_.push_back({along, (1 - across) * mesh_.position(a) + across * mesh_.position(b)});
        }
    }

    const PolygonMesh& mesh_;
    const DisplayTriangles& display_;
    VertexFaces at_vertex_;
    std::vector<Index> first_triangle_;
    std::vector<Crossing> path_;

    Index entered_ = -1;
    bool projected_ = false;
    std::vector<Vector3> corners_;
    Projection projection_;
    std::vector<std::size_t> corner_of_;  ///< Per vertex of the entered face: which corner it is there.
    std::vector<std::pair<Index, Index>> diagonals_;
};

/// Steps through 0 … n-1, each once, so that any number of first steps is spread evenly: by the golden ratio of n.
class EvenOrder {
public:
    explicit EvenOrder(std::size_t n) : n_(n), stride_(static_cast<std::size_t>(static_cast<double>(n) / 1.618034)) {
        while (std::gcd(n_, stride_) != 1) {
            ++stride_;
        }
    }
    std::size_t next() { return at_ = (at_ + stride_) % n_; }

private:
    std::size_t n_, stride_;
    std::size_t at_ = 0;
};

}  // namespace

Result<DisplayTriangles> triangulate_for_display(const PolygonMesh& mesh, Monitor monitor) {
    return guard_memory([&]() -> Result<DisplayTriangles> {
        constexpr std::size_t corners_per_tick = 4096;
        const auto all = static_cast<double>(mesh.connectivity()->corners.size());
        std::size_t done = 0;
        std::size_t next_tick = 0;
        DisplayTriangles display;
        std::vector<Vector3> corners;
        Projection projection;
        std::vector<Triangle> local;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            const auto face = mesh.face(f);
            const auto n = static_cast<Index>(face.size());
            if (done >= next_tick) {
                if (!monitor.proceed(static_cast<double>(done) / all)) return Error{ErrorCode::cancelled, "cancelled"};
                next_tick = done + corners_per_tick;
            }
            done += face.size();
            gather_corners(mesh, f, corners);
            const bool cut = project_maximally(corners, projection) &&
                             triangulate_polygon(projection.points, TriangulationRule::delaunay, local).ok();
            if (!cut) cut_fan_blindly(n, local);
            for (const Triangle& t : local) {
                std::array<Index, 3> vertices{};
                unsigned edges = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    vertices[k] = face[static_cast<std::size_t>(t[k])];
                    if (t[(k + 1) % 3] == (t[k] + 1 == n ? 0 : t[k] + 1)) edges |= 1U << k;
                }
                display.triangles.push_back(vertices);
                display.edges.push_back(static_cast<std::uint8_t>(edges));
                display.face.push_back(f);
            }
        }
        return display;
    });
}

SurfaceLines drape_pairs(const PolygonMesh& mesh, const DisplayTriangles& display, std::span<const Weight> pairs,
                         std::size_t most_segments) {
    SurfaceLines lines;
    if (pairs.empty()) return lines;
    Draper draper(mesh, display);
    EvenOrder order(pairs.size());
    for (std::size_t drawn = 0; drawn < pairs.size() && lines.segments.size() < most_segments; ++drawn) {
        const std::size_t k = order.next();
        draper.add(static_cast<Index>(k), pairs[k].i, pairs[k].j, lines);
    }
    return lines;
}

}  // namespace polylap

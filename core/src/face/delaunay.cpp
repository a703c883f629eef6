#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>
#include <span>

#include "face/quad_cut.hpp"
#include "face/triangulation_rules.hpp"

namespace polylap {
namespace {

Error too_thin() {
    return {ErrorCode::degenerate_face, "its projection is too thin to triangulate"};
}

/// The Delaunay cut of a quad, without the machinery. In a tie, from corner 0.
Status cut_quad(const PlanePolygon& p, std::vector<Triangle>& out) {
    const bool cut02 = p.side(0, 1, 2) > 0 && p.side(0, 2, 3) > 0;
    const bool cut13 = p.side(0, 1, 3) > 0 && p.side(1, 2, 3) > 0;
    if (!cut02 && !cut13) return too_thin();
    const QuadTriangles& cut = cut02 && !(cut13 && should_flip(p, 0, 2, 3, 1)) ? cut_at_02 : cut_at_13;
    out.assign(cut.begin(), cut.end());
    return Done{};
}

/// A triangulation whose triangles know their neighbours: neighbour[t][k] lies across the side k → k+1 of t; -1
/// outside.
struct LinkedTriangles {
    std::vector<Triangle> triangles;
    std::vector<Triangle> neighbour;
};

/// Cuts ears, the best shaped first: of the polygon's corners that are left, those with nothing in their triangle.
class EarClipper {
public:
    explicit EarClipper(const PlanePolygon& polygon)
        : polygon_(polygon),
          size_(static_cast<std::size_t>(polygon.size())),
          convex_(polygon.strictly_convex()),
          next_(size_),
          previous_(size_),
          across_(size_, -1),
          quality_(size_) {
        for (Index i = 0; i < polygon.size(); ++i) {
            at(next_, i) = polygon.next(i);
            at(previous_, i) = polygon.previous(i);
        }
    }

    std::optional<LinkedTriangles> run() {
        LinkedTriangles mesh;
        rate_all();
        for (Index left = polygon_.size(); left > 3; --left) {
            Index best = take_best();
            if (best < 0) {
                rate_all();  // a corner that blocked others may be gone
                best = take_best();
                if (best < 0) return std::nullopt;
            }
            cut(best, mesh);
        }
        // Three corners are left; the last triangle closes all three sides.
        const Index v = take_best();
        if (v < 0) return std::nullopt;
        const Index behind = at(across_, at(next_, v));
        cut(v, mesh);
        link(mesh, static_cast<Index>(mesh.triangles.size()) - 1, 2, behind);
        return mesh;
    }

private:
    template <class T>
    static T& at(std::vector<T>& v, Index i) {
        return v[static_cast<std::size_t>(i)];
    }

    void rate_all() {
        for (Index i = 0; i < polygon_.size(); ++i) {
            if (at(quality_, i) >= 0) rate(i);
        }
    }

    /// The best of the ears as they are rated now, of equals the lowest; -1 if there is none.
    Index take_best() {
        while (!ears_.empty()) {
            const Ear ear = ears_.top();
            ears_.pop();
            if (ear.quality == at(quality_, ear.corner)) return ear.corner;
        }
        return -1;
    }

    /// Quality of the ear at v: 0 if it is none, otherwise twice its area over its squared edge lengths; -1 marks a
    /// corner that is gone.
    void rate(Index v) {
        const Index p = at(previous_, v);
        const Index q = at(next_, v);
        at(quality_, v) = 0;
        if (polygon_.side(p, v, q) <= 0) return;
        for (Index w = at(next_, q); !convex_ && w != p; w = at(next_, w)) {
            if (polygon_.side(p, v, w) >= 0 && polygon_.side(v, q, w) >= 0 && polygon_.side(q, p, w) >= 0) return;
        }
        const Angle angle(polygon_, q, v, p);
        at(quality_, v) =
            angle.sine / ((polygon_[p] - polygon_[v]).squaredNorm() + (polygon_[q] - polygon_[v]).squaredNorm() +
                          (polygon_[q] - polygon_[p]).squaredNorm());
        if (at(quality_, v) > 0) ears_.push({at(quality_, v), v});
    }

    void cut(Index v, LinkedTriangles& mesh) {
        const Index p = at(previous_, v);
        const Index q = at(next_, v);
        const auto t = static_cast<Index>(mesh.triangles.size());
        mesh.triangles.push_back({p, v, q});
        mesh.neighbour.push_back({-1, -1, -1});
        link(mesh, t, 0, at(across_, p));
        link(mesh, t, 1, at(across_, v));
        at(across_, p) = t;
        at(next_, p) = q;
        at(previous_, q) = p;
        at(quality_, v) = -1;
        rate(p);
        rate(q);
    }

    /// The triangles cut before always wait at their third side.
    static void link(LinkedTriangles& mesh, Index t, std::size_t side, Index other) {
        if (other < 0) return;
        at(mesh.neighbour, t)[side] = other;
        at(mesh.neighbour, other)[2] = t;
    }

    struct Ear {
        double quality;
        Index corner;
        friend bool operator<(const Ear& a, const Ear& b) {
            return a.quality < b.quality || (a.quality == b.quality && a.corner > b.corner);
        }
    };

    const PlanePolygon& polygon_;
    std::size_t size_;
    bool convex_;  ///< Then nothing is ever in an ear's triangle.
    std::vector<Index> next_, previous_;
    std::vector<Index> across_;  ///< Triangle already cut off along the edge i → next(i), or -1.
    std::vector<double> quality_;
    std::priority_queue<Ear> ears_;  ///< Also with ratings that have changed since.
};

/// Lawson's flips: each lowers the Dirichlet energy, so they end; the bound only guards against rounding.
void make_delaunay(const PlanePolygon& polygon, LinkedTriangles& mesh) {
    const auto count = static_cast<Index>(mesh.triangles.size());
    std::int64_t budget = static_cast<std::int64_t>(count) * count + 16;
    std::vector<Index> stack(mesh.triangles.size());
    std::iota(stack.begin(), stack.end(), 0);
    const auto tri = [&mesh](Index t) -> Triangle& { return mesh.triangles[static_cast<std::size_t>(t)]; };
    const auto nbr = [&mesh](Index t) -> Triangle& { return mesh.neighbour[static_cast<std::size_t>(t)]; };
    const auto replace = [&nbr](Index t, Index from, Index to) {
        if (t >= 0) std::replace(nbr(t).begin(), nbr(t).end(), from, to);
    };
    while (!stack.empty()) {
        const Index t = stack.back();
        stack.pop_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const Index s = nbr(t)[k];
            if (s < 0) continue;
            const auto l = static_cast<std::size_t>(std::find(nbr(s).begin(), nbr(s).end(), t) - nbr(s).begin());
            const Index a = tri(t)[k];
            const Index b = tri(t)[(k + 1) % 3];
            const Index c = tri(t)[(k + 2) % 3];
            const Index d = tri(s)[(l + 2) % 3];
            if (!should_flip(polygon, a, b, c, d)) continue;
            if (--budget < 0) return;
            const Index bc = nbr(t)[(k + 1) % 3];
            const Index ca = nbr(t)[(k + 2) % 3];
            const Index ad = nbr(s)[(l + 1) % 3];
            const Index db = nbr(s)[(l + 2) % 3];
            tri(t) = {c, a, d};
            nbr(t) = {ca, ad, s};
            tri(s) = {d, b, c};
            nbr(s) = {db, bc, t};
            replace(ad, s, t);
            replace(bc, t, s);
            stack.push_back(t);
            stack.push_back(s);
            break;
        }
    }
}

/// Where triangles share a circle, all ways to cut what they fill are Delaunay, and which one the flips end with is up
/// to rounding and the first ears. That part, whose corners go around in ascending order, gets the fan from the lowest.
class TieBreaker {
public:
    TieBreaker(const PlanePolygon& polygon, const LinkedTriangles& mesh)
        : polygon_(polygon), mesh_(mesh), leader_(mesh.triangles.size()) {
        std::iota(leader_.begin(), leader_.end(), std::size_t{0});
    }

    void run(std::vector<Triangle>& out) {
        join_ties();
        std::vector<std::size_t> order(leader_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(),
                         [this](std::size_t t, std::size_t s) { return leader_[t] < leader_[s]; });
        out.clear();
        for (std::size_t first = 0; first < order.size();) {
            std::size_t end = first;
            while (end < order.size() && leader_[order[end]] == leader_[order[first]]) {
                ++end;
            }
            const auto part = std::span(order).subspan(first, end - first);
            if (!fan(part, out)) {
                for (const std::size_t t : part) {
                    out.push_back(mesh_.triangles[t]);
                }
            }
            first = end;
        }
    }

private:
    std::size_t find(std::size_t t) {
        while (leader_[t] != t) {
            t = leader_[t] = leader_[leader_[t]];
        }
        return t;
    }

    /// Leaves in leader_ the lowest triangle of each one's part.
    void join_ties() {
        for (std::size_t t = 0; t < leader_.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto s = static_cast<std::size_t>(mesh_.neighbour[t][k]);
                if (mesh_.neighbour[t][k] < 0 || s < t) continue;
                const Triangle& own = mesh_.triangles[t];
                const auto& sides = mesh_.neighbour[s];
                const auto l = static_cast<std::size_t>(std::find(sides.begin(), sides.end(), static_cast<Index>(t)) -
                                                        sides.begin());
                const Index across = mesh_.triangles[s][(l + 2) % 3];
                if (angle_sum(polygon_, own[k], own[(k + 1) % 3], own[(k + 2) % 3], across) != AngleSum::tie) continue;
                const std::size_t one = find(t);
                const std::size_t other = find(s);
                leader_[std::max(one, other)] = std::min(one, other);
            }
        }
        for (std::size_t t = 0; t < leader_.size(); ++t) {
            leader_[t] = find(t);
        }
    }

    /// False, and nothing is added, if a triangle would have no area: on a circle that is hardly a curve.
    bool fan(std::span<const std::size_t> part, std::vector<Triangle>& out) {
        if (part.size() == 1) return false;
        corners_.clear();
        for (const std::size_t t : part) {
            corners_.insert(corners_.end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
        }
        std::sort(corners_.begin(), corners_.end());
        corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
        const std::size_t before = out.size();
        for (std::size_t k = 1; k + 1 < corners_.size(); ++k) {
            const Triangle t{corners_[0], corners_[k], corners_[k + 1]};
            if (polygon_.side(t[0], t[1], t[2]) <= 0) {
                out.resize(before);
                return false;
            }
            out.push_back(t);
        }
        return true;
    }

    const PlanePolygon& polygon_;
    const LinkedTriangles& mesh_;
    std::vector<std::size_t> leader_;
    std::vector<Index> corners_;
};

}  // namespace

Status cut_delaunay(const PlanePolygon& polygon, std::vector<Triangle>& out) {
    if (polygon.size() == 4) return cut_quad(polygon, out);
    auto mesh = EarClipper(polygon).run();
    if (!mesh) return too_thin();
    make_delaunay(polygon, *mesh);
    TieBreaker(polygon, *mesh).run(out);
    return Done{};
}

}  // namespace polylap

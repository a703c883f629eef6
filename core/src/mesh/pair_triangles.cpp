#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>

#include "polylap/mesh/convert.hpp"

namespace polylap {
namespace {

/// Qualities are compared in steps of this size, so that the order of the edges decides between pairs of equal shape
/// and not rounding.
constexpr double quality_step = 1e-9;

/// Two triangles that could become the quad with these corners.
struct Pair {
    std::array<Index, 2> triangles;
    std::array<Index, 4> quad;
    std::int64_t quality;  ///< In steps.
};

/// The least of 2 n·(e × e') / (|e|² + |e'|²) over the corners, n the unit vector area: 1 for a planar square, 0 or
/// less where a corner is straight or concave.
double quad_quality(const PolygonMesh& mesh, const std::array<Index, 4>& quad) {
    const auto corner = [&](std::size_t k) { return mesh.position(quad[k % 4]); };
    const Vector3 normal = (corner(2) - corner(0)).cross(corner(3) - corner(1)).stableNormalized();
    double least = 1;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vector3 before = corner(k + 1) - corner(k);
        const Vector3 after = corner(k + 2) - corner(k + 1);
        const double size = before.squaredNorm() + after.squaredNorm();
        if (!(size > 0)) return 0;
        least = std::min(least, 2 * normal.dot(before.cross(after)) / size);
    }
    return least;
}

/// A side of a triangle, from `from` to `to`, and the corner across.
struct Side {
    Index from, to, across, face;
    bool triangle;
};

/// All pairs that make a convex quad, best first.
std::vector<Pair> candidates(const PolygonMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(mesh.connectivity()->corners.size());
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        const std::size_t n = face.size();
        for (std::size_t k = 0; k < n; ++k) {
            sides.push_back({face[k], face[(k + 1) % n], face[(k + 2) % n], f, n == 3});
        }
    }
    const auto edge = [](const Side& s) { return std::minmax({s.from, s.to}); };
    std::sort(sides.begin(), sides.end(),
              [&](const Side& a, const Side& b) { return std::pair(edge(a), a.face) < std::pair(edge(b), b.face); });
    std::vector<Pair> pairs;
    for (std::size_t k = 0, next = 0; k < sides.size(); k = next) {
        while (next < sides.size() && edge(sides[next]) == edge(sides[k]))
            ++next;
        const Side& a = sides[k];
        const Side& b = sides[next - 1];
        const bool joinable = next - k == 2 && a.triangle && b.triangle && a.from == b.to && a.across != b.across;
        if (!joinable) continue;
        const std::array<Index, 4> quad{a.from, b.across, a.to, a.across};
        // To the nearest step: the simple figures of regular meshes then lie amid one, not between two.
        const auto quality = static_cast<std::int64_t>(std::llround(quad_quality(mesh, quad) / quality_step));
        if (quality > 0) pairs.push_back({{a.face, b.face}, quad, quality});
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.quality > b.quality; });
    return pairs;
}

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// Which pairs are joined: greedily, then with every triangle that is left over trying to trade along short paths.
class Matching {
public:
    Matching(const std::vector<Pair>& pairs, Index faces)
        : pairs_(pairs),
          joined_(static_cast<std::size_t>(faces), none),
          options_(static_cast<std::size_t>(faces)),
          busy_(static_cast<std::size_t>(faces), 0) {
        for (std::size_t p = 0; p < pairs.size(); ++p) {
            for (const Index f : pairs[p].triangles) {
                options_[static_cast<std::size_t>(f)].push_back(p);
            }
            if (joined(pairs[p].triangles[0]) == none && joined(pairs[p].triangles[1]) == none) join(p);
        }
        // Longer paths only when shorter ones are used up: they change more of what is already good.
        for (int trades = 1; trades <= longest_trade; ++trades) {
            for (Index f = 0; f < faces; ++f) {
                if (joined(f) == none) place(f, trades);
            }
        }
    }

    std::size_t joined(Index f) const { return joined_[static_cast<std::size_t>(f)]; }

private:
    static constexpr int longest_trade = 12;

    void join(std::size_t p) {
        for (const Index f : pairs_[p].triangles) {
            joined_[static_cast<std::size_t>(f)] = p;
        }
    }

    /// Finds a partner for a triangle that has none; partners of others may have to find new ones in turn. Each level
    /// tries at most two triangles (the third is its own), so a search costs no more than 2^trades steps.
    bool place(Index f, int trades) {
        busy_[static_cast<std::size_t>(f)] = 1;
        bool placed = false;
        for (const std::size_t p : options_[static_cast<std::size_t>(f)]) {
            const auto& [a, b] = pairs_[p].triangles;
            const Index partner = a == f ? b : a;
            if (busy_[static_cast<std::size_t>(partner)] != 0) continue;
            const std::size_t old = joined(partner);
            if (old != none) {
                if (trades == 0) continue;
                const auto& [c, d] = pairs_[old].triangles;
                const Index left = c == partner ? d : c;
                if (busy_[static_cast<std::size_t>(left)] != 0) continue;
                busy_[static_cast<std::size_t>(partner)] = 1;
                joined_[static_cast<std::size_t>(left)] = none;
                const bool settled = place(left, trades - 1);
                busy_[static_cast<std::size_t>(partner)] = 0;
                if (!settled) {
                    joined_[static_cast<std::size_t>(left)] = old;
                    continue;
                }
            }
            join(p);
            placed = true;
            break;
        }
        busy_[static_cast<std::size_t>(f)] = 0;
        return placed;
    }

    const std::vector<Pair>& pairs_;
    std::vector<std::size_t> joined_;                ///< F: the pair that a triangle is in
    std::vector<std::vector<std::size_t>> options_;  ///< F: pairs it could be in, best first
    std::vector<char> busy_;                         ///< F: on the path that is being tried
};

}  // namespace

Result<PolygonMesh> pair_triangles(const PolygonMesh& mesh) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        const std::vector<Pair> pairs = candidates(mesh);
        const Matching matching(pairs, mesh.face_count());
        std::vector<Index> offsets{0};
        std::vector<Index> corners;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            const std::size_t p = matching.joined(f);
            if (p == none) {
                corners.insert(corners.end(), mesh.face(f).begin(), mesh.face(f).end());
            } else if (f == pairs[p].triangles[0]) {
                corners.insert(corners.end(), pairs[p].quad.begin(), pairs[p].quad.end());
            } else {
                continue;
            }
            offsets.push_back(static_cast<Index>(corners.size()));
        }
        return PolygonMesh::create(mesh.positions(), std::move(offsets), std::move(corners));
    });
}

}  // namespace polylap

#include "repair_steps.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "polylap/mesh/repair.hpp"
#include "weld.hpp"

namespace polylap {
namespace {

struct FaceSide {
    Index v0, v1, face;  // v0 < v1
    bool forward;
};

/// Two faces at an edge that has no other.
struct Neighbour {
    Index face;
    bool opposed;  ///< Both run along the edge the same way, so that one would have to be turned.
};

struct Neighbours {
    std::vector<std::size_t> offsets;
    std::vector<Neighbour> all;

    std::span<const Neighbour> of(Index f) const {
        const auto at = static_cast<std::size_t>(f);
        return std::span(all).subspan(offsets[at], offsets[at + 1] - offsets[at]);
    }
};

Neighbours find_neighbours(const FaceList& faces) {
    std::vector<FaceSide> sides;
    sides.reserve(faces.corners.size());
    for (Index f = 0; f < faces.size(); ++f) {
        const auto face = faces.face(f);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Index from = face[k], to = face[k + 1 < face.size() ? k + 1 : 0];
            sides.push_back({std::min(from, to), std::max(from, to), f, from < to});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const FaceSide& a, const FaceSide& b) {
        return std::tie(a.v0, a.v1, a.face) < std::tie(b.v0, b.v1, b.face);
    });
    std::vector<std::pair<const FaceSide*, const FaceSide*>> pairs;
    for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
        while (last < sides.size() && sides[last].v0 == sides[first].v0 && sides[last].v1 == sides[first].v1)
            ++last;
        if (last - first == 2) pairs.emplace_back(&sides[first], &sides[first + 1]);
    }
    Neighbours neighbours;
    neighbours.offsets.assign(static_cast<std::size_t>(faces.size()) + 1, 0);
    for (const auto& [a, b] : pairs) {
        ++neighbours.offsets[static_cast<std::size_t>(a->face) + 1];
        ++neighbours.offsets[static_cast<std::size_t>(b->face) + 1];
    }
    for (std::size_t f = 1; f < neighbours.offsets.size(); ++f)
        neighbours.offsets[f] += neighbours.offsets[f - 1];
    neighbours.all.resize(2 * pairs.size());
    auto next = neighbours.offsets;
    for (const auto& [a, b] : pairs) {
        const bool opposed = a->forward == b->forward;
        neighbours.all[next[static_cast<std::size_t>(a->face)]++] = {b->face, opposed};
        neighbours.all[next[static_cast<std::size_t>(b->face)]++] = {a->face, opposed};
    }
    return neighbours;
}

/// Magnitude of the vector area of a face whose coordinates are divided by `scale`.
double scaled_area(const Points& positions, std::span<const Index> face, double scale) {
    const auto at = [&](std::size_t k) -> Vector3 { return positions.row(face[k]).transpose() / scale; };
    const Vector3 origin = at(0);
    Vector3 twice = Vector3::Zero();
    Vector3 before = at(1) - origin;
    for (std::size_t k = 2; k < face.size(); ++k) {
        const Vector3 here = at(k) - origin;
        twice += before.cross(here);
        before = here;
    }
    return twice.norm() / 2;
}

}  // namespace

void drop_spikes(std::vector<Index>& corners) {
    std::vector<Index> kept;
    kept.reserve(corners.size());
    for (const Index corner : corners) {
        if (!kept.empty() && kept.back() == corner) continue;
        if (kept.size() >= 2 && kept[kept.size() - 2] == corner)
            kept.pop_back();
        else
            kept.push_back(corner);
    }
    // The same around the closing edge.
    std::size_t first = 0;
    while (kept.size() - first >= 2) {
        const std::size_t last = kept.size() - 1;
        if (kept[last] == kept[first]) {
            kept.pop_back();
        } else if (last - first >= 2 && kept[last - 1] == kept[first]) {
            kept.resize(last - 1);
        } else if (last - first >= 2 && kept[last] == kept[first + 1]) {
            kept.pop_back();
            ++first;
        } else {
            break;
        }
    }
    corners.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
}

bool has_no_area(const Points& positions, std::span<const Index> corners) {
    double scale = 0;
    for (const Index v : corners)
        scale = std::max(scale, positions.row(v).cwiseAbs().maxCoeff());
    if (scale == 0) return true;
    // At a size of about 1, nothing over- or underflows.
    const auto from_first = [&](Index v) -> Vector3 {
        return (positions.row(v) / scale - positions.row(corners[0]) / scale).transpose();
    };
    Vector3 longest = Vector3::Zero();
    Vector3 before = from_first(corners.back());
    double perimeter = 0;
    for (const Index v : corners) {
        const Vector3 here = from_first(v);
        perimeter += (here - before).norm();
        if (here.squaredNorm() > longest.squaredNorm()) longest = here;
        before = here;
    }
    const double length = longest.norm();
    const double rounding = collinear_ratio * std::max(perimeter, 1.0);
    return std::all_of(corners.begin(), corners.end(),
                       [&](Index v) { return from_first(v).cross(longest).norm() <= rounding * length; });
}

std::vector<Index> find_duplicates(const FaceList& faces) {
    // Each face from its lowest corner towards the lower one of that corner's neighbours.
    FaceList canonical = faces;
    std::vector<std::pair<std::uint64_t, Index>> hashes;
    hashes.reserve(static_cast<std::size_t>(faces.size()));
    for (Index f = 0; f < faces.size(); ++f) {
        const auto face = canonical.face(f);
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        if (face.back() < face[1]) std::reverse(face.begin() + 1, face.end());
        std::uint64_t hash = 0;
        for (const Index v : face)
            hash = hash_step(hash, static_cast<std::uint64_t>(v));
        hashes.emplace_back(hash, f);
    }
    std::sort(hashes.begin(), hashes.end());
    std::vector<Index> duplicates, different;
    for (std::size_t first = 0, last = 0; first < hashes.size(); first = last) {
        different.clear();
        for (; last < hashes.size() && hashes[last].first == hashes[first].first; ++last) {
            const auto face = std::as_const(canonical).face(hashes[last].second);
            const bool seen = std::any_of(different.begin(), different.end(), [&](Index other) {
                const auto earlier = std::as_const(canonical).face(other);
                return std::equal(face.begin(), face.end(), earlier.begin(), earlier.end());
            });
            (seen ? duplicates : different).push_back(hashes[last].second);
        }
    }
    std::sort(duplicates.begin(), duplicates.end());
    return duplicates;
}

Orientation orient(const Points& positions, const FaceList& faces) {
    const Neighbours neighbours = find_neighbours(faces);
    const double largest = positions.rows() == 0 ? 0 : positions.cwiseAbs().maxCoeff();
    const double scale = largest == 0 ? 1 : largest;
    constexpr signed char unseen = -1;
    std::vector<signed char> way(static_cast<std::size_t>(faces.size()), unseen);
    Orientation result;
    std::vector<Index> component;
    for (Index start = 0; start < faces.size(); ++start) {
        if (way[static_cast<std::size_t>(start)] != unseen) continue;
        way[static_cast<std::size_t>(start)] = 0;
        component.assign(1, start);
        bool one_sided = false;
        std::array<double, 2> area = {0, 0};
        for (std::size_t next = 0; next < component.size(); ++next) {
            const Index f = component[next];
            const signed char here = way[static_cast<std::size_t>(f)];
            area[static_cast<std::size_t>(here)] += scaled_area(positions, faces.face(f), scale);
            for (const auto& [face, opposed] : neighbours.of(f)) {
                const auto wanted = static_cast<signed char>(opposed ? 1 - here : here);
                signed char& there = way[static_cast<std::size_t>(face)];
                if (there == unseen) {
                    there = wanted;
                    component.push_back(face);
                } else if (there != wanted) {
                    one_sided = true;
                }
            }
        }
        if (one_sided) {
            result.unorientable.insert(result.unorientable.end(), component.begin(), component.end());
            continue;
        }
        const signed char turn = area[1] > area[0] ? 0 : 1;
        for (const Index f : component)
            if (way[static_cast<std::size_t>(f)] == turn) result.turned.push_back(f);
    }
    std::sort(result.turned.begin(), result.turned.end());
    std::sort(result.unorientable.begin(), result.unorientable.end());
    return result;
}

}  // namespace polylap

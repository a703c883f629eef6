#pragma once

#include <span>
#include <utility>
#include <vector>

#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// The faces that repair works on; offsets as in Connectivity.
struct FaceList {
    std::vector<Index> offsets{0};
    std::vector<Index> corners;
    std::vector<Index> original;  ///< The face of the file that each was.

    Index size() const { return static_cast<Index>(original.size()); }
    std::span<const Index> face(Index f) const {
        const auto first = static_cast<std::size_t>(offsets[static_cast<std::size_t>(f)]);
        const auto last = static_cast<std::size_t>(offsets[static_cast<std::size_t>(f) + 1]);
        return std::span(corners).subspan(first, last - first);
    }
    std::span<Index> face(Index f) {
        const auto corner_count = std::as_const(*this).face(f).size();
        return std::span(corners).subspan(static_cast<std::size_t>(offsets[static_cast<std::size_t>(f)]), corner_count);
    }
    void add(std::span<const Index> face, Index number) {
        corners.insert(corners.end(), face.begin(), face.end());
        offsets.push_back(static_cast<Index>(corners.size()));
        original.push_back(number);
    }
};

/// Shortens a cyclic list of corners until none equals the one before it and none is the tip of a spike a b a.
void drop_spikes(std::vector<Index>& corners);

/// Whether all corners lie on one line, up to collinear_ratio.
bool has_no_area(const Points& positions, std::span<const Index> corners);

/// The faces that have the same corners as an earlier one in the same cyclic order, either way around; sorted.
std::vector<Index> find_duplicates(const FaceList& faces);

struct Orientation {
    std::vector<Index> turned;        ///< Faces to turn around; sorted.
    std::vector<Index> unorientable;  ///< Faces of components with one side only; sorted.
};
/// Orients the faces of each component alike, the way most of its area already is. Only edges with two faces connect.
Orientation orient(const Points& positions, const FaceList& faces);

}  // namespace polylap

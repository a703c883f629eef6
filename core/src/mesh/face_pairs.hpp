#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "polylap/base/monitor.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// The pairs of vertices that share a face: the pattern of all matrices that are sums over faces, and where in it each
/// face finds its own.
struct FacePairs {
    /// A place that does not fit its byte is searched for.
    static constexpr std::uint8_t far = 255;

    std::vector<Index> offsets;     ///< V+1
    std::vector<Index> neighbours;  ///< Those of v, ascending, itself among them: [offsets[v], offsets[v+1]).
    /// Face after face, of one with n corners n² places: that of the vertex of corner i among the neighbours of the
    /// vertex of corner j is the (i n + j)th.
    std::vector<std::uint8_t> places;

    /// Where vertex w is found among the neighbours of v.   Cost O(log n)
    std::size_t search(Index v, Index w) const;
};

/// @param offsets F+1   @param corners as in Connectivity, two or more a face
/// @error out_of_memory (also for more pairs than an Index can count), cancelled.   Cost O(Σ n²)
Result<std::shared_ptr<const FacePairs>> pair_corners(Index vertex_count, std::span<const Index> offsets,
                                                      std::span<const Index> corners, Monitor monitor);

/// Those of the faces, kept with the connectivity unless they take more memory than that is worth.
Result<std::shared_ptr<const FacePairs>> face_pairs(const Connectivity& connectivity, Monitor monitor);

/// The number of corners of the largest face.
std::size_t largest_face(const Connectivity& connectivity);

}  // namespace polylap

#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "polylap/base/types.hpp"

namespace polylap {

/// Joins a word to a hash, by the finaliser of MurmurHash3, which spreads every bit.
inline std::uint64_t hash_step(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 0xff51afd7ed558ccdU;
    hash ^= hash >> 33;
    hash *= 0xc4ceb9fe1a85ec53U;
    return hash ^ (hash >> 33);
}

struct HashTriple {
    std::size_t operator()(const std::array<std::uint64_t, 3>& words) const {
        return static_cast<std::size_t>(hash_step(hash_step(hash_step(0, words[0]), words[1]), words[2]));
    }
};

/// Finds positions that are exactly equal (0 and -0 are).
class Welder {
public:
    /// The number under which this position came first; `number` if it is new.
    Index weld(const std::array<double, 3>& position, Index number) {
        std::array<std::uint64_t, 3> key{};
        for (std::size_t k = 0; k < 3; ++k)
            key[k] = Eigen::numext::bit_cast<std::uint64_t>(position[k] + 0.0);  // -0 + 0 = 0
        return numbers_.try_emplace(key, number).first->second;
    }

private:
    std::unordered_map<std::array<std::uint64_t, 3>, Index, HashTriple> numbers_;
};

/// For each vertex the one it becomes: the lowest-numbered within `distance_ratio` times the bounding box's diagonal
/// that did not itself become another; of itself if there is none.   Throws std::bad_alloc
std::vector<Index> merge_vertices(const Points& positions, double distance_ratio);

}  // namespace polylap

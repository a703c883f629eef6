#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "polylap/base/types.hpp"
#include "solve/ordering/graph.hpp"

namespace polylap {

enum class Side : std::uint8_t { first, second, separator };

/// Splits regions of a graph by small vertex separators, reusing its memory.
class Splitter {
public:
    /// @param positions one a vertex, or no rows
    Splitter(const Graph& graph, const Points& positions);

    /// What share of the smaller half the larger one may take more.
    static constexpr double balance = 1.2;

    struct Sizes {
        Index first = 0, second = 0, separator = 0;
    };

    /// Marks the vertices as one region: neighbours outside of it will not count.
    void mark(std::span<const Index> region);
    /// Splits the region marked last. Its vertices are connected.
    Sizes split(std::span<const Index> region);
    Side side(Index v) const { return side_[static_cast<std::size_t>(v)]; }

    /// The vertices of the marked region that can be reached from v, by rising distance. Valid until the next call.
    std::span<const Index> reach(Index v);

private:
    bool inside(Index v) const { return region_[static_cast<std::size_t>(v)] == mark_; }
    Sizes split_by_position(std::span<const Index> region);
    Sizes split_by_distance(std::span<const Index> region);
    /// The separator between the vertices that are on the first side and the others, from the shorter of the two
    /// shores.
    Sizes separate(std::span<const Index> region);
    double estimate_cut(std::span<const Index> region, const Vector3& direction);

    // Refinement
    void refine(Sizes& sizes);
    bool refine_once(Sizes& sizes, Index limit);
    void enter(Index v);
    void insert(Index node, Index gain);
    void remove(Index node);
    void change(Index v, Side to, Index by);

    const Graph& graph_;
    const Points& positions_;
    Index mark_ = 0;
    std::vector<Index> region_;  ///< Per vertex the mark of the region that it was in last.
    std::vector<Side> side_;
    std::vector<Index> visited_, queue_;
    Index visit_ = 0;
    std::vector<double> key_, keys_;

    // A vertex of the separator can move to either side: node 2v + side, in a list of nodes of the same gain.
    static constexpr Index worst = -32;
    static constexpr std::size_t levels = 34;  ///< Gains from `worst` to 1.
    std::array<std::array<Index, levels>, 2> head_;
    std::array<std::size_t, 2> top_;
    std::vector<Index> next_, previous_, gain_;
    std::vector<std::uint8_t> locked_;
    std::vector<Index> separator_, pulled_;
    struct Move {
        Index vertex;
        Side to;
        std::size_t pulled;  ///< End of its part of pulled_.
    };
    std::vector<Move> moves_;
};

}  // namespace polylap

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
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

        /// Whether the parts are small enough to go on with. Random graphs and cliques have no such separator.
        bool useful() const {
            const double all = static_cast<double>(first) + second + separator;
            return separator < 0.25 * all && std::max(first, second) < 0.9 * all;
        }
    };

    /// Marks the vertices as one region: neighbours outside of it will not count.
    void mark(std::span<const Index> region);
    /// Splits the region marked last by a plane through its vertices' positions.
    Sizes split_by_position(std::span<const Index> region);
    /// The same by distances in the graph, for a connected region.
    /// @param known a split found before, which is kept if it is as good
    Sizes split_by_distance(std::span<const Index> region, const Sizes& known);
    /// The separator between the sides that the region's vertices were given, first or second.
    Sizes separate(std::span<const Index> region);
    void give(Index v, Side side) { side_[static_cast<std::size_t>(v)] = side; }
    Side side(Index v) const { return side_[static_cast<std::size_t>(v)]; }

    /// The vertices of the marked region that can be reached from v, by rising distance. Valid until the next call.
    std::span<const Index> reach(Index v);

private:
    struct Plane {
        Vector3 normal = Vector3::Zero();
        double offset = 0;  ///< x · normal of its points.
    };

    bool inside(Index v) const { return region_[static_cast<std::size_t>(v)] == mark_; }
    Sizes split_by_plane(std::span<const Index> region, const Points& positions);
    void sample(std::span<const Index> region, const Points& positions);
    Plane find_plane();
    double median(const Vector3& normal, std::size_t step);
    std::size_t count_parted(const Plane& plane, std::size_t step);

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
    std::vector<Side> side_, kept_;
    Index visit_ = 0;
    std::vector<Index> visited_, queue_;
    std::vector<Index> distance_;     ///< From where the last search began, of the vertices it reached.
    std::vector<Index> nearest_;      ///< Least distance from the pivots.
    Points coordinates_;              ///< Distances from three pivots.
    std::vector<Vector3> sampled_;    ///< Vertices, each with its neighbours behind it.
    std::vector<std::size_t> stars_;  ///< Where each begins.
    std::vector<double> keys_;

    // A vertex of the separator can move to either side: node 2v + side, in a list of nodes of the same gain.
    static constexpr Index worst = -32;
    static constexpr std::size_t levels = 34;  ///< Gains from `worst` to 1.
    std::array<std::array<Index, levels>, 2> head_{};
    std::array<std::size_t, 2> top_{};
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

// Vertex separators. A region is cut in two halves by a plane through its middle, in whichever of a few directions
// parts fewest neighbours; the shorter shore of the cut is a first separator. Where positions do not help, distances in
// the graph from three vertices far apart are the coordinates: Harel & Koren, Graph drawing by high-dimensional
// embedding, 2002.

#include "solve/ordering/separator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace polylap {
namespace {

std::size_t at(Index v) {
    return static_cast<std::size_t>(v);
}

}  // namespace

Splitter::Splitter(const Graph& graph, const Points& positions)
    : graph_(graph),
      positions_(positions),
      region_(at(graph.size()), 0),
      side_(at(graph.size()), Side::first),
      visited_(at(graph.size()), 0),
      distance_(at(graph.size())),
      next_(2 * at(graph.size())),
      previous_(2 * at(graph.size())),
      gain_(2 * at(graph.size())),
      locked_(at(graph.size()), 0) {
    for (auto& heads : head_)
        heads.fill(-1);
}

void Splitter::mark(std::span<const Index> region) {
    ++mark_;
    for (const Index v : region)
        region_[at(v)] = mark_;
}

std::span<const Index> Splitter::reach(Index v) {
    ++visit_;
    queue_.assign(1, v);
    visited_[at(v)] = visit_;
    distance_[at(v)] = 0;
    for (std::size_t k = 0; k < queue_.size(); ++k) {
        const Index next = distance_[at(queue_[k])] + 1;
        for (const Index u : graph_.around(queue_[k])) {
            if (!inside(u) || visited_[at(u)] == visit_) continue;
            visited_[at(u)] = visit_;
            distance_[at(u)] = next;
            queue_.push_back(u);
        }
    }
    return queue_;
}

Splitter::Sizes Splitter::split_by_position(std::span<const Index> region) {
    return split_by_plane(region, positions_);
}

Splitter::Sizes Splitter::split_by_distance(std::span<const Index> region, const Sizes& known) {
    if (coordinates_.rows() == 0) {
        coordinates_.resize(graph_.size(), 3);
        nearest_.resize(region_.size());
    }
    kept_.clear();
    for (const Index v : region)
        kept_.push_back(side_[at(v)]);
    Index pivot = reach(region.front()).back();
    for (int axis = 0; axis < 3; ++axis) {
        Index farthest = pivot;
        for (const Index v : reach(pivot)) {
            const Index distance = distance_[at(v)];
            coordinates_(v, axis) = distance;
            nearest_[at(v)] = axis == 0 ? distance : std::min(nearest_[at(v)], distance);
            if (nearest_[at(v)] > nearest_[at(farthest)]) farthest = v;
        }
        pivot = farthest;
    }
    const Sizes sizes = split_by_plane(region, coordinates_);
    if (!known.useful() || (sizes.useful() && sizes.separator < known.separator)) return sizes;
    for (std::size_t k = 0; k < region.size(); ++k)
        side_[at(region[k])] = kept_[k];
    return known;
}

Splitter::Sizes Splitter::split_by_plane(std::span<const Index> region, const Points& positions) {
    sample(region, positions);
    const Plane plane = find_plane();
    for (const Index v : region) {
        side_[at(v)] = positions.row(v).dot(plane.normal) < plane.offset ? Side::first : Side::second;
    }
    return separate(region);
}

/// Some vertices and their neighbours, as many at any size that a good cut meets a few dozen of them.
void Splitter::sample(std::span<const Index> region, const Points& positions) {
    constexpr double density = 20;  // of √n vertices a cut has; measured: fewer cost fill
    const double step = std::max(1.0, std::sqrt(static_cast<double>(region.size())) / density);
    const auto spread = static_cast<std::uint32_t>(2 * step - 1);
    std::uint32_t random = 1;  // any fixed sequence; a regular step would follow the rows of a grid
    const auto draw = [&random] { return (random = random * 1664525u + 1013904223u) >> 8; };
    sampled_.clear();
    stars_.clear();
    for (std::size_t k = 0; k < region.size(); k += 1 + draw() % spread) {
        stars_.push_back(sampled_.size());
        sampled_.push_back(positions.row(region[k]));
        for (const Index u : graph_.around(region[k])) {
            if (inside(u)) sampled_.push_back(positions.row(u));
        }
    }
    stars_.push_back(sampled_.size());
}

double Splitter::median(const Vector3& normal, std::size_t step) {
    keys_.clear();
    for (std::size_t k = 0; k + 1 < stars_.size(); k += step)
        keys_.push_back(sampled_[stars_[k]].dot(normal));
    const auto middle = keys_.begin() + static_cast<std::ptrdiff_t>(keys_.size() / 2);
    std::nth_element(keys_.begin(), middle, keys_.end());
    return *middle;
}

/// How many of the sample, or of a part of it, a plane parts from a neighbour.
std::size_t Splitter::count_parted(const Plane& plane, std::size_t step) {
    std::size_t parted = 0;
    for (std::size_t k = 0; k + 1 < stars_.size(); k += step) {
        const Vector3* const star = sampled_.data() + stars_[k];
        const std::size_t size = stars_[k + 1] - stars_[k];
        std::size_t low = 0;
        for (std::size_t i = 0; i < size; ++i)
            low += star[i].dot(plane.normal) < plane.offset ? 1 : 0;
        parted += low != 0 && low != size ? 1 : 0;
    }
    return parted;
}

Splitter::Plane Splitter::find_plane() {
    const double stars = static_cast<double>(stars_.size() - 1);
    Vector3 centre = Vector3::Zero();
    for (std::size_t k = 0; k + 1 < stars_.size(); ++k)
        centre += sampled_[stars_[k]] / stars;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k + 1 < stars_.size(); ++k) {
        const Vector3 x = sampled_[stars_[k]] - centre;
        spread += x * x.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    const Vector3 longest = solver.eigenvectors().col(2);
    const Vector3 second = solver.eigenvectors().col(1);
    const Vector3 thinnest = solver.eigenvectors().col(0);
    std::array<Vector3, 7> candidates{longest, second, longest + second, longest - second};
    std::size_t count = 4;
    for (int k = 0; k < 3; ++k) {  // many meshes follow the axes
        const Vector3 axis = Vector3::Unit(k);
        const bool known = std::max(std::abs(axis.dot(longest)), std::abs(axis.dot(second))) > 0.98;
        const bool across = std::abs(axis.dot(thinnest)) > 0.9;
        if (!known && !across) candidates[count++] = axis;
    }
    // A part of the sample tells which are out of the question.
    constexpr std::size_t part = 4;
    constexpr double hopeless = 1.5;
    constexpr auto none = std::numeric_limits<std::size_t>::max();
    std::array<Plane, 7> planes;
    std::array<std::size_t, 7> parted{};
    std::size_t fewest = none;
    for (std::size_t k = 0; k < count; ++k) {
        planes[k] = {candidates[k], median(candidates[k], 1 + stars_.size() / 512)};
        parted[k] = count_parted(planes[k], part);
        if (parted[k] > 0) fewest = std::min(fewest, parted[k]);
    }
    Plane best;
    std::size_t least = none;
    for (std::size_t k = 0; k < count; ++k) {
        if (static_cast<double>(parted[k]) > hopeless * static_cast<double>(fewest) + 2) continue;
        const std::size_t all = count_parted(planes[k], 1);
        if (all == 0 || all >= least) continue;
        least = all;
        best.normal = candidates[k];
    }
    best.offset = median(best.normal, 1);
    return best;
}

/// From the shorter of the two shores.
Splitter::Sizes Splitter::separate(std::span<const Index> region) {
    std::array<Index, 2> count{};
    std::array<Index, 2> shore{};
    visit_ += 1;  // marks the shores
    for (const Index v : region) {
        const auto mine = at(static_cast<Index>(side_[at(v)]));
        ++count[mine];
        for (const Index u : graph_.around(v)) {
            if (!inside(u) || side_[at(u)] == side_[at(v)]) continue;
            ++shore[mine];
            visited_[at(v)] = visit_;
            break;
        }
    }
    const bool from_first = shore[0] < shore[1] || (shore[0] == shore[1] && count[0] > count[1]);
    const Side from = from_first ? Side::first : Side::second;
    separator_.clear();
    for (const Index v : region) {
        if (side_[at(v)] != from || visited_[at(v)] != visit_) continue;
        side_[at(v)] = Side::separator;
        separator_.push_back(v);
    }
    Sizes sizes{count[0], count[1], static_cast<Index>(separator_.size())};
    (from_first ? sizes.first : sizes.second) -= sizes.separator;
    refine(sizes);
    return sizes;
}

}  // namespace polylap

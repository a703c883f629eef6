// Vertex separators. A region is cut in two halves by a plane through its middle, in whichever of a few directions cuts
// fewest edges (George, Nested dissection of a regular finite element mesh, 1973, without the grid), or by the distance
// from a vertex at its rim (George & Liu, 1979, for the vertex). The shorter shore of the cut is a first separator.

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
      key_(at(graph.size())),
      next_(2 * at(graph.size())),
      previous_(2 * at(graph.size())),
      gain_(2 * at(graph.size())),
      locked_(at(graph.size()), 0) {
    for (auto& heads : head_)
        heads.fill(-1);
    top_.fill(0);
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
    for (std::size_t k = 0; k < queue_.size(); ++k) {
        for (const Index u : graph_.around(queue_[k])) {
            if (!inside(u) || visited_[at(u)] == visit_) continue;
            visited_[at(u)] = visit_;
            queue_.push_back(u);
        }
    }
    return queue_;
}

Splitter::Sizes Splitter::split(std::span<const Index> region) {
    if (positions_.rows() == 0) return split_by_distance(region);
    const Sizes by_position = split_by_position(region);
    // A patch of a surface has separators of √n vertices, a tube of two or three times that.
    constexpr double suspicious = 3;
    if (by_position.separator <= suspicious * std::sqrt(static_cast<double>(region.size()))) return by_position;
    std::vector<Side> kept;
    for (const Index v : region)
        kept.push_back(side_[at(v)]);
    const Sizes by_distance = split_by_distance(region);
    if (by_distance.separator < by_position.separator) return by_distance;
    for (std::size_t k = 0; k < region.size(); ++k)
        side_[at(region[k])] = kept[k];
    return by_position;
}

/// How many of a sample's vertices see the other side of the middle.
double Splitter::estimate_cut(std::span<const Index> region, const Vector3& direction) {
    const auto key = [&](Index v) { return positions_.row(v).dot(direction); };
    const auto n = static_cast<double>(region.size());
    const auto step = static_cast<std::size_t>(std::max(1.0, std::sqrt(n) / 20));
    keys_.clear();
    for (std::size_t k = 0; k < region.size(); k += step)
        keys_.push_back(key(region[k]));
    const auto middle = keys_.begin() + static_cast<std::ptrdiff_t>(keys_.size() / 2);
    std::nth_element(keys_.begin(), middle, keys_.end());
    const double limit = *middle;
    std::array<Index, 2> shore{};
    std::array<Index, 2> count{};
    for (std::size_t k = 0; k < region.size(); k += step) {
        const bool low = key(region[k]) < limit;
        ++count[low ? 0 : 1];
        for (const Index u : graph_.around(region[k])) {
            if (!inside(u) || (key(u) < limit) == low) continue;
            ++shore[low ? 0 : 1];
            break;
        }
    }
    if (count[0] == 0) return std::numeric_limits<double>::max();
    return std::min(shore[0], shore[1]);
}

Splitter::Sizes Splitter::split_by_position(std::span<const Index> region) {
    Vector3 centre = Vector3::Zero();
    for (const Index v : region)
        centre += positions_.row(v).transpose();
    centre /= static_cast<double>(region.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Index v : region) {
        const Vector3 x = positions_.row(v).transpose() - centre;
        spread += x * x.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    const Vector3 longest = solver.eigenvectors().col(2);
    const Vector3 second = solver.eigenvectors().col(1);
    const std::array<Vector3, 7> directions{longest,          second,           longest + second, longest - second,
                                            Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
    const Vector3* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Vector3& direction : directions) {
        const double cut = estimate_cut(region, direction);
        if (cut >= least) continue;
        least = cut;
        best = &direction;
    }
    const Vector3 direction = best == nullptr ? longest : *best;
    keys_.clear();
    for (const Index v : region) {
        key_[at(v)] = positions_.row(v).dot(direction);
        keys_.push_back(key_[at(v)]);
    }
    const auto middle = keys_.begin() + static_cast<std::ptrdiff_t>(keys_.size() / 2);
    std::nth_element(keys_.begin(), middle, keys_.end());
    for (const Index v : region)
        side_[at(v)] = key_[at(v)] < *middle ? Side::first : Side::second;
    return separate(region);
}

Splitter::Sizes Splitter::split_by_distance(std::span<const Index> region) {
    Index rim = region.front();
    for (int round = 0; round < 2; ++round)
        rim = reach(rim).back();
    const auto order = reach(rim);
    for (std::size_t k = 0; k < order.size(); ++k) {
        side_[at(order[k])] = k < order.size() / 2 ? Side::first : Side::second;
    }
    return separate(region);
}

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

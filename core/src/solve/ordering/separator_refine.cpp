// Refinement of a vertex separator: a vertex of it moves to one side, and its neighbours on the other side take its
// place. Fiduccia & Mattheyses' passes (best move first, worse ones allowed, back to the best state seen) on separators
// as in Karypis & Kumar, A fast and high quality multilevel scheme for partitioning irregular graphs, 1998.

#include <algorithm>
#include <cmath>
#include <tuple>

#include "solve/ordering/separator.hpp"

namespace polylap {
namespace {

std::size_t at(Index v) {
    return static_cast<std::size_t>(v);
}
Side other(Side side) {
    return side == Side::first ? Side::second : Side::first;
}
Index node_of(Index v, Side to) {
    return 2 * v + static_cast<Index>(to);
}

}  // namespace

void Splitter::insert(Index node, Index gain) {
    gain_[at(node)] = gain;
    auto& heads = head_[at(node % 2)];
    const auto level = at(std::max(gain, worst) - worst);
    next_[at(node)] = heads[level];
    previous_[at(node)] = -1;
    if (heads[level] >= 0) previous_[at(heads[level])] = node;
    heads[level] = node;
    top_[at(node % 2)] = std::max(top_[at(node % 2)], level);
}

void Splitter::remove(Index node) {
    const Index next = next_[at(node)];
    const Index previous = previous_[at(node)];
    if (next >= 0) previous_[at(next)] = previous;
    if (previous >= 0) {
        next_[at(previous)] = next;
    } else {
        head_[at(node % 2)][at(std::max(gain_[at(node)], worst) - worst)] = next;
    }
}

/// Lists what moving v would gain.
void Splitter::enter(Index v) {
    std::array<Index, 2> count{};
    for (const Index u : graph_.around(v)) {
        if (inside(u) && side(u) != Side::separator) ++count[at(static_cast<Index>(side(u)))];
    }
    insert(node_of(v, Side::first), 1 - count[1]);
    insert(node_of(v, Side::second), 1 - count[0]);
}

void Splitter::change(Index v, Side to, Index by) {
    if (locked_[at(v)] != 0) return;
    const Index node = node_of(v, to);
    remove(node);
    insert(node, gain_[at(node)] + by);
}

/// One pass. @return whether the separator became better
bool Splitter::refine_once(Sizes& sizes, Index limit) {
    for (const Index v : separator_)
        enter(v);
    moves_.clear();
    pulled_.clear();
    std::array<Index, 2> count{sizes.first, sizes.second};
    Index width = sizes.separator;
    const auto quality = [&] {
        const Index larger = std::max(count[0], count[1]);
        return std::tuple(std::max<Index>(0, larger - limit), width, larger);
    };
    auto best = quality();
    const auto before = best;
    std::size_t best_moves = 0;
    const std::size_t patience = std::max<std::size_t>(20, std::min<std::size_t>(300, 2 * separator_.size()));
    while (moves_.size() - best_moves < patience) {
        std::array<Index, 2> candidate{-1, -1};
        for (std::size_t t = 0; t < 2; ++t) {
            while (top_[t] > 0 && head_[t][top_[t]] < 0)
                --top_[t];
            candidate[t] = head_[t][top_[t]];
            if (count[t] >= limit) candidate[t] = -1;
        }
        if (candidate[0] < 0 && candidate[1] < 0) break;
        std::size_t t = 0;
        if (candidate[0] < 0) {
            t = 1;
        } else if (candidate[1] >= 0) {
            const Index gain0 = gain_[at(candidate[0])];
            const Index gain1 = gain_[at(candidate[1])];
            t = gain1 > gain0 || (gain1 == gain0 && count[1] < count[0]) ? 1 : 0;
        }
        const Side to = t == 0 ? Side::first : Side::second;
        const Side from = other(to);
        const Index v = candidate[t] / 2;
        remove(node_of(v, Side::first));
        remove(node_of(v, Side::second));
        locked_[at(v)] = 1;
        side_[at(v)] = to;
        ++count[t];
        --width;
        for (const Index u : graph_.around(v)) {
            if (!inside(u)) continue;
            if (side(u) == Side::separator) {
                change(u, from, -1);  // it would pull v back
            } else if (side(u) == from) {
                side_[at(u)] = Side::separator;
                pulled_.push_back(u);
                --count[1 - t];
                ++width;
                for (const Index w : graph_.around(u)) {
                    if (inside(w) && side(w) == Side::separator) change(w, to, 1);
                }
                if (locked_[at(u)] == 0) enter(u);
            }
        }
        moves_.push_back({v, to, pulled_.size()});
        if (const auto now = quality(); now < best) {
            best = now;
            best_moves = moves_.size();
        }
    }
    for (auto& heads : head_)
        heads.fill(-1);
    top_.fill(0);
    for (const Move& move : moves_) {
        locked_[at(move.vertex)] = 0;
        separator_.push_back(move.vertex);
    }
    separator_.insert(separator_.end(), pulled_.begin(), pulled_.end());
    while (moves_.size() > best_moves) {
        const Move move = moves_.back();
        moves_.pop_back();
        const std::size_t first = moves_.empty() ? 0 : moves_.back().pulled;
        for (std::size_t k = first; k < move.pulled; ++k)
            side_[at(pulled_[k])] = other(move.to);
        side_[at(move.vertex)] = Side::separator;
        const auto t = at(static_cast<Index>(move.to));
        --count[t];
        count[1 - t] += static_cast<Index>(move.pulled - first);
    }
    std::sort(separator_.begin(), separator_.end());
    separator_.erase(std::unique(separator_.begin(), separator_.end()), separator_.end());
    std::erase_if(separator_, [&](Index v) { return side(v) != Side::separator; });
    sizes = {count[0], count[1], static_cast<Index>(separator_.size())};
    return best < before;
}

void Splitter::refine(Sizes& sizes) {
    const double n = sizes.first + sizes.second + sizes.separator;
    const auto limit = static_cast<Index>(std::ceil(n * balance / 2));
    constexpr int passes = 6;
    for (int pass = 0; pass < passes && refine_once(sizes, limit); ++pass) {
    }
}

}  // namespace polylap

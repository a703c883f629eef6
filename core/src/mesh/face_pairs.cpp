#include "mesh/face_pairs.hpp"

#include <limits>
#include <numeric>
#include <stdexcept>

namespace polylap {
namespace {

/// Faces with more corners are dense blocks, and matrices on them rare: theirs is not kept.
constexpr std::size_t largest_kept_face = 256;

constexpr std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}

/// Ticks about every 0.05 s.
class Pace {
public:
    Pace(Monitor monitor, double total) : monitor_(monitor), total_(total) {}
    bool proceed(std::size_t pairs) {
        if ((since_ += pairs) < std::size_t{1} << 23) return true;
        done_ += static_cast<double>(since_);
        since_ = 0;
        return monitor_.proceed(std::min(1.0, done_ / total_));
    }

private:
    Monitor monitor_;
    double total_, done_ = 0;
    std::size_t since_ = 0;
};

/// The faces at each vertex.
struct Incidence {
    std::vector<Index> last;  ///< V+1: those of v are faces[last[v - 1] … last[v]), from 0 on for the first.
    std::vector<Index> faces;

    Incidence(Index vertex_count, std::span<const Index> offsets, std::span<const Index> corners)
        : last(at(vertex_count) + 1, 0), faces(corners.size()) {
        for (const Index v : corners)
            ++last[at(v) + 1];
        std::partial_sum(last.begin(), last.end(), last.begin());
        for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
            for (const Index v : corners.subspan(at(offsets[f]), at(offsets[f + 1] - offsets[f])))
                faces[at(last[at(v)]++)] = static_cast<Index>(f);
        }
    }
};

}  // namespace

std::size_t FacePairs::search(Index v, Index w) const {
    const auto first = neighbours.begin() + offsets[at(v)];
    return static_cast<std::size_t>(std::lower_bound(first, neighbours.begin() + offsets[at(v) + 1], w) - first);
}

Result<std::shared_ptr<const FacePairs>> pair_corners(Index vertex_count, std::span<const Index> offsets,
                                                      std::span<const Index> corners, Monitor monitor) {
    return guard_memory([&]() -> Result<std::shared_ptr<const FacePairs>> {
        std::vector<std::size_t> first_place{0};  // of each face
        first_place.reserve(offsets.size());
        for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
            const std::size_t n = at(offsets[f + 1] - offsets[f]);
            if (n * n > std::numeric_limits<std::size_t>::max() / 2 - first_place.back())
                throw std::length_error("pairs");
            first_place.push_back(first_place.back() + n * n);
        }
        const Incidence incidence(vertex_count, offsets, corners);
        Pace pace(monitor, 2 * static_cast<double>(first_place.back()));
        const Error cancelled{ErrorCode::cancelled, "cancelled"};

        struct Last {
            Index row;    ///< The last row with this column.
            Index place;  ///< Its place there.
        };
        std::vector<Last> last(at(vertex_count), {-1, -1});
        auto pairs = std::make_shared<FacePairs>();
        pairs->offsets.resize(at(vertex_count) + 1, 0);
        std::size_t count = 0;
        auto face = incidence.faces.begin();
        for (Index v = 0; v < vertex_count; ++v) {
            for (const auto end = incidence.faces.begin() + incidence.last[at(v)]; face != end; ++face) {
                const std::size_t n = at(offsets[at(*face) + 1] - offsets[at(*face)]);
                for (const Index w : corners.subspan(at(offsets[at(*face)]), n)) {
                    count += last[at(w)].row != v ? 1 : 0;
                    last[at(w)].row = v;
                }
                if (!pace.proceed(n)) return cancelled;
            }
            if (count > at(std::numeric_limits<Index>::max())) throw std::length_error("pairs");
            pairs->offsets[at(v) + 1] = static_cast<Index>(count);
        }

        // Rows in ascending order leave each column sorted.
        std::fill(last.begin(), last.end(), Last{-1, -1});
        pairs->neighbours.resize(count);
        pairs->places.resize(first_place.back());
        Index* const neighbours = pairs->neighbours.data();
        const Index* const offset = pairs->offsets.data();
        face = incidence.faces.begin();
        for (Index v = 0; v < vertex_count; ++v) {
            for (const auto end = incidence.faces.begin() + incidence.last[at(v)]; face != end; ++face) {
                const std::size_t n = at(offsets[at(*face) + 1] - offsets[at(*face)]);
                const Index* const vertices = corners.data() + offsets[at(*face)];
                std::size_t i = 0;
                while (vertices[i] != v)
                    ++i;
                std::uint8_t* const place = pairs->places.data() + first_place[at(*face)] + i * n;
                for (std::size_t j = 0; j < n; ++j) {
                    const Index w = vertices[j];
                    Last& column = last[at(w)];
                    column.place += column.row != v ? 1 : 0;  // no jump: which of them are new, nobody can predict
                    column.row = v;
                    neighbours[offset[w] + column.place] = v;
                    place[j] = static_cast<std::uint8_t>(std::min<Index>(column.place, FacePairs::far));
                }
                if (!pace.proceed(n)) return cancelled;
            }
        }
        return std::shared_ptr<const FacePairs>(std::move(pairs));
    });
}

std::size_t largest_face(const Connectivity& connectivity) {
    Index largest = 0;
    for (std::size_t f = 0; f + 1 < connectivity.offsets.size(); ++f)
        largest = std::max(largest, connectivity.offsets[f + 1] - connectivity.offsets[f]);
    return at(largest);
}

Result<std::shared_ptr<const FacePairs>> face_pairs(const Connectivity& connectivity, Monitor monitor) {
    const auto make = [&] {
        return pair_corners(connectivity.vertex_count, connectivity.offsets, connectivity.corners, monitor);
    };
    if (largest_face(connectivity) > largest_kept_face) return make();
    return connectivity.face_pairs.get(make);
}

}  // namespace polylap

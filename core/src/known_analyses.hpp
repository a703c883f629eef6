#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>

#include "polylap/solve/spd_factor.hpp"

namespace polylap {

/// The last two analyses of Cholesky factors, shared by all that factor matrices of one pattern: smoothing and
/// harmonic functions of both sides. Two, because the sides' operators may join different vertices.
class KnownAnalyses {
public:
    /// The last ones; null where there were not as many.
    std::span<const std::shared_ptr<const SpdAnalysis>> kept() const { return kept_; }

    /// @param analysis null: nothing happens
    void keep(std::shared_ptr<const SpdAnalysis> analysis) {
        if (analysis == nullptr) return;
        auto place = std::find(kept_.begin(), kept_.end(), analysis);
        if (place == kept_.end()) *--place = std::move(analysis);
        std::rotate(kept_.begin(), place, place + 1);
    }

private:
    std::array<std::shared_ptr<const SpdAnalysis>, 2> kept_;  ///< The one used last comes first.
};

}  // namespace polylap

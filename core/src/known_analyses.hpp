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
    /// Null where none fits.
    std::shared_ptr<const SpdAnalysis> find(const SparseMatrix& a) {
        const auto fitting = std::find_if(
            kept_.begin(), kept_.end(), [&](const auto& analysis) { return analysis != nullptr && analysis->fits(a); });
        if (fitting == kept_.end()) return nullptr;
        std::rotate(kept_.begin(), fitting, fitting + 1);
        return kept_.front();
    }

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

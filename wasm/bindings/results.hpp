// Results of the core as JavaScript objects; their fields are those of wasm/src/types.ts.
#pragma once

#include "polylap/apply/convergence.hpp"
#include "polylap/session.hpp"
#include "values.hpp"

namespace polylap::js {

/// For JavaScript to own.
Result<val> owned(Result<Session> session);
val told(const Session::Shape& shape);
/// null where there is none
val told(const std::optional<SmoothingSolve>& solve);
val told(const Session::Repairs& repairs);
val told(const Session::Weights& weights);
val told(const Session::Row& row);
val told(const FaceReport& face);
val told(const Session::Harmonic& harmonic);
val told(const PropertyReport& report);
/// @param origin to which its float positions are relative
val told(const OrthogonalDual& dual, const Vector3& origin);
val told(const ConvergenceStudy& study);

}  // namespace polylap::js

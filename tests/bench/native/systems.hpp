#pragma once

#include "peers.hpp"
#include "polylap/operators/operator.hpp"

namespace polylap::bench {

/// The operator whose assembly and systems are measured: every pair of corners of a face is an entry.
inline constexpr const char* full_operator = "alexa-wardetzky";
inline constexpr const char* cotan_operator = "planar";

OperatorMatrices build(const PolygonMesh& mesh, const char* id = full_operator);
/// The square of the mean edge length.
double squared_edge(const PolygonMesh& mesh);
/// M + t S with t = the squared mean edge, and three smooth right-hand sides.
System smoothing_system(const PolygonMesh& mesh);

}  // namespace polylap::bench

#pragma once

#include "harness.hpp"

namespace polylap::bench {

/// First and repeated assembly of the operators that are sums over faces, against assembly as it is commonly written.
void run_assembly(Bench& bench);
/// OBJ bytes to a validated mesh with its topology.
void run_loading(Bench& bench);
/// Factor and solve from a thousand to a million vertices, against the peers.
void run_factor(Bench& bench);
/// What people wait for: a smoothing step, a harmonic function, eigenpairs.
void run_steps(Bench& bench);
/// Smoothing by a factor, by conjugate gradients, and by what the library chooses, over the time of a step.
void run_iterative(Bench& bench);
/// Pins that come and go, against elimination.
void run_pins(Bench& bench);

}  // namespace polylap::bench

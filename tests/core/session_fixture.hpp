#pragma once

#include "polylap/apply/noise.hpp"
#include "polylap/mesh/shapes.hpp"
#include "polylap/session.hpp"
#include "zoo.hpp"

namespace polylap::test {

using Side = Session::Side;
inline constexpr Side sides[] = {Side::a, Side::b};

inline Session open_mesh(const PolygonMesh& mesh) {
    return get(Session::from_mesh(mesh));
}
inline PolygonMesh noisy_torus() {
    return get(add_normal_noise(get(make_torus(12, 8)), 0.2, 3));
}

/// All that a failing call must leave alone.
struct State {
    std::vector<OperatorSpec> specs;
    std::vector<Points> surfaces;
    std::vector<int> steps;
    friend bool operator==(const State&, const State&) = default;
};
inline State state_of(const Session& session) {
    State state;
    for (const Side side : sides) {
        state.specs.push_back(session.spec(side));
        state.surfaces.push_back(session.surface(side).positions());
        state.steps.push_back(session.step_count(side));
    }
    return state;
}

}  // namespace polylap::test

#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "polylap/base/monitor.hpp"
#include "polylap/mesh/polygon_mesh.hpp"
#include "polylap/mesh/topology.hpp"
#include "polylap/operators/operator.hpp"

namespace polylap::test {

/// The value of a result that a test takes for granted; an error ends the test with its message.
template <class T>
T get(Result<T> result) {
    if (!result) {
        throw std::runtime_error(std::string(error_code_name(result.error().code)) + ": " + result.error().message);
    }
    return std::move(result).value();
}
inline void check(Status status) {
    get(std::move(status));
}

/// Records what a monitor is told, and stops the work at the given tick.
struct Ticks {
    std::vector<double> fractions;
    std::size_t stop_at = static_cast<std::size_t>(-1);
    Monitor monitor() {
        return {[](void* user, double fraction) {
                    auto& ticks = *static_cast<Ticks*>(user);
                    ticks.fractions.push_back(fraction);
                    return ticks.fractions.size() < ticks.stop_at;
                },
                this};
    }
    bool rise() const {
        return !fractions.empty() && std::is_sorted(fractions.begin(), fractions.end()) && fractions.front() >= 0 &&
               fractions.back() <= 1;
    }
};

struct Specimen {
    std::string name;
    PolygonMesh mesh;
};

/// Meshes of up to 512 vertices for property tests: regular and noisy, open and closed, planar and not, convex and
/// concave, and the odd ones that polylap accepts. No face has two different best triangulations of the same rank, so
/// that every rule has one answer.
const std::vector<Specimen>& zoo();
const PolygonMesh& specimen(const std::string& name);
/// Those whose edges have at most two faces, of like orientation.
std::vector<Specimen> oriented_zoo();

PolygonMesh make_mesh(const std::vector<Vector3>& points, const std::vector<std::vector<Index>>& faces);
/// One face with the given corners.
PolygonMesh make_face(const std::vector<Vector3>& corners);
std::vector<Vector3> regular_polygon(int n);
/// A mesh of tests/data/meshes.
PolygonMesh load_mesh(const std::string& name);
std::vector<std::byte> read_bytes(const std::string& path_in_data);

bool only_triangles(const PolygonMesh& mesh);
/// Largest distance of a corner from its face's plane, over the square root of the face's area.
double non_planarity(const PolygonMesh& mesh);
inline bool planar_faces(const PolygonMesh& mesh) {
    return non_planarity(mesh) < 1e-12;
}
/// Inner vertices all of whose faces lie in one plane and face the same way.
std::vector<Index> flat_inner_vertices(const PolygonMesh& mesh);
double bounding_size(const PolygonMesh& mesh);
/// Σ |a_f|, length².
double total_area(const PolygonMesh& mesh);

/// Whether a claim speaks for a mesh, whatever the parameters.
bool claimed(Claim claim, const PolygonMesh& mesh);

/// Each operator of the table with its initial values, and with one parameter at a time at each of its choices or at
/// several values.
std::vector<OperatorSpec> all_specs();
/// The same, and each operator that takes weights of vertices also with seeded random ones of the size of squared edge
/// lengths.
std::vector<OperatorSpec> all_specs(const PolygonMesh& mesh);
/// V numbers, uniform within ± the mean squared edge length.
std::vector<double> random_weights(const PolygonMesh& mesh, std::uint32_t seed);
std::string spec_name(const OperatorSpec& spec);

}  // namespace polylap::test

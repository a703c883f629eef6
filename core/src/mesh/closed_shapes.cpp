#include <cmath>
#include <numbers>
#include <unordered_map>

#include <Eigen/Geometry>

#include "mesh/shape_builder.hpp"
#include "polylap/mesh/convert.hpp"
#include "polylap/mesh/topology.hpp"

// Spheres of radius 1 and the cube: closed, their faces looking outwards.

namespace polylap {
namespace {

constexpr double pi = std::numbers::pi;

Result<PolygonMesh> uv_sphere(std::span<const double> p) {
    const Index nu = count_of(p[0]);
    const Index nv = count_of(p[1]);
    return guard_memory([&]() -> Result<PolygonMesh> {
        MeshBuilder mesh;
        const Index south = mesh.vertex({0, 0, -1});
        for (Index j = 1; j < nv; ++j) {
            const double latitude = pi * j / nv - pi / 2;
            for (Index i = 0; i < nu; ++i) {
                const double u = 2 * pi * i / nu;
                mesh.vertex({std::cos(latitude) * std::cos(u), std::cos(latitude) * std::sin(u), std::sin(latitude)});
            }
        }
        const Index north = mesh.vertex({0, 0, 1});
        const auto ring = [&](Index j, Index i) { return 1 + (j - 1) * nu + i % nu; };
        for (Index i = 0; i < nu; ++i) {
            mesh.face({south, ring(1, i + 1), ring(1, i)});
        }
        for (Index j = 1; j + 1 < nv; ++j) {
            for (Index i = 0; i < nu; ++i) {
                mesh.face({ring(j, i), ring(j, i + 1), ring(j + 1, i + 1), ring(j + 1, i)});
            }
        }
        for (Index i = 0; i < nu; ++i) {
            mesh.face({ring(nv - 1, i), ring(nv - 1, i + 1), north});
        }
        return std::move(mesh).finish();
    });
}

/// Each triangle becomes four; the new vertices are at the middles of the edges, on the sphere.
MeshBuilder quarter(const MeshBuilder& coarse) {
    MeshBuilder fine;
    fine.points = coarse.points;
    std::unordered_map<std::int64_t, Index> middles;
    middles.reserve(coarse.corners.size() / 2);
    const auto middle = [&](Index a, Index b) {
        const auto [low, high] = std::minmax(a, b);
        const auto [at, fresh] = middles.try_emplace((static_cast<std::int64_t>(low) << 32) | high, 0);
        if (fresh) {
            const Vector3 sum =
                fine.points[static_cast<std::size_t>(low)] + fine.points[static_cast<std::size_t>(high)];
            at->second = fine.vertex(sum.normalized());
        }
        return at->second;
    };
    for (std::size_t k = 0; k < coarse.corners.size(); k += 3) {
        const Index a = coarse.corners[k];
        const Index b = coarse.corners[k + 1];
        const Index c = coarse.corners[k + 2];
        const Index ab = middle(a, b);
        const Index bc = middle(b, c);
        const Index ca = middle(c, a);
        fine.face({a, ab, ca});
        fine.face({b, bc, ab});
        fine.face({c, ca, bc});
        fine.face({ab, bc, ca});
    }
    return fine;
}

Result<PolygonMesh> ico_sphere(std::span<const double> p) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        const double t = std::numbers::phi;
        MeshBuilder mesh;
        for (const Vector3& v : {Vector3(-1, t, 0), Vector3(1, t, 0), Vector3(-1, -t, 0), Vector3(1, -t, 0),
                                 Vector3(0, -1, t), Vector3(0, 1, t), Vector3(0, -1, -t), Vector3(0, 1, -t),
                                 Vector3(t, 0, -1), Vector3(t, 0, 1), Vector3(-t, 0, -1), Vector3(-t, 0, 1)}) {
            mesh.vertex(v.normalized());
        }
        for (const std::array<Index, 3>& f : {std::array<Index, 3>{0, 11, 5},
                                              {0, 5, 1},
                                              {0, 1, 7},
                                              {0, 7, 10},
                                              {0, 10, 11},
                                              {1, 5, 9},
                                              {5, 11, 4},
                                              {11, 10, 2},
                                              {10, 7, 6},
                                              {7, 1, 8},
                                              {3, 9, 4},
                                              {3, 4, 2},
                                              {3, 2, 6},
                                              {3, 6, 8},
                                              {3, 8, 9},
                                              {4, 9, 5},
                                              {2, 4, 11},
                                              {6, 2, 10},
                                              {8, 6, 7},
                                              {9, 8, 1}}) {
            mesh.face(f);
        }
        for (Index level = count_of(p[0]); level > 0; --level) {
            mesh = quarter(mesh);
        }
        return std::move(mesh).finish();
    });
}

/// The corner at which the planes that touch the sphere at a, b and c meet.
Vector3 pole_of(const Vector3& a, const Vector3& b, const Vector3& c) {
    const Vector3 across = (b - a).cross(c - a);
    return across / across.dot(a);
}

Result<PolygonMesh> hexagon_sphere(std::span<const double> p) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        auto triangles = ico_sphere(p.first(1));
        if (!triangles) return triangles;
        auto dual = dual_mesh(*triangles);
        if (!dual) return dual;
        Points positions = dual->positions();  // vertex f is at the middle of triangle f
        for (Index f = 0; f < triangles->face_count(); ++f) {
            const auto corners = triangles->face(f);
            const Vector3 pole = pole_of(triangles->position(corners[0]), triangles->position(corners[1]),
                                         triangles->position(corners[2]));
            positions.row(f) = p[1] == 0 ? positions.row(f).normalized().eval() : pole.transpose().eval();
        }
        return dual->with_positions(std::move(positions));
    });
}

/// The surface of the lattice {0 … n}³, its vertices where `place` puts them.
template <class Place>
Result<PolygonMesh> cube_of(Index n, Place&& place) {
    return guard_memory([&]() -> Result<PolygonMesh> {
        MeshBuilder mesh;
        std::unordered_map<std::int64_t, Index> vertices;
        const auto vertex = [&](const std::array<Index, 3>& at) {
            const std::int64_t key = (std::int64_t{at[0]} * (n + 1) + at[1]) * (n + 1) + at[2];
            const auto [found, fresh] = vertices.try_emplace(key, 0);
            if (fresh) found->second = mesh.vertex(place(at));
            return found->second;
        };
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const Index side : {Index{0}, n}) {
                for (Index i = 0; i < n; ++i) {
                    for (Index j = 0; j < n; ++j) {
                        const auto corner = [&](Index u, Index v) {
                            std::array<Index, 3> at{};
                            at[axis] = side;
                            at[(axis + 1) % 3] = u;
                            at[(axis + 2) % 3] = v;
                            return vertex(at);
                        };
                        const Index a = corner(i, j);
                        const Index b = corner(i + 1, j);
                        const Index c = corner(i + 1, j + 1);
                        const Index d = corner(i, j + 1);
                        if (side == 0) {
                            mesh.face({a, d, c, b});
                        } else {
                            mesh.face({a, b, c, d});
                        }
                    }
                }
            }
        }
        return std::move(mesh).finish();
    });
}

Result<PolygonMesh> cube(std::span<const double> p) {
    const Index n = count_of(p[0]);
    return cube_of(n, [&](const std::array<Index, 3>& at) {
        return Vector3(static_cast<double>(at[0]) / n, static_cast<double>(at[1]) / n, static_cast<double>(at[2]) / n);
    });
}

Result<PolygonMesh> cube_sphere(std::span<const double> p) {
    const Index n = count_of(p[0]);
    // Equal angles rather than equal lengths, so that the quads near the corners are not much smaller than the others.
    const auto angle = [n](Index k) { return 2 * k == n ? 0 : std::tan(pi / 4 * (2.0 * k / n - 1)); };
    return cube_of(n, [&](const std::array<Index, 3>& at) {
        return Vector3(angle(at[0]), angle(at[1]), angle(at[2])).normalized();
    });
}

constexpr const char* hexagon_kinds[] = {"on-sphere", "flat"};

constexpr std::array uv_parameters{
    count_parameter("nu", "meridians", 3, 2000, 128, 32),
    count_parameter("nv", "bands", 2, 2000, 64, 16, "from pole to pole"),
};
constexpr std::array ico_parameters{
    count_parameter("level", "level", 0, 8, 5, 3, "how often each triangle is cut into four"),
};
constexpr std::array hexagon_parameters{
    count_parameter("level", "level", 0, 8, 5, 3, "0 is the dodecahedron"),
    choice_parameter("kind", "vertices", hexagon_kinds, "on the sphere, or where all faces are flat and touch it"),
};
constexpr std::array cube_parameters{
    count_parameter("n", "quads an edge", 1, 500, 32, 8),
};

}  // namespace

const ShapeInfo uv_sphere_shape{"uv-sphere", "Sphere of meridians", "Planar quads, and triangles around both poles.",
                                uv_parameters, uv_sphere};
const ShapeInfo ico_sphere_shape{"ico-sphere", "Sphere of triangles",
                                 "An icosahedron whose triangles are cut into four again and again.", ico_parameters,
                                 ico_sphere};
const ShapeInfo hexagon_sphere_shape{"hexagon-sphere", "Sphere of hexagons",
                                     "The dual of the sphere of triangles: twelve pentagons among hexagons.",
                                     hexagon_parameters, hexagon_sphere};
const ShapeInfo cube_shape{"cube", "Cube", "Squares on the sides of a cube of edge 1.", cube_parameters, cube};
const ShapeInfo cube_sphere_shape{"cube-sphere", "Sphere of quads", "A cube of n × n quads a side, blown up to a ball.",
                                  cube_parameters, cube_sphere};

}  // namespace polylap

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>

#include "polylap/face/triangulate_mesh.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;
using Triangles = std::vector<Triangle>;

constexpr TriangulationRule rules[] = {TriangulationRule::delaunay, TriangulationRule::min_max_angle,
                                       TriangulationRule::shortest_diagonal, TriangulationRule::fan};

double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

/// Each from its lowest corner on, and in order: as sets.
Triangles canonical(Triangles triangles) {
    for (Triangle& t : triangles) {
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

Triangles cut(const Polygon& p, TriangulationRule rule) {
    Triangles triangles;
    check(triangulate_polygon(p, rule, triangles));
    return canonical(std::move(triangles));
}

Triangles cut(const PolygonMesh& mesh, TriangulationRule rule) {
    const PolygonMesh triangulated = get(triangulate_mesh(mesh, rule));
    Triangles triangles;
    for (Index f = 0; f < triangulated.face_count(); ++f) {
        const auto face = triangulated.face(f);
        triangles.push_back({face[0], face[1], face[2]});
    }
    return canonical(std::move(triangles));
}

Triangles fan(Index first, Index n) {
    Triangles triangles;
    for (Index k = 1; k + 1 < n; ++k) {
        triangles.push_back({first, first + k, first + k + 1});
    }
    return triangles;
}

Polygon on_a_circle(const std::vector<double>& angles) {
    Polygon p;
    for (const double t : angles) {
        p.emplace_back(std::cos(t), std::sin(t));
    }
    return p;
}

/// Turned and moved in space, by up to its size.
PolygonMesh moved(const PolygonMesh& mesh, std::mt19937& random) {
    const auto vector = [&](double size) {
        return Vector3(uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size));
    };
    const Eigen::AngleAxisd turn(uniform(random, 0, 2 * std::numbers::pi), vector(1).normalized());
    const Vector3 shift = vector(bounding_size(mesh));
    Points positions = mesh.positions();
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        positions.row(v) = (turn * mesh.position(v) + shift).transpose();
    }
    return get(mesh.with_positions(positions));
}

TEST(Ties, ARegularPolygonIsCutFromItsFirstCorner) {
    for (int n = 4; n <= 40; ++n) {
        std::vector<double> angles;
        for (int k = 0; k < n; ++k) {
            angles.push_back(2 * std::numbers::pi * k / n);
        }
        EXPECT_EQ(cut(on_a_circle(angles), TriangulationRule::delaunay), fan(0, n)) << n;
    }
}

TEST(Ties, SoAreCornersOnACircleWherever) {
    std::mt19937 random(4);
    for (int n = 4; n <= 40; ++n) {
        std::vector<double> angles;
        for (int k = 0; k < n; ++k) {
            angles.push_back(2 * std::numbers::pi * (k + uniform(random, 0.1, 0.9)) / n);
        }
        EXPECT_EQ(cut(on_a_circle(angles), TriangulationRule::delaunay), fan(0, n)) << n;
    }
}

// 0, 1, 2 and 3 lie on the unit circle about (1, 0), and no other corner within.
TEST(Ties, ACircleWithinIsCutFromItsLowestCorner) {
    const double root = std::sqrt(3.0) / 2;
    const Polygon p{{0, 0}, {1.5, -root}, {2, 0}, {1.5, root}, {0.5, 2.5}, {0.2, 2.6}};
    Triangles expected = fan(0, 4);
    const Triangles triangles = cut(p, TriangulationRule::delaunay);
    for (const Triangle& t : expected) {
        EXPECT_TRUE(std::binary_search(triangles.begin(), triangles.end(), t)) << t[0] << t[1] << t[2];
    }
    // With the far corners first, the circle's lowest corner is another one, and no longer the polygon's.
    Polygon turned = p;
    std::rotate(turned.begin(), turned.begin() + 4, turned.end());
    const Triangles others = cut(turned, TriangulationRule::delaunay);
    expected = fan(2, 4);
    for (const Triangle& t : expected) {
        EXPECT_TRUE(std::binary_search(others.begin(), others.end(), t)) << t[0] << t[1] << t[2];
    }
}

TEST(Ties, EndWhereTheDifferenceIsMoreThanRounding) {
    for (const double off : {1e-9, 1e-6, 1e-3}) {
        const Triangles from1{{0, 1, 3}, {1, 2, 3}};
        EXPECT_EQ(cut(Polygon{{0, 0}, {1, 0}, {1 + off, 1 + off}, {0, 1}}, TriangulationRule::delaunay), from1);
        EXPECT_EQ(cut(Polygon{{0, 0}, {1, 0}, {1 - off, 1 - off}, {0, 1}}, TriangulationRule::delaunay), fan(0, 4));
        EXPECT_EQ(cut(Polygon{{0, 0}, {1, 0}, {1 + off, 1 + off}, {0, 1}}, TriangulationRule::shortest_diagonal),
                  from1);
        EXPECT_EQ(cut(Polygon{{0, 0}, {1, 0}, {1 + off, 1 + off}, {0, 1}, {-1, 0.5}}, TriangulationRule::delaunay),
                  (Triangles{{0, 1, 3}, {0, 3, 4}, {1, 2, 3}}));
    }
}

TEST(Ties, RoundingDecidesNothing) {
    std::mt19937 random(8);
    for (int n = 4; n <= 12; ++n) {
        Polygon p;
        for (const Vector3& x : regular_polygon(n)) {
            p.emplace_back(x.head<2>());
        }
        for (const TriangulationRule rule : rules) {
            const Triangles triangles = cut(p, rule);
            for (int k = 0; k < 50; ++k) {
                Polygon q = p;
                for (auto& x : q) {
                    x += 2e-14 * Eigen::Vector2d(uniform(random, -1, 1), uniform(random, -1, 1));
                }
                EXPECT_EQ(cut(q, rule), triangles) << n << ", rule " << static_cast<int>(rule);
            }
        }
    }
}

TEST(Ties, MovingTheMeshInSpaceChangesNoDiagonal) {
    std::mt19937 random(6);
    std::vector<Specimen> meshes;
    for (int n = 4; n <= 12; ++n) {
        meshes.push_back({"regular-" + std::to_string(n), make_face(regular_polygon(n))});
    }
    for (const char* name :
         {"hexagon-sphere-2", "saddle-12x12", "saddle-7", "quad-torus-32x16", "torus-9x5", "grid-8x8-skew", "cube-3"}) {
        meshes.push_back({name, specimen(name)});
    }
    for (const auto& [name, mesh] : meshes) {
        for (const TriangulationRule rule : rules) {
            const Triangles triangles = cut(mesh, rule);
            for (int k = 0; k < 20; ++k) {
                EXPECT_EQ(cut(moved(mesh, random), rule), triangles) << name << ", rule " << static_cast<int>(rule);
            }
        }
    }
}

}  // namespace
}  // namespace polylap::test

#include "polylap/face/triangulate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "naive.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using naive::Polygon;

constexpr TriangulationRule rules[] = {TriangulationRule::delaunay, TriangulationRule::min_max_angle,
                                       TriangulationRule::shortest_diagonal, TriangulationRule::fan};
constexpr TriangulationRule always[] = {TriangulationRule::delaunay, TriangulationRule::min_max_angle,
                                        TriangulationRule::shortest_diagonal};

double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

/// Corners on a grid fine enough that no three are in line by chance and coarse enough that midpoints are exact.
Polygon snapped(Polygon p) {
    for (auto& q : p) {
        q = (q * 0x1p24).array().round() * 0x1p-24;
    }
    return p;
}

/// Star-shaped about 0, with or without concave corners.
Polygon random_star(std::mt19937& random, int n) {
    std::vector<double> angles;
    for (int k = 0; k < n; ++k) {
        angles.push_back(2 * std::numbers::pi * (k + uniform(random, 0.1, 0.9)) / n);
    }
    Polygon p;
    for (const double t : angles) {
        p.emplace_back(uniform(random, 0.3, 1) * Eigen::Vector2d(std::cos(t), std::sin(t)));
    }
    return snapped(p);
}

/// A band that winds inwards: no corner sees far.
Polygon spiral(int half) {
    Polygon p;
    const auto at = [&](int k, double width) {
        const double t = 0.35 * k;
        return Eigen::Vector2d(Eigen::Vector2d(std::cos(t), std::sin(t)) *
                               (4 - 0.045 * k - width + 0.002 * std::sin(7.0 * k)));
    };
    for (int k = 0; k < half; ++k) {
        p.push_back(at(k, 0));
    }
    for (int k = half - 1; k >= 0; --k) {
        p.push_back(at(k, 0.35));
    }
    return snapped(p);
}

/// With a straight corner in the middle of every third edge.
Polygon with_straight_corners(const Polygon& p) {
    Polygon longer;
    for (std::size_t k = 0; k < p.size(); ++k) {
        longer.push_back(p[k]);
        if (k % 3 == 0) longer.emplace_back((p[k] + p[(k + 1) % p.size()]) / 2);
    }
    return longer;
}

Polygon flat(const std::vector<Vector3>& p) {
    Polygon q;
    for (const Vector3& x : p) {
        q.emplace_back(x.head<2>());
    }
    return q;
}

std::vector<Triangle> cut(const Polygon& p, TriangulationRule rule) {
    std::vector<Triangle> triangles{{9, 9, 9}};  // must be overwritten
    check(triangulate_polygon(p, rule, triangles));
    return triangles;
}

/// n-2 triangles of positive area whose sides are the edges, once each, and diagonals, once each way, and whose areas
/// sum to the polygon's: together that leaves no room for overlap, gaps or diagonals outside.
void expect_valid(const Polygon& p, const std::vector<Triangle>& triangles, const std::string& what) {
    const auto n = static_cast<Index>(p.size());
    ASSERT_EQ(triangles.size(), p.size() - 2) << what;
    std::map<std::pair<Index, Index>, int> sides;
    double sum = 0;
    const double whole = naive::area(p);
    for (const Triangle& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_GE(t[k], 0) << what;
            ASSERT_LT(t[k], n) << what;
            ++sides[{t[k], t[(k + 1) % 3]}];
        }
        const double twice = naive::cross(naive::at(p, t[0]), naive::at(p, t[1]), naive::at(p, t[2]));
        EXPECT_GT(twice, 1e-13 * whole) << what << ": a triangle without area or clockwise";
        sum += twice / 2;
    }
    EXPECT_NEAR(sum, whole, 1e-12 * whole) << what;
    for (const auto& [side, count] : sides) {
        EXPECT_EQ(count, 1) << what;
        const bool edge = (side.first + 1) % n == side.second;
        EXPECT_EQ(sides.count({side.second, side.first}), edge ? 0u : 1u)
            << what << ": side " << side.first << "–" << side.second;
    }
}

std::vector<std::pair<std::string, Polygon>> polygons() {
    std::mt19937 random(2024);
    std::vector<std::pair<std::string, Polygon>> all;
    for (int k = 0; k < 60; ++k) {
        const int n = 3 + k % 20;
        const Polygon p = random_star(random, n);
        all.emplace_back("star " + std::to_string(k), p);
        all.emplace_back("star with straight corners " + std::to_string(k), with_straight_corners(p));
    }
    for (const int half : {3, 8, 20, 40}) {
        all.emplace_back("spiral " + std::to_string(half), spiral(half));
        all.emplace_back("spiral with straight corners " + std::to_string(half), with_straight_corners(spiral(half)));
    }
    for (const auto& [name, mesh] : zoo()) {
        if (mesh.face_count() > 1) continue;
        Polygon p;
        for (const Index v : mesh.face(0)) {
            p.emplace_back(mesh.position(v).head<2>());
        }
        all.emplace_back(name, p);
    }
    all.emplace_back("triangle with straight corners",
                     Polygon{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {2, 2}, {1, 4}, {0.5, 2}});
    all.emplace_back("all on one side", Polygon{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {2, 1}});
    return all;
}

/// The first corner from which all others make counter-clockwise triangles; -1 if there is none.
Index first_all_seeing(const Polygon& p) {
    const auto n = static_cast<Index>(p.size());
    for (Index c = 0; c < n; ++c) {
        bool sees = true;
        for (Index k = 1; k + 1 < n && sees; ++k) {
            sees = naive::cross(naive::at(p, c), naive::at(p, (c + k) % n), naive::at(p, (c + k + 1) % n)) > 1e-14;
        }
        if (sees) return c;
    }
    return -1;
}

TEST(Triangulate, EveryRuleFillsThePolygon) {
    for (const auto& [name, p] : polygons()) {
        for (const TriangulationRule rule : always) {
            expect_valid(p, cut(p, rule), name + ", rule " + std::to_string(static_cast<int>(rule)));
        }
    }
}

// Corners that were straight before the face was turned in space are straight up to rounding: no triangle may live on
// that rounding.
TEST(Triangulate, StraightCornersUpToRounding) {
    for (const auto& [name, p] : polygons()) {
        if (name.find("straight") == std::string::npos && name.find("all on one side") == std::string::npos) continue;
        for (const double turn : {0.3, 1.1, 2.5}) {
            Polygon q;
            for (const auto& x : p) {
                q.emplace_back(std::cos(turn) * x.x() - std::sin(turn) * x.y(),
                               std::sin(turn) * x.x() + std::cos(turn) * x.y());
            }
            for (const TriangulationRule rule : rules) {
                std::vector<Triangle> triangles;
                if (!triangulate_polygon(q, rule, triangles).ok()) {
                    EXPECT_EQ(rule, TriangulationRule::fan) << name;
                    continue;
                }
                for (const Triangle& t : triangles) {
                    EXPECT_GT(naive::cross(naive::at(q, t[0]), naive::at(q, t[1]), naive::at(q, t[2])), 1e-9) << name;
                }
            }
        }
    }
}

TEST(Triangulate, FanHasItsFirstAllSeeingCorner) {
    int fans = 0;
    int refusals = 0;
    for (const auto& [name, p] : polygons()) {
        const Index apex = first_all_seeing(p);
        std::vector<Triangle> triangles;
        const Status status = triangulate_polygon(p, TriangulationRule::fan, triangles);
        ASSERT_EQ(status.ok(), apex >= 0) << name;
        if (apex < 0) {
            ++refusals;
            EXPECT_EQ(status.error().code, ErrorCode::degenerate_face);
            EXPECT_EQ(status.error().element, -1);
            EXPECT_FALSE(status.error().message.empty());
            continue;
        }
        ++fans;
        expect_valid(p, triangles, name);
        for (const Triangle& t : triangles) {
            EXPECT_NE(std::find(t.begin(), t.end(), apex), t.end()) << name;
        }
    }
    EXPECT_GT(fans, 20);
    EXPECT_GT(refusals, 20);
}

TEST(Triangulate, DelaunayDiagonalsHaveNoNegativeWeight) {
    for (const auto& [name, p] : polygons()) {
        const auto triangles = cut(p, TriangulationRule::delaunay);
        const Matrix s = naive::cotan(p, triangles);
        const auto n = static_cast<Index>(p.size());
        for (Index i = 0; i < n; ++i) {
            for (Index j = i + 2; j < n; ++j) {
                if (i == 0 && j == n - 1) continue;
                EXPECT_LE(s(i, j), 1e-12 * s.diagonal().maxCoeff()) << name << ": " << i << "–" << j;
            }
        }
    }
}

/// Polygons small enough to look at all their triangulations.
template <class Check>
void for_small_polygons(Check&& check) {
    std::mt19937 random(77);
    int tried = 0;
    for (int k = 0; k < 150; ++k) {
        const Polygon p = random_star(random, 4 + k % 5);
        const auto all = naive::triangulations(p);
        ASSERT_FALSE(all.empty());
        tried += all.size() > 1 ? 1 : 0;
        check(p, all);
    }
    EXPECT_GT(tried, 80);
}

// Rippa 1990: among all triangulations, the (constrained) Delaunay one has the least Dirichlet energy for every
// function, so the least trace.
TEST(Triangulate, DelaunayHasTheLeastDirichletEnergy) {
    for_small_polygons([](const Polygon& p, const std::vector<naive::Triangulation>& all) {
        const Matrix s = naive::cotan(p, cut(p, TriangulationRule::delaunay));
        for (const auto& other : all) {
            const Matrix t = naive::cotan(p, other);
            EXPECT_LE(s.trace(), t.trace() * (1 + 1e-12));
            const Vector u = Vector::LinSpaced(t.rows(), 0, 5).array().sin();
            EXPECT_LE(u.dot(s * u), u.dot(t * u) + 1e-12 * t.trace());
        }
    });
}

TEST(Triangulate, MinMaxAngleHasTheLeastSortedAngles) {
    for_small_polygons([](const Polygon& p, const std::vector<naive::Triangulation>& all) {
        const auto angles = naive::sorted_angles(p, cut(p, TriangulationRule::min_max_angle));
        for (const auto& other : all) {
            EXPECT_FALSE(naive::angles_less(naive::sorted_angles(p, other), angles));
        }
    });
}

TEST(Triangulate, MinMaxAngleBreaksTiesByTheNextAngle) {
    // The triangle at corner 0 cannot be avoided and has the largest angle; the cut of the rest is decided by the
    // angles after it.
    std::mt19937 random(5);
    for (int k = 0; k < 60; ++k) {
        Polygon p{{-3, 0}, {0, -0.4}, {3, 0}};
        for (const double x : {2.2, 1.0, -1.1, -2.3}) {
            p.emplace_back(x + uniform(random, -0.3, 0.3), uniform(random, 0.8, 2.5));
        }
        p = snapped(p);
        const auto all = naive::triangulations(p);
        auto best = naive::sorted_angles(p, all.front());
        for (const auto& other : all) {
            const auto angles = naive::sorted_angles(p, other);
            if (naive::angles_less(angles, best)) best = angles;
        }
        const auto angles = naive::sorted_angles(p, cut(p, TriangulationRule::min_max_angle));
        EXPECT_FALSE(naive::angles_less(best, angles)) << k;
    }
}

TEST(Triangulate, ShortestDiagonalIsGreedy) {
    for_small_polygons([](const Polygon& p, const std::vector<naive::Triangulation>&) {
        const auto n = static_cast<Index>(p.size());
        std::vector<std::tuple<double, Index, Index>> candidates;
        for (Index i = 0; i < n; ++i) {
            for (Index j = i + 2; j < n; ++j) {
                if (naive::is_inside_diagonal(p, i, j))
                    candidates.emplace_back((naive::at(p, i) - naive::at(p, j)).norm(), i, j);
            }
        }
        std::sort(candidates.begin(), candidates.end());
        std::vector<std::pair<Index, Index>> greedy;
        for (const auto& [length, i, j] : candidates) {
            const bool crosses = std::any_of(greedy.begin(), greedy.end(), [&, i = i, j = j](const auto& d) {
                return naive::cross_properly(naive::at(p, i), naive::at(p, j), naive::at(p, d.first),
                                             naive::at(p, d.second));
            });
            if (!crosses) greedy.emplace_back(i, j);
        }
        std::sort(greedy.begin(), greedy.end());

        std::vector<std::pair<Index, Index>> diagonals;
        for (const Triangle& t : cut(p, TriangulationRule::shortest_diagonal)) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Index i = t[k];
                const Index j = t[(k + 1) % 3];
                if (i < j && j != i + 1 && !(i == 0 && j == n - 1)) diagonals.emplace_back(i, j);
            }
        }
        std::sort(diagonals.begin(), diagonals.end());
        EXPECT_EQ(diagonals, greedy);
    });
}

TEST(Triangulate, TheStartCornerDoesNotMatter) {
    std::mt19937 random(9);
    for (const int n : {4, 5, 7, 12, 17}) {
        const Polygon p = random_star(random, n);
        for (const TriangulationRule rule : always) {
            const Matrix s = naive::cotan(p, cut(p, rule));
            for (int shift = 1; shift < n; ++shift) {
                Polygon q = p;
                std::rotate(q.begin(), q.begin() + shift, q.end());
                const Matrix t = naive::cotan(q, cut(q, rule));
                for (Index i = 0; i < n; ++i) {
                    for (Index j = 0; j < n; ++j) {
                        EXPECT_NEAR(t(i, j), s((i + shift) % n, (j + shift) % n), 1e-11 * s.diagonal().maxCoeff());
                    }
                }
            }
        }
    }
}

TEST(Triangulate, LargePolygons) {
    for (const int n : {64, 65, 150, 1000}) {
        const Polygon p = flat(regular_polygon(n));
        for (const TriangulationRule rule : rules) {
            if (n > 150 && (rule == TriangulationRule::min_max_angle || rule == TriangulationRule::shortest_diagonal))
                continue;  // O(n³)
            std::vector<Triangle> triangles;
            check(triangulate_polygon(p, rule, triangles));
            ASSERT_EQ(triangles.size(), p.size() - 2);
            double sum = 0;
            for (const Triangle& t : triangles) {
                const double twice = naive::cross(naive::at(p, t[0]), naive::at(p, t[1]), naive::at(p, t[2]));
                EXPECT_GT(twice, 0);
                sum += twice / 2;
            }
            EXPECT_NEAR(sum, naive::area(p), 1e-12);
        }
    }
    std::mt19937 random(3);
    const Polygon ragged = random_star(random, 300);
    expect_valid(ragged, cut(ragged, TriangulationRule::delaunay), "300 corners");
}

TEST(Triangulate, SizeAndPlaceDoNotMatter) {
    std::mt19937 random(31);
    const Polygon p = random_star(random, 11);
    for (const TriangulationRule rule : always) {
        const auto triangles = cut(p, rule);
        for (const double scale : {1e-60, 1e-6, 1e6, 1e60}) {
            Polygon q = p;
            for (auto& x : q) {
                x *= scale;
            }
            EXPECT_EQ(cut(q, rule), triangles) << scale;
        }
    }
}

TEST(Triangulate, RefusesWhatIsNoSimplePolygon) {
    const std::pair<const char*, Polygon> bad[] = {
        {"crossing quad with area left", {{0, 0}, {4, 0}, {1, 1}, {3, 1.5}}},
        {"crossing quad without area", {{0, 0}, {1, 1}, {1, 0}, {0, 1}}},
        {"pentagram", {{1, 0}, {-0.809, 0.588}, {0.309, -0.951}, {0.309, 0.951}, {-0.809, -0.588}}},
        {"crossing pentagon", {{0, 0}, {3, 0}, {3, 3}, {1, -1}, {0, 3}}},
        {"all in one line", {{0, 0}, {1, 0}, {3, 0}, {2, 0}}},
        {"flat triangle", {{0, 0}, {1, 1}, {2, 2}}},
        {"one point", {{1, 1}, {1, 1}, {1, 1}, {1, 1}}},
        {"a corner on another", {{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}},
        {"a corner on an edge", {{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}}},
        {"a spike", {{0, 0}, {3, 0}, {2, 0}, {2, 2}, {0, 2}}},
        {"clockwise", {{0, 0}, {0, 1}, {1, 1}, {1, 0}}},
    };
    for (const auto& [name, p] : bad) {
        for (const TriangulationRule rule : rules) {
            std::vector<Triangle> triangles;
            const Status status = triangulate_polygon(p, rule, triangles);
            ASSERT_FALSE(status.ok()) << name << ", rule " << static_cast<int>(rule);
            EXPECT_EQ(status.error().code, ErrorCode::degenerate_face) << name;
            EXPECT_EQ(status.error().element, -1) << name;
            EXPECT_FALSE(status.error().message.empty()) << name;
        }
    }
}

}  // namespace
}  // namespace polylap::test

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include <Eigen/Geometry>

#include "polylap/apply/conversions.hpp"
#include "polylap/apply/diagnostics.hpp"
#include "polylap/face/vector_area.hpp"
#include "polylap/mesh/shapes.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using Values = std::vector<double>;
using Number = std::function<double(const Values&)>;
constexpr double pi = std::numbers::pi;

/// What a shape has to be, whatever its parameters.
struct Promise {
    int euler = 1;
    bool closed = false;
    bool planar_faces = true;
    bool flat = false;      ///< All in z = 0, looking up.
    Number faces;           ///< Exact number.
    Number area = nullptr;  ///< Exact total of |a|, for flat shapes.
    Values fine = {};       ///< Parameters at which the limits below are near.
    double area_in_the_limit = 0;
    double volume_in_the_limit = 0;
};

double one_face(const Values&) {
    return 1;
}

const std::map<std::string, Promise>& promises() {
    static const std::map<std::string, Promise> all{
        {"grid",
         {.flat = true,
          .faces = [](const Values& p) { return p[0] * p[1]; },
          .area = [](const Values& p) { return p[2] * p[3]; }}},
        {"skew-grid",
         {.flat = true, .faces = [](const Values& p) { return p[0] * p[1]; }, .area = [](const Values&) { return 1; }}},
        {"saddle",
         {.planar_faces = false,
          .faces = [](const Values& p) { return p[0] * p[0]; },
          .fine = {40, 1},
          .area_in_the_limit = 1.861564 /* ∫ √(1 + 16 x² + 16 y²) over [-½, ½]² */}},
        {"torus",
         {.euler = 0,
          .closed = true,
          .faces = [](const Values& p) { return p[0] * p[1]; },
          .fine = {200, 100, 2, 0.5},
          .area_in_the_limit = 4 * pi * pi * 2 * 0.5,
          .volume_in_the_limit = 2 * pi * pi * 2 * 0.25}},
        {"uv-sphere",
         {.euler = 2,
          .closed = true,
          .faces = [](const Values& p) { return p[0] * p[1]; },
          .fine = {160, 80},
          .area_in_the_limit = 4 * pi,
          .volume_in_the_limit = 4 * pi / 3}},
        {"ico-sphere",
         {.euler = 2,
          .closed = true,
          .faces = [](const Values& p) { return 20 * std::pow(4, p[0]); },
          .fine = {5},
          .area_in_the_limit = 4 * pi,
          .volume_in_the_limit = 4 * pi / 3}},
        {"hexagon-sphere",
         {.euler = 2,
          .closed = true,
          .planar_faces = false,
          .faces = [](const Values& p) { return 10 * std::pow(4, p[0]) + 2; },
          .fine = {5, 1},
          .area_in_the_limit = 4 * pi,
          .volume_in_the_limit = 4 * pi / 3}},
        {"cube",
         {.euler = 2,
          .closed = true,
          .faces = [](const Values& p) { return 6 * p[0] * p[0]; },
          .fine = {3},
          .area_in_the_limit = 6,
          .volume_in_the_limit = 1}},
        {"cube-sphere",
         {.euler = 2,
          .closed = true,
          .planar_faces = false,
          .faces = [](const Values& p) { return 6 * p[0] * p[0]; },
          .fine = {60},
          .area_in_the_limit = 4 * pi,
          .volume_in_the_limit = 4 * pi / 3}},
        {"cylinder",
         {.euler = 0,
          .faces = [](const Values& p) { return p[0] * p[1]; },
          .fine = {200, 3, 0.5, 2},
          .area_in_the_limit = 2 * pi}},
        {"disc",
         {.flat = true,
          .faces = [](const Values& p) { return p[0] * p[1] + 1; },
          .area = [](const Values& p) { return p[0] / 2 * std::sin(2 * pi / p[0]); }}},
        {"concave-hexagons",
         {.flat = true,
          .faces = [](const Values& p) { return p[0] * p[1]; },
          .area =
              [](const Values& p) {
                  // 1 + depth high at both ends and 1 - depth in the middle, 2 long, in units of 1 / (2 nx + 1).
                  return p[0] * p[1] * 2 / std::pow(2 * p[0] + 1, 2);
              }}},
        {"voronoi",
         {.flat = true,
          .faces = [](const Values& p) { return p[0] * p[1]; },
          .area = [](const Values& p) { return p[1] * std::sqrt(3.0) / 2 / p[0]; }}},
        {"l-tiles",
         {.flat = true,
          .faces = [](const Values& p) { return 2 * p[0] * p[1]; },
          .area = [](const Values& p) { return p[1] / p[0] / 2; }}},
        {"tetris",
         {.flat = true,
          .faces = [](const Values& p) { return 4 * p[0] * p[1]; },
          .area = [](const Values& p) { return p[1] / p[0]; }}},
        {"polygon",
         {.flat = true, .faces = one_face, .area = [](const Values& p) { return p[0] / 2 * std::sin(2 * pi / p[0]); }}},
        {"star",
         {.flat = true, .faces = one_face, .area = [](const Values& p) { return p[0] * p[1] * std::sin(pi / p[0]); }}},
        {"wavy-polygon", {.planar_faces = false, .faces = one_face}},
        {"trapezium", {.flat = true, .faces = one_face, .area = [](const Values&) { return 3; }}},
        {"two-components",
         {.euler = 3, .planar_faces = false, .faces = [](const Values& p) { return 7 * p[0] * p[0]; }}},
    };
    return all;
}

Values initial_values(const ShapeInfo& info) {
    Values values;
    for (const Parameter& p : info.parameters) {
        values.push_back(p.initial);
    }
    return values;
}

/// The initial values, the least ones, and the initial ones with one parameter at a time elsewhere.
std::vector<Values> samples(const ShapeInfo& info) {
    const Values initial = initial_values(info);
    std::vector<Values> all{initial, {}};
    for (const Parameter& p : info.parameters) {
        all[1].push_back(p.min);
    }
    for (std::size_t k = 0; k < info.parameters.size(); ++k) {
        const Parameter& p = info.parameters[k];
        const bool real = p.kind == Parameter::Kind::real;
        for (const double value : real ? Values{p.min, 0.37 * p.slider_max, p.slider_max}
                                       : Values{p.min, p.min + 1, p.min + 2, std::min(p.min + 5, p.slider_max)}) {
            if (value == p.initial || value > p.max) continue;
            Values values = initial;
            values[k] = value;
            all.push_back(values);
        }
    }
    return all;
}

std::string text(const ShapeInfo& info, const Values& values) {
    std::string text = info.id;
    for (const double v : values) {
        text += " " + std::to_string(v);
    }
    return text;
}

/// Calls `check` with every sample of every shape that is a mesh: a torus needs a hole.
void for_all(const std::function<void(const ShapeInfo&, const Values&, const PolygonMesh&)>& check) {
    for (const ShapeInfo* info : shapes()) {
        for (const Values& values : samples(*info)) {
            SCOPED_TRACE(text(*info, values));
            const auto mesh = info->make(values);
            if (!mesh && std::string(info->id) == "torus" && values[3] >= values[2]) {
                EXPECT_EQ(mesh.error().code, ErrorCode::bad_argument);
                continue;
            }
            ASSERT_TRUE(mesh.ok()) << mesh.error().message;
            check(*info, values, *mesh);
        }
    }
}

TEST(ShapeTable, EveryShapeIsPromisedAndEveryPromiseAShape) {
    EXPECT_EQ(shapes().size(), promises().size());
    std::set<std::string> labels;
    for (const ShapeInfo* info : shapes()) {
        EXPECT_TRUE(promises().contains(info->id)) << info->id;
        EXPECT_TRUE(labels.insert(info->label).second) << info->label;
        EXPECT_EQ(get(find_shape(info->id)), info);
        for (const Parameter& p : info->parameters) {
            SCOPED_TRACE(std::string(info->id) + " " + p.id);
            EXPECT_LE(p.min, p.initial);
            EXPECT_LE(p.initial, p.slider_max);
            EXPECT_LE(p.slider_max, p.max);
            EXPECT_GT(p.step, 0);
        }
        const auto mesh = get(make_shape(info->id));
        EXPECT_EQ(mesh.positions(), get(info->make(initial_values(*info))).positions()) << info->id;
    }
}

TEST(ShapeTable, IsManifoldAndOrientedAndHasItsEulerCharacteristic) {
    for_all([](const ShapeInfo& info, const Values& values, const PolygonMesh& mesh) {
        const Promise& promise = promises().at(info.id);
        const Topology topology = build_topology(*mesh.connectivity());
        EXPECT_TRUE(find_issues(topology).empty());
        const auto loops = boundary_loops(topology);
        ASSERT_TRUE(loops.ok()) << loops.error().message;
        EXPECT_EQ(loops->empty(), promise.closed);
        EXPECT_EQ(mesh.vertex_count() - static_cast<int>(topology.edges.size()) + mesh.face_count(), promise.euler);
        EXPECT_EQ(mesh.face_count(), promise.faces(values));
    });
}

TEST(ShapeTable, HasFacesOfPositiveAreaThatDoNotCrossThemselves) {
    for_all([](const ShapeInfo& info, const Values&, const PolygonMesh& mesh) {
        const auto triangles = triangulate_faces(mesh);
        EXPECT_TRUE(triangles.ok()) << triangles.error().message;
        if (promises().at(info.id).planar_faces) {
            EXPECT_LT(non_planarity(mesh), 1e-9);
        }
    });
}

TEST(ShapeTable, FlatShapesLookUpAndCoverTheirDomainOnce) {
    for_all([](const ShapeInfo& info, const Values& values, const PolygonMesh& mesh) {
        const Promise& promise = promises().at(info.id);
        if (!promise.flat) return;
        EXPECT_TRUE(mesh.positions().col(2).isZero(0));
        std::vector<Vector3> corners;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            gather_corners(mesh, f, corners);
            ASSERT_GT(vector_area(corners).z(), 0) << f;
        }
        const double area = promise.area(values);
        EXPECT_NEAR(total_area(mesh), area, 1e-11 * area);
    });
}

TEST(ShapeTable, HasNoVertexInsideAnEdge) {
    for_all([](const ShapeInfo&, const Values&, const PolygonMesh& mesh) {
        if (mesh.vertex_count() > 800) return;
        for (const Edge& e : build_topology(*mesh.connectivity()).edges) {
            const Vector3 a = mesh.position(e.v0);
            const Vector3 along = mesh.position(e.v1) - a;
            ASSERT_GT(along.norm(), 1e-9 * bounding_size(mesh));
            for (Index v = 0; v < mesh.vertex_count(); ++v) {
                const double t = (mesh.position(v) - a).dot(along) / along.squaredNorm();
                if (v == e.v0 || v == e.v1 || t < 0 || t > 1) continue;
                ASSERT_GT((mesh.position(v) - a - t * along).norm(), 1e-7 * along.norm()) << v;
            }
        }
    });
}

TEST(ShapeTable, ClosedShapesLookOutwards) {
    for_all([](const ShapeInfo& info, const Values&, const PolygonMesh& mesh) {
        if (!promises().at(info.id).closed) return;
        EXPECT_GT(get(enclosed_volume(mesh, build_topology(*mesh.connectivity()))), 0);
    });
}

TEST(ShapeTable, ApproachesTheSmoothSurface) {
    for (const auto& [id, promise] : promises()) {
        if (promise.area_in_the_limit == 0) continue;
        SCOPED_TRACE(id);
        const auto mesh = get(get(find_shape(id))->make(promise.fine));
        EXPECT_NEAR(total_area(mesh), promise.area_in_the_limit, 2e-3 * promise.area_in_the_limit);
        if (!promise.closed) continue;
        const double volume = get(enclosed_volume(mesh, build_topology(*mesh.connectivity())));
        EXPECT_NEAR(volume, promise.volume_in_the_limit, 2e-3 * promise.volume_in_the_limit);
    }
}

TEST(ShapeTable, VoronoiCellsAreConvexAndTheSeedDecides) {
    const auto& info = *get(find_shape("voronoi"));
    const auto make = [&](double jitter, double seed) { return get(info.make(Values{14, 9, jitter, seed})); };
    for (const double jitter : {0.0, 0.5, 1.0}) {
        for (const double seed : {0.0, 1.0, 2147483647.0}) {
            const auto mesh = make(jitter, seed);
            std::vector<Vector3> p;
            for (Index f = 0; f < mesh.face_count(); ++f) {
                gather_corners(mesh, f, p);
                for (std::size_t k = 0; k < p.size(); ++k) {
                    const Vector3 before = p[(k + 1) % p.size()] - p[k];
                    const Vector3 after = p[(k + 2) % p.size()] - p[(k + 1) % p.size()];
                    ASSERT_GE(before.cross(after).z(), -1e-15) << f;
                }
            }
        }
    }
    EXPECT_EQ(make(0.7, 3).positions(), make(0.7, 3).positions());
    const auto a = make(0.7, 3);
    const auto b = make(0.7, 4);
    EXPECT_TRUE(a.positions().rows() != b.positions().rows() || a.positions() != b.positions());
}

TEST(ShapeTable, TilesAreConcaveWithTenCorners) {
    for (const char* id : {"l-tiles", "tetris"}) {
        const auto mesh = get(make_shape(id));
        for (Index f = 0; f < mesh.face_count(); ++f) {
            ASSERT_EQ(mesh.face(f).size(), 10U) << id << " " << f;
        }
    }
}

TEST(ShapeTable, HexagonSpheresHaveTwelvePentagonsAndMayBeFlat) {
    const auto round =
        get(make_shape("hexagon-sphere", std::vector<std::pair<std::string, std::string>>{{"level", "2"}}));
    const auto flat = get(make_shape(
        "hexagon-sphere", std::vector<std::pair<std::string, std::string>>{{"level", "2"}, {"kind", "flat"}}));
    int pentagons = 0;
    for (Index f = 0; f < round.face_count(); ++f) {
        pentagons += round.face(f).size() == 5 ? 1 : 0;
    }
    EXPECT_EQ(pentagons, 12);
    EXPECT_GT(non_planarity(round), 1e-4);
    EXPECT_LT(non_planarity(flat), 1e-12);
    // Every face of the flat one touches the sphere from outside, every vertex of the round one is on it.
    EXPECT_GE(flat.positions().rowwise().norm().minCoeff(), 1);
    EXPECT_NEAR((round.positions().rowwise().norm().array() - 1).abs().maxCoeff(), 0, 1e-14);
}

TEST(ShapeTable, SpheresAreTheReferenceOnes) {
    const std::vector<std::pair<std::string, std::string>> level{{"level", "2"}};
    for (const auto& [id, name] :
         {std::pair("ico-sphere", "triangle-sphere-2"), {"hexagon-sphere", "hexagon-sphere-2"}}) {
        const auto made = get(make_shape(id, level));
        const auto& reference = specimen(name);
        ASSERT_EQ(made.vertex_count(), reference.vertex_count());
        ASSERT_EQ(made.face_count(), reference.face_count());
        for (Index v = 0; v < reference.vertex_count(); ++v) {
            const auto away = (made.positions().rowwise() - reference.positions().row(v)).rowwise().norm();
            ASSERT_LT(away.minCoeff(), 1e-12) << id << " " << v;
        }
    }
}

TEST(ShapeTable, RefusesWithReasons) {
    using Pairs = std::vector<std::pair<std::string, std::string>>;
    const auto code = [](const char* id, const Pairs& settings) {
        const auto mesh = make_shape(id, settings);
        EXPECT_FALSE(mesh.ok());
        EXPECT_FALSE(mesh.error().message.empty());
        return mesh.error().code;
    };
    EXPECT_EQ(code("dodecahedron", {}), ErrorCode::bad_argument);
    EXPECT_EQ(code("grid", {{"n", "3"}}), ErrorCode::bad_argument);
    EXPECT_EQ(code("grid", {{"nx", "three"}}), ErrorCode::bad_argument);
    EXPECT_EQ(code("grid", {{"nx", "2.5"}}), ErrorCode::parameter_out_of_range);
    EXPECT_EQ(code("grid", {{"nx", "100000000"}}), ErrorCode::parameter_out_of_range);
    EXPECT_EQ(code("ico-sphere", {{"level", "30"}}), ErrorCode::parameter_out_of_range);
    EXPECT_EQ(code("torus", {{"minor", "2"}}), ErrorCode::bad_argument);
    EXPECT_NE(make_shape("dodecahedron").error().message.find("hexagon-sphere"), std::string::npos);
}

}  // namespace
}  // namespace polylap::test

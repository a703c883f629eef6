// Smoothing flows: implicit, conformalised and explicit steps, volume kept, boundary fixed.
#include "polylap/apply/flow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/LU>

#include "polylap/apply/rescaling.hpp"
#include "session_fixture.hpp"

namespace polylap::test {
namespace {

constexpr std::array flows{Flow::implicit_step, Flow::conformalised, Flow::explicit_step};

double volume_of(const Session& session) {
    return session.shape(Side::a).volume.value();
}

/// A step that is stable for every operator and flow of the tests, in length².
double small_time(const PolygonMesh& mesh) {
    return 0.002 * bounding_size(mesh) * bounding_size(mesh) / mesh.vertex_count();
}

Result<Points> smoothed(const PolygonMesh& mesh, const OperatorSpec& spec, const Session::SmoothOptions& options) {
    Session session = open_mesh(mesh);
    check(session.set_operator(Side::a, spec));
    if (auto status = session.smooth(Side::a, options); !status) return status.error();
    return session.surface(Side::a).positions();
}

TEST(Flow, NamesAreFoundAgain) {
    for (const Flow flow : flows)
        EXPECT_EQ(get(find_flow(flow_name(flow))), flow);
    const auto unknown = find_flow("upwards");
    ASSERT_FALSE(unknown.ok());
    EXPECT_EQ(unknown.error().message, "there is no flow 'upwards'; the flows are implicit, conformalised, explicit");
}

TEST(Flow, MovesWithItsMesh) {
    const Eigen::RowVector3d far(70, -30, 50);
    int tried = 0;
    for (const auto& [name, mesh] : zoo()) {
        if (name == "unreferenced-vertices") continue;
        for (const OperatorInfo* info : operators()) {
            if (info->claims.constants_in_kernel.where != Claim::yes) continue;
            for (const Flow flow : flows) {
                for (const bool fix : {false, true}) {
                    const Session::SmoothOptions options{
                        .time = small_time(mesh), .steps = 2, .flow = flow, .fix_boundary = fix};
                    const auto here = smoothed(mesh, {info->id, {}}, options);
                    const auto moved = get(mesh.with_positions(mesh.positions().rowwise() + far));
                    const auto there = smoothed(moved, {info->id, {}}, options);
                    ASSERT_EQ(here.ok(), there.ok()) << name << ", " << info->id << ", " << flow_name(flow);
                    if (!here) continue;
                    ++tried;
                    EXPECT_LE(((there->rowwise() - far) - *here).cwiseAbs().maxCoeff(), 1e-9 * bounding_size(mesh))
                        << name << ", " << info->id << ", " << flow_name(flow);
                }
            }
        }
    }
    EXPECT_GT(tried, 500);
}

TEST(Flow, ExplicitAndImplicitStepsAgreeToSecondOrder) {
    for (const auto& [name, mesh] : zoo()) {
        for (const OperatorInfo* info : operators()) {
            const auto m = build_operator(mesh, {info->id, {}});
            if (!m || m->structure == Structure::symmetric) continue;
            const auto stability = explicit_stability(*m);
            if (!stability) continue;
            const double time = 1e-3 * stability->limit();
            const auto gap = [&](double t) {
                const Points implicit = get(get(ImplicitSmoother::create(*m, t)).step(mesh.positions()));
                return (implicit - get(explicit_step(*m, t, mesh.positions())).points).norm();
            };
            const double coarse = gap(time);
            if (coarse < 1e-9 * bounding_size(mesh)) continue;  // flat: nothing moves
            EXPECT_NEAR(coarse / gap(time / 2), 4, 0.05) << name << ", " << info->id;
        }
    }
}

TEST(Flow, FixedVerticesStayAndTheOthersSolveTheirRows) {
    int open = 0;
    for (const auto& [name, mesh] : zoo()) {
        const Topology topology = build_topology(*mesh.connectivity());
        const auto& fixed = topology.boundary_vertices;
        if (fixed.empty() || mesh.vertex_count() > 150 || !topology.unreferenced.empty()) continue;
        std::vector<Index> free;
        for (Index v = 0; v < mesh.vertex_count(); ++v)
            if (!std::binary_search(fixed.begin(), fixed.end(), v)) free.push_back(v);
        for (const OperatorInfo* info : operators()) {
            const auto m = build_operator(mesh, {info->id, {}});
            if (!m) continue;
            const double time = 0.3 * bounding_size(mesh) * bounding_size(mesh) / mesh.vertex_count();
            const Matrix s(m->stiffness), mass(m->mass);
            const Matrix x = mesh.positions();
            Matrix expected = x;
            const Matrix rhs = mass(free, free) * x(free, Eigen::all) - time * s(free, fixed) * x(fixed, Eigen::all);
            if (!free.empty())
                expected(free, Eigen::all) = Matrix(mass(free, free) + time * s(free, free)).fullPivLu().solve(rhs);
            for (const auto choice : {SmootherOptions::Choice::direct, SmootherOptions::Choice::iterative}) {
                auto smoother = ImplicitSmoother::create(*m, time, {.choice = choice, .fixed = fixed});
                if (!smoother) continue;  // a mass of 0
                const auto moved = smoother->step(mesh.positions());
                if (!moved) continue;
                ++open;
                EXPECT_EQ(Matrix((*moved)(fixed, Eigen::all)), Matrix(x(fixed, Eigen::all))) << name;
                EXPECT_LE((*moved - expected).cwiseAbs().maxCoeff(), 1e-9 * bounding_size(mesh))
                    << name << ", " << info->id;
            }
            const auto step = explicit_step(*m, time, mesh.positions(), fixed);
            if (!step) continue;
            Matrix forward = x;
            if (!free.empty())
                forward(free, Eigen::all) -=
                    time * Matrix(mass(free, free)).fullPivLu().solve(Matrix(s(free, Eigen::all) * x));
            EXPECT_LE((step->points - forward).cwiseAbs().maxCoeff(), 1e-9 * forward.cwiseAbs().maxCoeff())
                << name << ", " << info->id;
        }
    }
    EXPECT_GT(open, 100);
}

// Umbrella weights 1, the middle moved in the plane: it has all four faces, a quarter of the area as its mass, and four
// neighbours around where it was.
TEST(Flow, StepsOfTheSmallGridByHand) {
    PolygonMesh mesh = specimen("grid-2x2");
    Points x = mesh.positions();
    const double middle = x(4, 0);
    const double away = 0.1 * bounding_size(mesh);
    x(4, 0) += away;
    mesh = get(mesh.with_positions(x));
    const OperatorSpec umbrella{"umbrella", {}};
    const double mass = total_area(mesh) / 4;
    const double t = 0.1 * mass;
    const Points held = get(smoothed(mesh, umbrella, {.time = t, .fix_boundary = true}));
    EXPECT_NEAR(held(4, 0) - middle, away * mass / (mass + 4 * t), 1e-15);
    EXPECT_EQ(held.topRows(4), x.topRows(4));
    EXPECT_EQ(held.bottomRows(4), x.bottomRows(4));
    const Points forward =
        get(smoothed(mesh, umbrella, {.time = t, .flow = Flow::explicit_step, .fix_boundary = true}));
    EXPECT_NEAR(forward(4, 0) - middle, away * (1 - 4 * t / mass), 1e-15);
    const Points all = get(smoothed(mesh, umbrella, {.time = t, .flow = Flow::explicit_step, .rebuild = false}));
    const auto m = get(build_operator(mesh, umbrella));
    for (const Index v : {0, 1, 4}) {
        double pull = 0;
        for (SparseMatrix::InnerIterator it(m.stiffness, v); it; ++it)
            pull += it.value() * x(it.row(), 0);
        EXPECT_NEAR(all(v, 0), x(v, 0) - t / m.mass.coeff(v, v) * pull, 1e-14);
    }

    Session session = open_mesh(mesh);
    check(session.set_operator(Side::a, umbrella));
    const Stability bound = get(session.stability(Side::a, {.fix_boundary = true}));
    EXPECT_NEAR(bound.largest * m.mass.coeff(4, 4), 4, 1e-12) << "one free vertex";
    EXPECT_NEAR(bound.growth(bound.limit()), -1, 1e-12);
}

TEST(Flow, KeepsTheVolumeOfTheLoadedMesh) {
    int closed = 0;
    for (const auto& [name, mesh] : zoo()) {
        for (const OperatorInfo* info : operators()) {
            for (const Flow flow : flows) {
                Session session = open_mesh(mesh);
                check(session.set_operator(Side::a, {info->id, {}}));
                const auto before = session.shape(Side::a);
                const Session::SmoothOptions options{
                    .time = small_time(mesh), .steps = 3, .flow = flow, .keep_volume = true};
                const auto status = session.smooth(Side::a, options);
                if (!before.volume) {
                    ASSERT_FALSE(status.ok());
                    EXPECT_EQ(status.error().message, "there is no volume to keep: " + before.no_volume);
                    EXPECT_GE(status.error().element, 0);
                    EXPECT_EQ(session.surface(Side::a).positions(), mesh.positions());
                } else if (status.ok()) {
                    ++closed;
                    EXPECT_NEAR(volume_of(session), *before.volume, 1e-12 * std::abs(*before.volume))
                        << name << ", " << info->id << ", " << flow_name(flow);
                    EXPECT_GT((session.surface(Side::a).positions() - mesh.positions()).norm(), 0);
                }
            }
        }
    }
    EXPECT_GT(closed, 50);
}

TEST(Flow, DoesNotMirrorASurfaceToKeepItsVolume) {
    const auto mesh = get(make_torus(8, 6));
    const Topology topology = build_topology(*mesh.connectivity());
    const double volume = get(enclosed_volume(mesh, topology));
    EXPECT_NEAR(get(enclosed_volume(get(scaled_to_volume(mesh, topology, 8 * volume)), topology)), 8 * volume, 1e-12);
    const auto turned = scaled_to_volume(get(mesh.with_positions(-mesh.positions())), topology, volume);
    ASSERT_FALSE(turned.ok());
    EXPECT_NE(turned.error().message.find("inside out"), std::string::npos);
    Points flat = mesh.positions();
    flat.col(2).setZero();
    EXPECT_FALSE(scaled_to_volume(get(mesh.with_positions(flat)), topology, volume).ok());
}

double roundness(const Points& x) {
    const Points centred = x.rowwise() - x.colwise().mean();
    const Vector radius = centred.rowwise().norm();
    return (radius.array() - radius.mean()).abs().maxCoeff() / radius.mean();
}

TEST(Flow, ConformalisedMakesAnEllipsoidRoundAndKeepsItsArea) {
    const PolygonMesh sphere = load_mesh("triangle-sphere-2");
    EXPECT_LT(roundness(sphere.positions()), 1e-3);
    Points stretched = sphere.positions();
    stretched.col(2) *= 1.3;
    const PolygonMesh ellipsoid = get(sphere.with_positions(stretched));
    for (const char* const id : {"cotan", "planar", "alexa-wardetzky"}) {
        const auto flow = [&](const PolygonMesh& mesh, int steps) {
            Session session = open_mesh(mesh);
            check(session.set_operator(Side::a, {id, {}}));
            check(session.smooth(Side::a, {.time = 0.05, .steps = steps, .flow = Flow::conformalised}));
            EXPECT_NEAR(total_area(session.surface(Side::a)), total_area(mesh), 1e-12 * total_area(mesh));
            return session.surface(Side::a).positions();
        };
        EXPECT_LT(roundness(flow(sphere, 20)), 0.01) << id;
        EXPECT_LT(roundness(flow(ellipsoid, 60)), 0.25 * roundness(stretched)) << id;
    }
}

TEST(Flow, ConformalisedKeepsTheStiffnessAndRebuildsTheMass) {
    const PolygonMesh mesh = noisy_torus();
    for (const OperatorInfo* info : operators()) {
        const OperatorSpec spec{info->id, {}};
        const auto first = get(build_operator(mesh, spec));
        PolygonMesh moving = mesh;
        for (int k = 0; k < 3; ++k) {
            auto m = get(build_operator(moving, spec));
            m.stiffness = first.stiffness;
            auto smoother = get(ImplicitSmoother::create(m, 0.02));
            moving = get(moving.with_positions(get(smoother.step(moving.positions()))));
            moving = get(scaled_to_area(moving, total_area(mesh)));
        }
        for (const bool rebuild : {false, true}) {
            const Points x =
                get(smoothed(mesh, spec, {.time = 0.02, .steps = 3, .flow = Flow::conformalised, .rebuild = rebuild}));
            EXPECT_LE((x - moving.positions()).cwiseAbs().maxCoeff(), 1e-12) << info->id;
        }
    }
}

TEST(Flow, SystemsOfOneSideAreNotMixedUp) {
    const PolygonMesh mesh = get(add_normal_noise(get(make_saddle(8, 0.6)), 0.2, 1));
    const double time = 0.02;
    const std::vector<Session::SmoothOptions> kinds{
        {.time = time},
        {.time = time, .fix_boundary = true},
        {.time = time, .rebuild = false},
        {.time = time, .flow = Flow::conformalised},
        {.time = time, .rebuild = false, .fix_boundary = true},
        {.time = time, .flow = Flow::conformalised, .fix_boundary = true},
        {.time = time, .flow = Flow::explicit_step, .rebuild = false},
        {.time = time, .flow = Flow::explicit_step, .fix_boundary = true},
    };
    Session session = open_mesh(mesh);
    for (int round = 0; round < 2; ++round) {
        for (const auto& options : kinds) {
            session.reset(Side::a);
            check(session.smooth(Side::a, options));
            const Points expected = get(smoothed(mesh, session.spec(Side::a), options));
            EXPECT_LE((session.surface(Side::a).positions() - expected).cwiseAbs().maxCoeff(), 1e-12);
        }
    }
}

TEST(Flow, UnstableStepsAreTakenUntilTheyWouldOverflow) {
    Session session = open_mesh(noisy_torus());
    const Session::SmoothOptions steps{.time = 0, .flow = Flow::explicit_step, .rebuild = false};
    const Stability bound = get(session.stability(Side::a, steps));
    Session::SmoothOptions unstable = steps;
    unstable.time = 20 * bound.limit();
    for (int k = 0; k < 200; ++k) {
        const Points before = session.surface(Side::a).positions();
        const auto status = session.smooth(Side::a, unstable);
        if (status.ok()) continue;
        EXPECT_GT(k, 10);
        EXPECT_EQ(status.error().code, ErrorCode::not_converged);
        EXPECT_NE(status.error().message.find("vertex " + std::to_string(status.error().element)), std::string::npos);
        EXPECT_EQ(session.surface(Side::a).positions(), before);
        EXPECT_LE(before.cwiseAbs().maxCoeff(), largest_coordinate);
        EXPECT_GT(before.cwiseAbs().maxCoeff(), 1e30);
        return;
    }
    FAIL() << "never refused";
}

TEST(Flow, StabilityIsRememberedPerSurface) {
    Session session = open_mesh(noisy_torus());
    const auto ticks = [&](const Session::SmoothOptions& options) {
        Ticks counted;
        get(session.stability(Side::a, options, counted.monitor()));
        EXPECT_TRUE(counted.fractions.empty() || counted.rise());
        return counted.fractions.size();
    };
    EXPECT_GT(ticks({}), 10U);
    EXPECT_EQ(ticks({}), 0U);
    check(session.smooth(Side::a, {.time = 0.01}));
    EXPECT_EQ(ticks({.rebuild = false}), 0U);
    EXPECT_GT(ticks({}), 10U);
    EXPECT_EQ(ticks({.fix_boundary = true}), 0U) << "it is closed";

    Ticks stopped;
    stopped.stop_at = 8;
    const auto result = session.stability(Side::b, {}, stopped.monitor());
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
    EXPECT_TRUE(session.stability(Side::b, {}).ok());
}

}  // namespace
}  // namespace polylap::test

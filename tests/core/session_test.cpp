#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "polylap/apply/smoothing.hpp"
#include "polylap/mesh/mesh_io.hpp"
#include "session_fixture.hpp"

namespace polylap::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Result<Session> open_text(std::string_view text, std::string_view name, Monitor monitor = {}) {
    return Session::open(std::as_bytes(std::span(text.data(), text.size())), name, monitor);
}

template <class T>
ErrorCode code_of(const Result<T>& result) {
    return result.ok() ? ErrorCode::parse_error
                       : result.error().code;  // parse_error: cannot come from the calls compared
}

TEST(Session, StartsOnTheLoadedMesh) {
    const auto mesh = noisy_torus();
    const Session session = open_mesh(mesh);
    EXPECT_EQ(session.mesh().positions(), mesh.positions());
    EXPECT_EQ(session.topology().edges.size(), 192u);
    EXPECT_EQ(session.display().triangles.size(), 192u);
    for (const Side side : sides) {
        EXPECT_EQ(session.surface(side).positions(), mesh.positions());
        EXPECT_EQ(session.step_count(side), 0);
        EXPECT_EQ(session.spec(side).values.size(), get(find_operator(session.spec(side).id))->parameters.size());
    }
    EXPECT_NE(session.spec(Side::a).id, session.spec(Side::b).id) << "two sides are for two operators";
}

TEST(Session, OpensFiles) {
    const auto bytes = read_bytes("meshes/saddle-12x12.obj");
    for (const char* name : {"saddle.obj", "SADDLE.OBJ", "a.b/c.obj"}) {
        const Session session = get(Session::open(bytes, name));
        EXPECT_EQ(session.mesh().face_count(), 144) << name;
    }
    for (const char* name : {"saddle.doc", "saddle", "", "obj", "saddle.obj.gz"}) {
        const auto refused = Session::open(bytes, name);
        ASSERT_FALSE(refused.ok()) << name;
        EXPECT_EQ(refused.error().code, ErrorCode::bad_argument) << name;
        EXPECT_FALSE(refused.error().message.empty());
    }
    const auto broken = open_text("v 0 0 0\nv 1 0 0\nv 1 nan 0\nf 1 2 3\n", "x.obj");
    ASSERT_FALSE(broken.ok());
    EXPECT_EQ(broken.error().code, ErrorCode::parse_error);
    EXPECT_EQ(broken.error().line, 3);
    EXPECT_EQ(open_text("", "x.obj").error().code, ErrorCode::parse_error);

    const std::string large = write_obj(get(make_grid(200, 200))).value();
    Ticks ticks;
    ticks.stop_at = 1;
    const auto cancelled = open_text(large, "x.obj", ticks.monitor());
    ASSERT_FALSE(cancelled.ok());
    EXPECT_EQ(cancelled.error().code, ErrorCode::cancelled);
    Ticks all;
    ASSERT_TRUE(open_text(large, "x.obj", all.monitor()).ok());
    EXPECT_TRUE(all.rise());
}

TEST(Session, OpensMeshesThatOperatorsRefuse) {
    // Nothing is wrong with looking at such a mesh; the face is named when an operator needs it.
    Session session = open_mesh(
        make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2, 3}, {1, 4, 5}}));
    EXPECT_EQ(session.display().triangles.size(), 3u);
    const auto matrices = session.matrices(Side::a);
    ASSERT_FALSE(matrices.ok());
    EXPECT_EQ(matrices.error().code, ErrorCode::degenerate_face);
    EXPECT_EQ(matrices.error().element, 1);
    EXPECT_EQ(session.smooth(Side::a, {.time = 1}).error().element, 1);
    EXPECT_EQ(session.weights(Side::b).error().element, 1);
    EXPECT_EQ(session.harmonic(Side::b, std::vector<Index>{0}, std::vector<double>{1}).error().element, 1);
    EXPECT_NEAR(session.shape(Side::a).measures.area, 1, 1e-14);
}

TEST(Session, MatricesAreThoseOfTheSpec) {
    Session session = open_mesh(noisy_torus());
    for (const OperatorSpec& spec : all_specs()) {
        for (const Side side : sides) {
            check(session.set_operator(side, spec));
            EXPECT_EQ(session.spec(side), get(complete_spec(spec)));
            const auto expected = get(build_operator(session.mesh(), spec));
            const OperatorMatrices& m = *get(session.matrices(side));
            EXPECT_EQ((m.stiffness - expected.stiffness).norm(), 0) << spec_name(spec);
            EXPECT_EQ((m.mass - expected.mass).norm(), 0) << spec_name(spec);
        }
    }
}

/// Everything a side answers, as numbers.
std::vector<double> answers(Session& session, Side side) {
    std::vector<double> all;
    const OperatorMatrices m = *get(session.matrices(side));
    all.insert(all.end(), m.stiffness.valuePtr(), m.stiffness.valuePtr() + m.stiffness.nonZeros());
    const auto w = get(session.weights(side));
    all.push_back(w.summary.negative_ordered);
    all.insert(all.end(), w.segments.begin(), w.segments.end());
    const auto h = session.harmonic(side, std::vector<Index>{0, 50}, std::vector<double>{-1, 2});
    if (h) {
        all.insert(all.end(), h->values.data(), h->values.data() + h->values.size());
    } else {
        all.push_back(static_cast<double>(h.error().code));  // not every operator has a unique one
    }
    return all;
}

TEST(Session, CachesChangeNothing) {
    // Back and forth between specs, sides and surfaces: each time the same numbers as a session that never saw anything
    // else.
    Session session = open_mesh(noisy_torus());
    const auto specs = all_specs();
    for (int round = 0; round < 2; ++round) {
        for (const OperatorSpec& spec : specs) {
            for (const Side side : sides) {
                check(session.set_operator(side, spec));
                Session fresh = open_mesh(noisy_torus());
                check(fresh.set_operator(side, spec));
                EXPECT_EQ(answers(session, side), answers(fresh, side)) << spec_name(spec);
                EXPECT_EQ(answers(session, side), answers(fresh, side)) << spec_name(spec) << ", again";
                // Not every mass is positive; then both refuse.
                EXPECT_EQ(session.smooth(side, {.time = 0.01, .steps = 2}).ok(),
                          fresh.smooth(side, {.time = 0.01, .steps = 2}).ok());
                EXPECT_EQ(session.surface(side).positions(), fresh.surface(side).positions()) << spec_name(spec);
                EXPECT_EQ(answers(session, side), answers(fresh, side)) << spec_name(spec) << ", smoothed";
                session.reset(side);
            }
        }
    }
}

TEST(Session, SidesAreIndependent) {
    Session session = open_mesh(noisy_torus());
    check(session.set_operator(Side::a, {operators().front()->id, {}}));
    check(session.set_operator(Side::b, {operators().front()->id, {}}));
    const Points before = session.surface(Side::b).positions();
    check(session.smooth(Side::a, {.time = 0.1, .steps = 3}));
    EXPECT_EQ(session.surface(Side::b).positions(), before);
    EXPECT_EQ(session.step_count(Side::a), 3);
    EXPECT_EQ(session.step_count(Side::b), 0);
    EXPECT_EQ(session.mesh().positions(), before);
    check(session.smooth(Side::b, {.time = 0.1, .steps = 3}));
    EXPECT_EQ(session.surface(Side::a).positions(), session.surface(Side::b).positions());
}

TEST(Session, WeightsFollowTheSurface) {
    Session session = open_mesh(noisy_torus());
    for (const Side side : sides) {
        check(session.smooth(side, {.time = 0.05, .steps = 2}));
        const auto moved = session.surface(side);
        const auto expected = get(build_operator(moved, session.spec(side)));
        EXPECT_EQ((get(session.matrices(side))->stiffness - expected.stiffness).norm(), 0);
        const auto weights = get(session.weights(side));
        const auto summary = summarise_weights(expected.stiffness);
        EXPECT_EQ(weights.summary.negative_ordered, summary.negative_ordered);
        ASSERT_EQ(weights.segments.size(), 6 * weights.segment_pairs.size());
        ASSERT_EQ(weights.segment_starts.size(), weights.segment_pairs.size());
        const auto lines = drape_pairs(moved, session.display(), summary.negative);
        ASSERT_EQ(lines.pair, weights.segment_pairs);
        for (std::size_t k = 0; k < lines.segments.size(); ++k) {
            for (std::size_t end = 0; end < 2; ++end) {
                for (std::size_t c = 0; c < 3; ++c) {
                    const double x = lines.segments[k][end][static_cast<Eigen::Index>(c)] -
                                     session.origin()[static_cast<Eigen::Index>(c)];
                    EXPECT_NEAR(weights.segments[6 * k + 3 * end + c], x, 1e-6);
                }
            }
            EXPECT_NEAR(weights.segment_starts[k], lines.start[k], 1e-6);
        }
    }
}

TEST(Session, SmoothsWithOrWithoutRebuilding) {
    for (const OperatorInfo* info : operators()) {
        Session session = open_mesh(noisy_torus());
        const auto start = session.mesh();
        const double time = 0.02;
        check(session.set_operator(Side::a, {info->id, {}}));
        check(session.set_operator(Side::b, {info->id, {}}));

        check(session.smooth(Side::a, {.time = time, .steps = 3, .rebuild = false}));
        auto frozen = get(ImplicitSmoother::create(get(build_operator(start, {info->id, {}})), time));
        Points x = start.positions();
        for (int k = 0; k < 3; ++k) {
            x = get(frozen.step(x));
        }
        EXPECT_LE((session.surface(Side::a).positions() - x).cwiseAbs().maxCoeff(), 1e-13) << info->id;
        // One more call goes on with the matrices of the loaded mesh.
        check(session.smooth(Side::a, {.time = time, .steps = 1, .rebuild = false}));
        EXPECT_LE((session.surface(Side::a).positions() - get(frozen.step(x))).cwiseAbs().maxCoeff(), 1e-13)
            << info->id;

        check(session.smooth(Side::b, {.time = time, .steps = 3, .rebuild = true}));
        PolygonMesh moving = start;
        for (int k = 0; k < 3; ++k) {
            auto smoother = get(ImplicitSmoother::create(get(build_operator(moving, {info->id, {}})), time));
            moving = get(moving.with_positions(get(smoother.step(moving.positions()))));
        }
        EXPECT_LE((session.surface(Side::b).positions() - moving.positions()).cwiseAbs().maxCoeff(), 1e-13) << info->id;
        EXPECT_GT((moving.positions() - x).norm(), 1e-6);
        EXPECT_EQ(session.step_count(Side::a), 4);
        EXPECT_EQ(session.step_count(Side::b), 3);
    }
}

TEST(Session, SaysHowAStepWasSolved) {
    Session session = open_mesh(get(add_normal_noise(get(make_torus(70, 60)), 0.2, 3)));
    EXPECT_FALSE(session.last_solve(Side::a).has_value());
    const double h2 = session.shape(Side::a).measures.mean_squared_edge;
    check(session.smooth(Side::a, {.time = 0.01 * h2}));
    ASSERT_TRUE(session.last_solve(Side::a).has_value());
    EXPECT_EQ(session.last_solve(Side::a)->solver, SmoothingSolver::conjugate_gradients);
    EXPECT_GT(session.last_solve(Side::a)->iterations, 0);
    EXPECT_FALSE(session.last_solve(Side::b).has_value());
    check(session.smooth(Side::b, {.time = 1e4 * h2}));
    EXPECT_EQ(session.last_solve(Side::b)->solver, SmoothingSolver::cholesky);
    EXPECT_FALSE(session.smooth(Side::b, {.time = -1}).ok());
    EXPECT_TRUE(session.last_solve(Side::b).has_value()) << "a call that fails changes nothing";
    session.reset(Side::b);
    EXPECT_FALSE(session.last_solve(Side::b).has_value());
    check(session.restore(Side::a, session.mesh().positions(), 4));
    EXPECT_FALSE(session.last_solve(Side::a).has_value());
}

TEST(Session, StepsInOneCallOrInMany) {
    Session once = open_mesh(noisy_torus());
    Session often = open_mesh(noisy_torus());
    check(once.smooth(Side::b, {.time = 0.03, .steps = 4}));
    for (int k = 0; k < 4; ++k) {
        check(often.smooth(Side::b, {.time = 0.03, .steps = 1}));
    }
    EXPECT_EQ(once.surface(Side::b).positions(), often.surface(Side::b).positions());
    EXPECT_EQ(often.step_count(Side::b), 4);
}

TEST(Session, ResetGoesBackToTheLoadedMesh) {
    Session session = open_mesh(noisy_torus());
    const auto before = answers(session, Side::a);
    const auto state = state_of(session);
    check(session.smooth(Side::a, {.time = 0.1, .steps = 2}));
    session.reset(Side::a);
    EXPECT_EQ(state_of(session), state);
    EXPECT_EQ(answers(session, Side::a), before);
}

TEST(Session, RestoreTakesUpAnothersWork) {
    Session first = open_mesh(noisy_torus());
    check(first.smooth(Side::a, {.time = 0.02, .steps = 5}));
    Session second = open_mesh(noisy_torus());
    check(second.restore(Side::a, first.surface(Side::a).positions(), 5));
    EXPECT_EQ(second.step_count(Side::a), 5);
    EXPECT_EQ(second.surface(Side::a).positions(), first.surface(Side::a).positions());
    EXPECT_EQ(answers(second, Side::a), answers(first, Side::a));
    check(first.smooth(Side::a, {.time = 0.02}));
    check(second.smooth(Side::a, {.time = 0.02}));
    EXPECT_EQ(second.surface(Side::a).positions(), first.surface(Side::a).positions());
    second.reset(Side::a);
    EXPECT_EQ(second.surface(Side::a).positions(), second.mesh().positions());

    const auto state = state_of(second);
    EXPECT_EQ(code_of(second.restore(Side::a, Points::Zero(3, 3), 1)), ErrorCode::bad_argument);
    Points broken = second.mesh().positions();
    broken(7, 0) = nan;
    const auto refused = second.restore(Side::a, broken, 1);
    EXPECT_EQ(code_of(refused), ErrorCode::bad_mesh);
    EXPECT_EQ(refused.error().element, 7);
    EXPECT_EQ(state_of(second), state);
}

TEST(Session, FailingCallsChangeNothing) {
    Session session = open_mesh(specimen("two-components"));
    check(session.set_operator(Side::a, {"alexa-wardetzky", {0.7}}));
    check(session.smooth(Side::a, {.time = 0.1}));
    const State state = state_of(session);
    const auto expect = [&](ErrorCode actual, ErrorCode expected, const char* what) {
        EXPECT_EQ(error_code_name(actual), error_code_name(expected)) << what;
        EXPECT_EQ(state_of(session), state) << what;
    };
    expect(code_of(session.set_operator(Side::a, {"nothing", {}})), ErrorCode::unknown_operator, "unknown operator");
    expect(code_of(session.set_operator(Side::a, {"alexa-wardetzky", {-1}})), ErrorCode::parameter_out_of_range,
           "λ < 0");
    expect(code_of(session.set_operator(Side::a, {"alexa-wardetzky", {nan}})), ErrorCode::parameter_out_of_range,
           "λ = nan");
    expect(code_of(session.set_operator(Side::a, {"planar", {0, 0}})), ErrorCode::bad_argument, "too many values");
    for (const double time : {0.0, -1.0, nan, infinity}) {
        expect(code_of(session.smooth(Side::a, {.time = time})), ErrorCode::bad_argument, "time");
    }
    expect(code_of(session.smooth(Side::a, {.time = 1, .steps = -1})), ErrorCode::bad_argument, "steps");
    const auto harmonic = [&](std::vector<Index> vertices, std::vector<double> values) {
        return code_of(session.harmonic(Side::a, vertices, values));
    };
    expect(harmonic({0, 13}, {1}), ErrorCode::bad_argument, "lengths differ");
    expect(harmonic({0, 17}, {1, 0}), ErrorCode::bad_argument, "out of range");
    expect(harmonic({-1, 13}, {1, 0}), ErrorCode::bad_argument, "negative vertex");
    expect(harmonic({0, 13, 0}, {1, 0, 1}), ErrorCode::bad_argument, "twice");
    expect(harmonic({0, 13}, {1, nan}), ErrorCode::bad_argument, "nan");
    expect(harmonic({0, 13}, {infinity, 0}), ErrorCode::bad_argument, "infinite");
    expect(harmonic({0, 1}, {1, 0}), ErrorCode::unconstrained_component, "component without");
    expect(harmonic({}, {}), ErrorCode::unconstrained_component, "nothing fixed");
    EXPECT_EQ(session.harmonic(Side::a, std::vector<Index>{0, 1}, std::vector<double>{1, 0}).error().element, 12);
    // And it still works.
    EXPECT_TRUE(session.harmonic(Side::a, std::vector<Index>{0, 13}, std::vector<double>{1, 0}).ok());
}

TEST(Session, CancellingLeavesTheSurface) {
    const auto mesh = get(add_normal_noise(get(make_torus(100, 60)), 0.1, 1));
    Session session = open_mesh(mesh);
    const State state = state_of(session);
    for (const std::size_t stop : {1, 2, 3, 5}) {
        Ticks ticks;
        ticks.stop_at = stop;
        EXPECT_EQ(code_of(session.smooth(Side::a, {.time = 1e-4, .steps = 4}, ticks.monitor())), ErrorCode::cancelled)
            << stop;
        EXPECT_EQ(ticks.fractions.size(), stop);
        EXPECT_EQ(state_of(session), state) << stop;
    }
    Ticks stop;
    stop.stop_at = 1;
    EXPECT_EQ(code_of(session.weights(Side::b, stop.monitor())), ErrorCode::cancelled);
    EXPECT_EQ(code_of(session.matrices(Side::b, stop.monitor())), ErrorCode::cancelled);
    EXPECT_EQ(code_of(session.harmonic(Side::b, std::vector<Index>{0}, std::vector<double>{1}, stop.monitor())),
              ErrorCode::cancelled);
    EXPECT_EQ(state_of(session), state);

    Ticks smooth;
    check(session.smooth(Side::a, {.time = 1e-4, .steps = 4}, smooth.monitor()));
    EXPECT_GE(smooth.fractions.size(), 4u);
    EXPECT_TRUE(smooth.rise());
    for (const Side side : sides) {
        Ticks weights;
        EXPECT_TRUE(session.weights(side, weights.monitor()).ok());
        EXPECT_TRUE(weights.fractions.empty() || weights.rise());
        Ticks harmonic;
        EXPECT_TRUE(session.harmonic(side, std::vector<Index>{0}, std::vector<double>{1}, harmonic.monitor()).ok());
        EXPECT_TRUE(harmonic.fractions.empty() || harmonic.rise());
    }
}

TEST(Session, FloatsAreRelativeToTheOrigin) {
    const auto near = noisy_torus();
    const Vector3 far(3e6, -5e6, 7e6);
    Session a = open_mesh(near);
    Session b = open_mesh(get(near.with_positions(near.positions().rowwise() + far.transpose())));
    const Vector3 centre =
        (near.positions().colwise().maxCoeff() + near.positions().colwise().minCoeff()).transpose() / 2;
    EXPECT_LE((a.origin() - centre).norm(), 1e-14);
    EXPECT_LE((b.origin() - a.origin() - far).norm(), 1e-8);
    for (const Side side : sides) {
        check(a.smooth(side, {.time = 0.01}));
        check(b.smooth(side, {.time = 0.01}));
        const auto p = a.float_positions(side);
        const auto q = b.float_positions(side);
        ASSERT_EQ(p.size(), 3u * 96);
        ASSERT_EQ(q.size(), p.size());
        for (std::size_t k = 0; k < p.size(); ++k) {
            EXPECT_NEAR(p[k], q[k], 2e-7) << k;
            EXPECT_NEAR(
                p[k],
                a.surface(side).positions()(static_cast<Eigen::Index>(k / 3), static_cast<Eigen::Index>(k % 3)) -
                    centre[static_cast<Eigen::Index>(k % 3)],
                1e-7);
        }
        const auto v = get(a.weights(side)).segments;
        const auto w = get(b.weights(side)).segments;
        ASSERT_EQ(v.size(), w.size());
        for (std::size_t k = 0; k < v.size(); ++k) {
            EXPECT_NEAR(v[k], w[k], 2e-7);
        }
    }
}

TEST(Session, ShapeOfTheSurface) {
    Session torus = open_mesh(noisy_torus());
    const auto before = torus.shape(Side::a);
    EXPECT_NEAR(before.measures.area, measure_shape(torus.mesh(), torus.topology()).area, 1e-14);
    EXPECT_NEAR(before.volume.value(), get(enclosed_volume(torus.mesh(), torus.topology())), 1e-14);
    EXPECT_TRUE(before.no_volume.empty());
    check(torus.smooth(Side::a, {.time = 0.05}));
    EXPECT_LT(torus.shape(Side::a).measures.area, before.measures.area);
    EXPECT_LT(torus.shape(Side::a).measures.mean_non_planarity, before.measures.mean_non_planarity);
    EXPECT_EQ(torus.shape(Side::b).measures.area, before.measures.area);

    const Session grid = open_mesh(specimen("grid-2x2"));
    EXPECT_FALSE(grid.shape(Side::a).volume.has_value());
    EXPECT_FALSE(grid.shape(Side::a).no_volume.empty());
}

TEST(Session, Moves) {
    Session first = open_mesh(noisy_torus());
    check(first.smooth(Side::a, {.time = 0.01}));
    const auto state = state_of(first);
    Session second(std::move(first));
    EXPECT_EQ(state_of(second), state);
    Session third = open_mesh(specimen("grid-2x2"));
    third = std::move(second);
    EXPECT_EQ(state_of(third), state);
}

TEST(Session, SmoothsManyStepsWithoutBlowingUp) {
    Session session = open_mesh(noisy_torus());
    const double h2 = session.shape(Side::a).measures.mean_squared_edge;
    for (const Side side : sides) {
        const double area = session.shape(side).measures.area;
        check(session.smooth(side, {.time = 0.02 * h2, .steps = 10}));
        EXPECT_TRUE(session.surface(side).positions().allFinite());
        EXPECT_LT(session.shape(side).measures.area, area);
        EXPECT_GT(session.shape(side).measures.area, 0);
    }
}

TEST(Session, CountsStepsWithoutOverflow) {
    Session session = open_mesh(specimen("grid-2x2"));
    constexpr int most = std::numeric_limits<int>::max();
    check(session.restore(Side::a, session.mesh().positions(), most));
    const auto status = session.smooth(Side::a, {.time = 1, .steps = 1});
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().code, ErrorCode::bad_argument);
    EXPECT_EQ(session.step_count(Side::a), most);
}

}  // namespace
}  // namespace polylap::test

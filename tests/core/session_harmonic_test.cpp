#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "polylap/solve/dirichlet.hpp"
#include "polylap/solve/pinned_problem.hpp"
#include "session_fixture.hpp"

namespace polylap::test {
namespace {

TEST(Session, HarmonicReportsWhatLiesOutside) {
    Session session = open_mesh(get(make_grid(2, 2, 2, 2)));
    const std::vector<Index> fixed{0, 1, 2, 3, 5, 6, 7, 8};
    const std::vector<double> values{0, 1, 0, 1, 1, 0, 1, 0};
    for (const double lambda : {0.25, 0.5, 1.0, 2.0}) {
        check(session.set_operator(Side::a, {"alexa-wardetzky", {lambda}}));
        const auto h = get(session.harmonic(Side::a, fixed, values));
        const double centre = 4 * lambda / (1 + 2 * lambda);
        EXPECT_NEAR(h.values[4], centre, 1e-14);
        EXPECT_EQ(h.fixed_min, 0);
        EXPECT_EQ(h.fixed_max, 1);
        EXPECT_EQ(h.min, 0);
        EXPECT_NEAR(h.max, std::max(1.0, centre), 1e-14);
        EXPECT_EQ(h.outside, lambda > 0.5 ? std::vector<Index>{4} : std::vector<Index>{});
    }
    check(session.set_operator(Side::b, {"planar", {}}));
    const auto h = get(session.harmonic(Side::b, fixed, values));
    EXPECT_NEAR(h.values[4], 1, 1e-14);
    EXPECT_TRUE(h.outside.empty());
}

// What counts as outside is measured by the width of the fixed range, wherever that range lies.
TEST(Session, OutsideIsRelativeToTheWidthOfTheRange) {
    Session session = open_mesh(get(make_grid(2, 2, 2, 2)));
    const std::vector<Index> fixed{0, 1, 2, 3, 5, 6, 7, 8};
    for (const double offset : {0.0, 1000.0}) {
        for (const double width : {1e-3, 1.0}) {
            const double low = offset;
            const double high = offset + width;
            for (const auto& [excess, outside] : {std::pair(1e-7, true), std::pair(-1e-7, false)}) {
                // λ = ½ + ε lifts the centre by about ε of the width beyond the midpoints.
                check(session.set_operator(Side::a, {"alexa-wardetzky", {0.5 + excess}}));
                const auto h = get(
                    session.harmonic(Side::a, fixed, std::vector<double>{low, high, low, high, high, low, high, low}));
                EXPECT_EQ(h.outside.size(), outside ? 1u : 0u) << offset << ", " << width;
            }
        }
    }
}

TEST(Session, HarmonicOnLargerMeshes) {
    Session session = open_mesh(get(make_grid(8, 8)));
    const auto fixed = session.topology().boundary_vertices;
    std::vector<double> values(fixed.size(), 0.0);
    values[0] = 1;
    for (const Side side : sides) {
        const auto h = get(session.harmonic(side, fixed, values));
        const auto s = get(build_operator(session.mesh(), session.spec(side))).stiffness;
        const Vector expected =
            get(get(DirichletProblem::create(s, fixed))
                    .solve(Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()))))
                .col(0);
        EXPECT_LE((h.values - expected).cwiseAbs().maxCoeff(), 1e-14);
        EXPECT_EQ(h.min, h.values.minCoeff());
        EXPECT_EQ(h.max, h.values.maxCoeff());
        std::vector<Index> outside;
        for (Index v = 0; v < h.values.size(); ++v) {
            if (h.values[v] < -Session::outside_tolerance || h.values[v] > 1 + Session::outside_tolerance)
                outside.push_back(v);
        }
        EXPECT_EQ(h.outside, outside);
        EXPECT_EQ(outside.empty(), session.spec(side).id == "planar");
    }
    // Other values at the same vertices, and one value for all: nothing is outside.
    const auto constant = get(session.harmonic(Side::a, fixed, std::vector<double>(fixed.size(), 0.3)));
    EXPECT_NEAR(constant.min, 0.3, 1e-14);
    EXPECT_NEAR(constant.max, 0.3, 1e-14);
    EXPECT_TRUE(constant.outside.empty()) << "rounding is not outside, even where the range has no width";
    const auto zero = get(session.harmonic(Side::a, fixed, std::vector<double>(fixed.size(), 0.0)));
    EXPECT_TRUE(zero.outside.empty());
}

TEST(Session, HarmonicLeavesUnreferencedVerticesOut) {
    Session session = open_mesh(specimen("unreferenced-vertices"));
    const auto h = get(session.harmonic(Side::a, std::vector<Index>{1, 3}, std::vector<double>{2, 5}));
    EXPECT_TRUE(std::isnan(h.values[0]));
    EXPECT_TRUE(std::isnan(h.values[4]));
    EXPECT_TRUE(std::isfinite(h.min));
    EXPECT_TRUE(std::isfinite(h.max));
    for (const Index v : h.outside) {
        EXPECT_TRUE(v != 0 && v != 4);
    }
}

// λ = 0 is singular: the error says so and names a vertex, and nothing is lost.
TEST(Session, SingularHarmonicProblems) {
    Session session = open_mesh(noisy_torus());
    check(session.set_operator(Side::a, {"alexa-wardetzky", {0}}));
    const State state = state_of(session);
    const auto h = session.harmonic(Side::a, std::vector<Index>{0}, std::vector<double>{1});
    ASSERT_FALSE(h.ok());
    EXPECT_EQ(h.error().code, ErrorCode::not_positive_definite);
    EXPECT_GE(h.error().element, 0);
    EXPECT_LT(h.error().element, session.mesh().vertex_count());
    EXPECT_EQ(state_of(session), state);
}

TEST(Session, HarmonicIsFiniteOrRefused) {
    Session session = open_mesh(get(make_grid(8, 8)));
    const std::vector<Index> fixed{0, 80};
    const auto h = session.harmonic(Side::a, fixed, std::vector<double>{1e308, -1e308});
    if (h.ok()) {
        EXPECT_TRUE(h->values.allFinite());
    } else {
        EXPECT_EQ(h.error().code, ErrorCode::bad_argument);
    }
}

/// As a session without a past answers.
Vector from_scratch(const Session& session, Side side, const std::vector<Index>& fixed,
                    const std::vector<double>& values) {
    const auto matrices = get(build_operator(session.surface(side), session.spec(side)));
    const Eigen::Map<const Vector> given(values.data(), static_cast<Eigen::Index>(values.size()));
    return get(get(DirichletProblem::create(matrices.stiffness, fixed, matrices.structure)).solve(given)).col(0);
}

// Pins come, go and change their values, operators and surfaces too: each answer is that of a new session.
TEST(Session, HarmonicForgetsWhatWas) {
    Session session = open_mesh(specimen("quad-torus-32x16-noisy"));
    std::mt19937 random(2);
    std::vector<Index> fixed{0, 300};
    std::vector<double> values{0, 1};
    const auto expect_as_new = [&](const char* after) {
        for (const Side side : sides) {
            const auto h = get(session.harmonic(side, fixed, values));
            EXPECT_LE((h.values - from_scratch(session, side, fixed, values)).cwiseAbs().maxCoeff(), 1e-9) << after;
        }
    };
    const auto specs = all_specs(session.mesh());
    for (int k = 0; k < 60; ++k) {
        expect_as_new("a new pin");
        values[random() % values.size()] = static_cast<double>(random() % 100) / 100;
        expect_as_new("another value");
        if (fixed.size() > 2 && random() % 3 == 0) {
            fixed.erase(fixed.begin());
            values.erase(values.begin());
            expect_as_new("a pin less");
        }
        if (k % 10 == 5) {
            check(session.set_operator(sides[k / 10 % 2], specs[random() % specs.size()]));
            // Some leave more open than these pins decide.
            if (!session.harmonic(sides[k / 10 % 2], fixed, values))
                check(session.set_operator(sides[k / 10 % 2], {"umbrella", {}}));
            expect_as_new("another operator");
        }
        if (k % 20 == 19) {
            check(session.smooth(Side::a, {.time = 0.001}));
            expect_as_new("a smoothing step");
        }
        const auto v = static_cast<Index>(random() % static_cast<unsigned>(session.mesh().vertex_count()));
        if (std::find(fixed.begin(), fixed.end(), v) != fixed.end()) continue;
        fixed.push_back(v);
        values.push_back(static_cast<double>(random() % 100) / 100);
    }
}

// More pins than potentials are kept of, and one less.
TEST(Session, HarmonicOfVeryManyPins) {
    Session session = open_mesh(get(make_grid(66, 66)));
    const Index n = session.mesh().vertex_count();
    const auto most = static_cast<std::size_t>(PinnedProblem::most_bytes / (8 * n));
    ASSERT_LT(most + 1, static_cast<std::size_t>(n));
    std::vector<Index> fixed;
    std::vector<double> values;
    for (std::size_t k = 0; k <= most; ++k) {
        fixed.push_back(static_cast<Index>(k));
        values.push_back(std::sin(0.1 * static_cast<double>(k)));
    }
    for (int round = 0; round < 2; ++round) {
        const auto h = get(session.harmonic(Side::b, fixed, values));
        EXPECT_LE((h.values - from_scratch(session, Side::b, fixed, values)).cwiseAbs().maxCoeff(), 1e-9);
        fixed.resize(20);
        values.resize(20);
    }
}

// So many pins that they are eliminated: one value moves, then another, far away, all the way to the others', and back.
TEST(Session, DraggingAValueOfMany) {
    Session session = open_mesh(get(make_grid(40, 40)));
    const auto fixed = session.topology().boundary_vertices;
    ASSERT_FALSE(PinnedProblem::may_pay(fixed.size(), session.mesh().vertex_count()));
    for (const char* id : {"alexa-wardetzky", "normalized-graph", "tutte"}) {
        check(session.set_operator(Side::a, {id, {}}));
        std::vector<double> values(fixed.size(), 3);
        const auto expect_as_new = [&](double scale) {
            const auto h = get(session.harmonic(Side::a, fixed, values));
            EXPECT_LE((h.values - from_scratch(session, Side::a, fixed, values)).cwiseAbs().maxCoeff(), 1e-9 * scale)
                << id << ": " << values[7] << ", " << values[20];
            return h;
        };
        expect_as_new(1);
        for (const double value : {3.0, 3.1, 2.0, -50.0, -50.0, 3.0}) {
            values[7] = value;
            expect_as_new(1);
        }
        for (const double value : {3.5, 4.0, 1e12, -1e9, 3.0, 2.9}) {
            values[20] = value;
            expect_as_new(std::max(1.0, std::abs(value)));
        }
        values[7] = values[20] = 1e-3;
        expect_as_new(1);
    }
    check(session.set_operator(Side::a, {"planar", {}}));
    std::vector<double> values(fixed.size(), 0.3);
    for (const double value : {0.3, 0.7, 0.3}) {  // back to one value for all: rounding is not outside
        values[5] = value;
        const auto h = get(session.harmonic(Side::a, fixed, values));
        EXPECT_TRUE(h.outside.empty());
        EXPECT_NEAR(h.max, value, 1e-15);
    }
    values[5] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(session.harmonic(Side::a, fixed, values).error().code, ErrorCode::bad_argument);
}

TEST(Session, HarmonicStopsWhenToldTo) {
    Session session = open_mesh(noisy_torus());
    const std::vector<Index> fixed{3, 40, 70};
    const std::vector<double> values{0, 2, 1};
    Ticks all;
    const auto expected = get(session.harmonic(Side::a, fixed, values, all.monitor()));
    EXPECT_TRUE(all.rise());
    EXPECT_EQ(all.fractions.back(), 1);
    for (std::size_t stop = 1; stop <= all.fractions.size(); ++stop) {
        Session other = open_mesh(noisy_torus());
        const State state = state_of(other);
        Ticks ticks;
        ticks.stop_at = stop;
        const auto h = other.harmonic(Side::a, fixed, values, ticks.monitor());
        ASSERT_FALSE(h.ok()) << stop;
        EXPECT_EQ(h.error().code, ErrorCode::cancelled);
        EXPECT_EQ(state_of(other), state);
        EXPECT_EQ(get(other.harmonic(Side::a, fixed, values)).values, expected.values);
    }
}

}  // namespace
}  // namespace polylap::test

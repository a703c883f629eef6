#include "polylap/solve/pinned_problem.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "operator_cases.hpp"
#include "polylap/mesh/shapes.hpp"
#include "polylap/solve/dirichlet.hpp"

namespace polylap::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Pins {
    std::vector<Index> vertices;
    Vector values;
};

/// `count` vertices in any order, with values from 0 to 1, of which some are equal.
Pins random_pins(Index vertex_count, Index count, std::mt19937& random) {
    Pins pins;
    pins.vertices.resize(static_cast<std::size_t>(vertex_count));
    std::iota(pins.vertices.begin(), pins.vertices.end(), 0);
    std::shuffle(pins.vertices.begin(), pins.vertices.end(), random);
    pins.vertices.resize(static_cast<std::size_t>(count));
    pins.values.resize(count);
    for (double& value : pins.values) {
        value = static_cast<double>(random() % 17) / 16;
    }
    return pins;
}

Vector eliminate(const SparseMatrix& s, const Pins& pins) {
    return get(get(DirichletProblem::create(s, pins.vertices)).solve(pins.values)).col(0);
}

/// Largest difference; infinite where only one of them is a number.
double distance(const Vector& a, const Vector& b) {
    double largest = 0;
    for (Eigen::Index v = 0; v < a.size(); ++v) {
        if (std::isnan(a[v]) && std::isnan(b[v])) continue;
        const double d = std::abs(a[v] - b[v]);
        largest = std::isnan(d) ? infinity : std::max(largest, d);
    }
    return largest;
}

SparseMatrix stiffness(const PolygonMesh& mesh) {
    return get(build_operator(mesh, {operators().front()->id, {}})).stiffness;
}

bool suits(const OperatorSpec& spec, const OperatorMatrices& matrices) {
    return matrices.structure == Structure::positive_semidefinite &&
           get(find_operator(spec.id))->claims.constants_in_kernel.where == Claim::yes;
}

// One pin in each part leaves just the constants open: where more is open, the stiffness is refused.
TEST(PinnedProblem, IsRefusedWhereTheKernelIsLarger) {
    int refused = 0;
    for_all([&](const Specimen& s, const OperatorSpec& spec, const OperatorMatrices& matrices, double) {
        if (!suits(spec, matrices)) return;
        std::vector<Index> pins;
        auto eliminated = DirichletProblem::create(matrices.stiffness, pins);
        while (!eliminated && eliminated.error().code == ErrorCode::unconstrained_component) {
            pins.push_back(static_cast<Index>(eliminated.error().element));
            eliminated = DirichletProblem::create(matrices.stiffness, pins);
        }
        auto problem = get(PinnedProblem::create(matrices.stiffness, s.mesh.positions()));
        const auto u = problem.solve(pins, Vector::Zero(static_cast<Eigen::Index>(pins.size())));
        ASSERT_EQ(u.ok(), eliminated.ok());
        if (u.ok()) return;
        EXPECT_EQ(u.error().code, ErrorCode::not_positive_definite);
        EXPECT_EQ(eliminated.error().code, ErrorCode::not_positive_definite);
        ++refused;
    });
    EXPECT_GT(refused, 0);
}

TEST(PinnedProblem, SolvesWhatEliminationSolves) {
    std::mt19937 random(11);
    for_all([&](const Specimen& s, const OperatorSpec& spec, const OperatorMatrices& matrices, double) {
        if (!suits(spec, matrices)) return;
        const Index n = s.mesh.vertex_count();
        auto problem = get(PinnedProblem::create(matrices.stiffness, s.mesh.positions()));
        for (const Index count : {2, 5, 3, n, n / 2 + 1, 1}) {  // pins come and go on one problem
            const Pins pins = random_pins(n, std::min(n, count), random);
            const auto eliminated = DirichletProblem::create(matrices.stiffness, pins.vertices);
            const auto u = problem.solve(pins.vertices, pins.values);
            if (!u && u.error().code == ErrorCode::not_positive_definite) return;
            ASSERT_EQ(u.ok(), eliminated.ok());
            if (!u) {
                EXPECT_EQ(u.error().code, ErrorCode::unconstrained_component);
                EXPECT_EQ(u.error().element, eliminated.error().element);
                EXPECT_EQ(u.error().message, eliminated.error().message);
                continue;
            }
            EXPECT_LE(distance(*u, get(eliminated->solve(pins.values)).col(0)), 1e-9) << count << " pins";
        }
    });
}

TEST(PinnedProblem, AnySubsetOfThePinsInAnyOrder) {
    for (const char* name : {"wavy-6", "three-quads-on-an-edge"}) {
        const SparseMatrix s = stiffness(specimen(name));
        const auto n = static_cast<Index>(s.rows());
        auto problem = get(PinnedProblem::create(s));
        for (unsigned subset = 1; subset < 1U << n; ++subset) {
            Pins pins;
            for (Index k = 0; k < n; ++k) {
                const Index v = subset % 3 == 0 ? k : n - 1 - k;
                if ((subset >> v & 1U) != 0) pins.vertices.push_back(v);
            }
            pins.values = Vector::LinSpaced(static_cast<Eigen::Index>(pins.vertices.size()), -1, 2);
            EXPECT_LE(distance(get(problem.solve(pins.vertices, pins.values)), eliminate(s, pins)), 1e-12) << subset;
            pins.values = pins.values.array().square().matrix().eval();  // others at the same pins
            EXPECT_LE(distance(get(problem.solve(pins.vertices, pins.values)), eliminate(s, pins)), 1e-12) << subset;
        }
    }
}

TEST(PinnedProblem, EqualValuesGiveThatValue) {
    const auto torus = specimen("quad-torus-32x16-noisy");
    auto problem = get(PinnedProblem::create(stiffness(torus), torus.positions()));
    for (const double value : {0.1, -3e30, 7e-300}) {
        EXPECT_EQ(get(problem.solve(std::vector<Index>{4, 100, 7, 300}, Vector::Constant(4, value))),
                  Vector::Constant(torus.vertex_count(), value));
    }
}

TEST(PinnedProblem, EveryPartHasItsOwnConstant) {
    const SparseMatrix s = stiffness(specimen("two-components"));  // vertices 0–11 and 12–16
    auto problem = get(PinnedProblem::create(s));
    const auto none = problem.solve(std::vector<Index>{}, Vector());
    ASSERT_FALSE(none.ok());
    EXPECT_EQ(none.error().code, ErrorCode::unconstrained_component);
    const Vector u = get(problem.solve(std::vector<Index>{3, 14, 15}, Eigen::Vector3d(7, -2, -2)));
    EXPECT_EQ(u.head(12), Vector::Constant(12, 7));
    EXPECT_EQ(u.tail(5), Vector::Constant(5, -2));
    const Pins mixed{{13, 0, 16, 11, 5}, Vector{{1, 2, 3, 4, 5}}};
    EXPECT_LE(distance(get(problem.solve(mixed.vertices, mixed.values)), eliminate(s, mixed)), 1e-13);

    for (const auto& [pins, element] : {std::pair(std::vector<Index>{3}, 12), std::pair(std::vector<Index>{16, 13}, 0),
                                        std::pair(std::vector<Index>{}, 0)}) {
        const auto open = problem.solve(pins, Vector::Zero(static_cast<Eigen::Index>(pins.size())));
        ASSERT_FALSE(open.ok());
        EXPECT_EQ(open.error().code, ErrorCode::unconstrained_component);
        EXPECT_EQ(open.error().element, element);
    }
}

TEST(PinnedProblem, UnreferencedVerticesAreNobodys) {
    const auto& mesh = specimen("unreferenced-vertices");  // 0 and 4 in no face
    for (const OperatorInfo* info : operators()) {
        const auto matrices = get(build_operator(mesh, {info->id, {}}));
        if (!suits({info->id, {}}, matrices)) continue;
        auto problem = get(PinnedProblem::create(matrices.stiffness, mesh.positions()));
        const Vector u = get(problem.solve(std::vector<Index>{1, 4}, Eigen::Vector2d(3, 8)));
        EXPECT_TRUE(std::isnan(u[0]));
        EXPECT_EQ(u[4], 8);
        for (const Index v : {1, 2, 3, 5}) {
            EXPECT_EQ(u[v], 3);
        }
    }
}

TEST(PinnedProblem, OfAnyScale) {
    const SparseMatrix s = stiffness(specimen("hexagon-sphere-2"));
    const Pins pins{{0, 1, 2, 50}, Vector{{0.25, -1, 2, 0.5}}};
    const Vector expected = eliminate(s, pins);
    for (const double scale : {1e-30, 1.0, 1e30}) {
        auto problem = get(PinnedProblem::create(scale * s));
        EXPECT_LE(distance(get(problem.solve(pins.vertices, pins.values)), expected), 1e-12) << scale;
        for (const double of_values : {1e-30, 1e30}) {
            const Vector u = get(problem.solve(pins.vertices, of_values * pins.values));
            EXPECT_LE(distance(u / of_values, expected), 1e-12) << scale << ", " << of_values;
        }
    }
}

// Two vertices joined 1e10 times as strongly as the rest, far from the ground: their potentials agree in ten digits.
TEST(PinnedProblem, RefusesPinsWhoseDifferenceIsLost) {
    constexpr Index n = 30;
    Matrix path = Matrix::Zero(n, n);
    for (Index i = 0; i + 1 < n; ++i) {
        const double weight = i == 25 ? 1e12 : i == 10 ? 1e10 : 1;
        path(i, i) += weight;
        path(i + 1, i + 1) += weight;
        path(i, i + 1) = path(i + 1, i) = -weight;
    }
    auto problem = get(PinnedProblem::create(path.sparseView()));
    const auto u = problem.solve(std::vector<Index>{10, 11}, Eigen::Vector2d(0, 1));
    ASSERT_FALSE(u.ok());
    EXPECT_EQ(u.error().code, ErrorCode::not_converged);
    const Vector line = get(problem.solve(std::vector<Index>{0, 10}, Eigen::Vector2d(0, 1)));  // others are fine
    for (Index i = 0; i <= 10; ++i) {
        EXPECT_NEAR(line[i], i / 10.0, 1e-9);
    }
}

TEST(PinnedProblem, RefusesBadPinsAndValues) {
    auto problem = get(PinnedProblem::create(stiffness(specimen("grid-2x2"))));
    const auto expect_refused = [&](std::vector<Index> pins, const Vector& values, const char* word) {
        const auto u = problem.solve(pins, values);
        ASSERT_FALSE(u.ok());
        EXPECT_EQ(u.error().code, ErrorCode::bad_argument);
        EXPECT_NE(u.error().message.find(word), std::string::npos) << u.error().message;
    };
    const Vector expected = get(problem.solve(std::vector<Index>{0, 8}, Eigen::Vector2d(0, 1)));
    expect_refused({0, 9}, Eigen::Vector2d(0, 1), "9");
    expect_refused({-1}, Vector::Zero(1), "-1");
    expect_refused({2, 5, 2}, Vector::Zero(3), "2");
    expect_refused({0, 8}, Vector::Zero(3), "3");
    expect_refused({0, 8}, Eigen::Vector2d(nan, 0), "vertex 0");
    expect_refused({0, 8}, Eigen::Vector2d(0, infinity), "vertex 8");
    expect_refused({0, 8}, Eigen::Vector2d(-1.7e308, 1.7e308), "too far apart");
    EXPECT_EQ(get(problem.solve(std::vector<Index>{0, 8}, Eigen::Vector2d(0, 1))), expected);

    EXPECT_EQ(PinnedProblem::create(SparseMatrix(5, 3)).error().code, ErrorCode::bad_argument);
    EXPECT_EQ(PinnedProblem::create(SparseMatrix(5, 5), Points::Zero(4, 3)).error().code, ErrorCode::bad_argument);
}

TEST(PinnedProblem, StopsWhenToldTo) {
    const auto torus = specimen("quad-torus-32x16");
    const SparseMatrix s = stiffness(torus);
    std::mt19937 random(5);
    const Pins pins = random_pins(torus.vertex_count(), 40, random);
    Ticks all;
    get(get(PinnedProblem::create(s)).solve(pins.vertices, pins.values, all.monitor()));
    EXPECT_TRUE(all.rise());
    ASSERT_GE(all.fractions.size(), 3U);

    for (std::size_t stop = 1; stop <= all.fractions.size(); ++stop) {
        auto fresh = get(PinnedProblem::create(s));
        Ticks ticks;
        ticks.stop_at = stop;
        const auto u = fresh.solve(pins.vertices, pins.values, ticks.monitor());
        ASSERT_FALSE(u.ok()) << stop;
        EXPECT_EQ(u.error().code, ErrorCode::cancelled);
        EXPECT_LE(distance(get(fresh.solve(pins.vertices, pins.values)), eliminate(s, pins)), 1e-12);
    }
}

TEST(PinnedProblem, SharesTheAnalysisOfOtherFactors) {
    const auto& mesh = specimen("unreferenced-vertices");
    const SparseMatrix s = stiffness(mesh);
    const auto first = get(PinnedProblem::create(s, mesh.positions()));
    const std::shared_ptr<const SpdAnalysis> other =
        get(SpdAnalysis::create(stiffness(specimen("grid-2x2")), specimen("grid-2x2").positions()));
    const std::vector<std::shared_ptr<const SpdAnalysis>> known{nullptr, other, first.analysis()};
    EXPECT_EQ(get(PinnedProblem::create(2 * s, mesh.positions(), known)).analysis(), first.analysis());
    EXPECT_NE(get(PinnedProblem::create(s, mesh.positions(), std::span(known).first(2))).analysis(), other);
}

// A few pins pay, half of the vertices do not; what is known already costs nothing.
TEST(PinnedProblem, PaysForFewNewPins) {
    const auto torus = specimen("quad-torus-32x16");
    auto problem = get(PinnedProblem::create(stiffness(torus), torus.positions()));
    std::vector<Index> pins(256);
    std::iota(pins.begin(), pins.end(), 100);
    const std::span<const Index> all(pins);
    EXPECT_TRUE(problem.pays(all.first(2)));
    EXPECT_TRUE(problem.pays(all.first(40)));
    EXPECT_FALSE(problem.pays(all));
    EXPECT_FALSE(problem.pays(all.first(120)));
    get(problem.solve(all.first(120), Vector::Zero(120)));
    EXPECT_TRUE(problem.pays(all.first(120)));
    EXPECT_TRUE(problem.pays(all.subspan(110, 30)));
    get(problem.solve(all.subspan(110, 30), Vector::Zero(30)));
    EXPECT_TRUE(problem.pays(all.first(120))) << "potentials of pins that went are kept";

    EXPECT_TRUE(PinnedProblem::may_pay(16, 1 << 20));
    EXPECT_FALSE(PinnedProblem::may_pay(17, 1 << 20)) << "of memory";
    EXPECT_TRUE(PinnedProblem::may_pay(40, 512));
    EXPECT_FALSE(PinnedProblem::may_pay(256, 512)) << "of time";
    EXPECT_FALSE(PinnedProblem::may_pay(std::size_t{1} << 40, std::numeric_limits<Index>::max()));
}

}  // namespace
}  // namespace polylap::test

// Matrices worked out by hand. Signs: S = Σ w (…), so an edge of weight w appears as -w off the diagonal.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "polylap/apply/diagnostics.hpp"
#include "polylap/operators/alexa_wardetzky.hpp"
#include "polylap/operators/mass.hpp"
#include "polylap/operators/planar.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

constexpr TriangulationRule rules[] = {TriangulationRule::delaunay, TriangulationRule::min_max_angle,
                                       TriangulationRule::shortest_diagonal, TriangulationRule::fan};

const std::vector<Vector3> unit_square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

Matrix aw(const PolygonMesh& mesh, double lambda) {
    return get(alexa_wardetzky_stiffness(mesh, {lambda}));
}
Matrix planar(const PolygonMesh& mesh, TriangulationRule rule) {
    return get(planar_stiffness(mesh, {rule}));
}

void expect_equal(const Matrix& actual, const Matrix& expected, double tolerance = 1e-14) {
    ASSERT_EQ(actual.rows(), expected.rows());
    ASSERT_EQ(actual.cols(), expected.cols());
    EXPECT_LE((actual - expected).cwiseAbs().maxCoeff(), tolerance) << "is\n" << actual << "\nnot\n" << expected;
}

// Alexa–Wardetzky on the unit square about its centre: B = (0,-½), (½,0), (0,½), (-½,0) and |a| = 1. (δᵀB)ᵢ = Bᵢ₋₁ - Bᵢ
// gives
// (-½,½), (-½,-½), (½,-½), (½,½), whose products are ½ on the diagonal, 0 along edges, -½ across. ker Ēᵀ is spanned by
// (1,1,1,1)/2, which δᵀ kills, and c = (1,-1,1,-1)/2 with δᵀc = (-1,1,-1,1): λ on the diagonal and across, -λ along
// edges.
TEST(HandDerived, AlexaWardetzkyOnTheUnitSquare) {
    for (const double l : {0.0, 0.25, 0.5, 1.0, 2.0, 7.5}) {
        Matrix expected(4, 4);
        expected << 0.5 + l, -l, -0.5 + l, -l,  //
            -l, 0.5 + l, -l, -0.5 + l,          //
            -0.5 + l, -l, 0.5 + l, -l,          //
            -l, -0.5 + l, -l, 0.5 + l;
        expect_equal(aw(make_face(unit_square), l), expected, 1e-14 * (1 + l));
    }
}

// Any diagonal of the square makes two right isosceles triangles: ½ cot 45° = ½ along the edges, ½ (cot 90° + cot 90°)
// = 0 across.
TEST(HandDerived, PlanarOnTheUnitSquare) {
    Matrix expected(4, 4);
    expected << 1, -0.5, 0, -0.5,  //
        -0.5, 1, -0.5, 0,          //
        0, -0.5, 1, -0.5,          //
        -0.5, 0, -0.5, 1;
    for (const TriangulationRule rule : rules) {
        expect_equal(planar(make_face(unit_square), rule), expected);
    }
}

// Equilateral triangle: every edge has ½ cot 60° = 1/(2√3).
TEST(HandDerived, EquilateralTriangle) {
    const double w = 1 / (2 * std::sqrt(3.0));
    Matrix expected(3, 3);
    expected << 2 * w, -w, -w, -w, 2 * w, -w, -w, -w, 2 * w;
    const auto mesh = make_face({{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(3.0) / 2, 0}});
    for (const double lambda : {0.0, 1.0, 5.0}) {
        expect_equal(aw(mesh, lambda), expected);
    }
    for (const TriangulationRule rule : rules) {
        expect_equal(planar(mesh, rule), expected);
    }
}

// Trapezium 0 (-2,0), 1 (2,0), 2 (1,1), 3 (-1,1), |a| = 3. About (0,½): B = (0,-½), (1.5,0), (0,½), (-1.5,0), so that
// (δᵀB)ᵢ = Bᵢ₋₁ - Bᵢ is
// (-1.5,½), (-1.5,-½), (1.5,-½), (1.5,½); their products over |a| are `gradient`.
// Edges (4,0), (-1,1), (-2,0), (-1,-1): c in ker Ēᵀ has c₁ = c₃ and 4c₀ = 2c₁ + 2c₂; orthogonal to (1,1,1,1), which δᵀ
// kills, it is (1,-3,5,-3)/√44, and (δᵀc)ᵢ = cᵢ₋₁ - cᵢ is (-4,4,-8,8)/√44.
TEST(HandDerived, AlexaWardetzkyOnTheTrapezium) {
    const auto mesh = make_face({{-2, 0, 0}, {2, 0, 0}, {1, 1, 0}, {-1, 1, 0}});
    Matrix gradient(4, 4);
    gradient << 2.5, 2, -2.5, -2,  //
        2, 2.5, -2, -2.5,          //
        -2.5, -2, 2.5, 2,          //
        -2, -2.5, 2, 2.5;
    gradient /= 3;
    Vector c(4);
    c << -4, 4, -8, 8;
    c /= std::sqrt(44.0);
    for (const double lambda : {0.0, 0.5, 1.0, 3.0}) {
        expect_equal(aw(mesh, lambda), gradient + lambda * c * c.transpose(), 1e-13);
    }
}

// The trapezium cut along 0–2: triangle 012 has cot γ₀ = 3, cot γ₁ = 1, cot γ₂ = -½ (edges 2→0 = (-3,-1), 2→1 = (1,-1):
// dot -2, cross 4); triangle 023 has cot γ₀ = 2 ((3,1)·(1,1) = 4, cross 2), cot γ₂ = 3 ((-3,-1)·(-2,0) = 6, cross 2),
// cot γ₃ = -1. Weights ½ cot: w₀₁ = -¼, w₁₂ = 3/2, w₂₃ = 1, w₃₀ = 3/2, w₀₂ = ½ (1 - 1) = 0: its corners lie on a
// circle, so every rule has the same matrix.
TEST(HandDerived, PlanarOnTheTrapezium) {
    const auto mesh = make_face({{-2, 0, 0}, {2, 0, 0}, {1, 1, 0}, {-1, 1, 0}});
    Matrix expected(4, 4);
    expected << 1.25, 0.25, 0, -1.5,  //
        0.25, 1.25, -1.5, 0,          //
        0, -1.5, 2.5, -1,             //
        -1.5, 0, -1, 2.5;
    for (const TriangulationRule rule : rules) {
        expect_equal(planar(mesh, rule), expected);
    }
}

// Quad 0 (0,0), 1 (1.6,.15), 2 (1.9,1), 3 (-.1,.9).
// Cut 1–3, opposite angles at 0 and 2: cot γ₀ = (1.6·-.1 + .15·.9)/(1.6·.9 + .15·.1) = -.025/1.455;
// cot γ₂ = ((-2)(-.3) + (-.1)(-.85))/((-2)(-.85) - (-.1)(-.3)) = .685/1.67. w₁₃ = ½ (.685/1.67 - .025/1.455) =
// 0.19649835… Cut 0–2, opposite angles at 1 and 3: cot γ₁ = (.3·-1.6 + .85·-.15)/(.3·-.15 + .85·1.6) = -.6075/1.315;
// cot γ₃ = (.1·2 - .9·.1)/(.1·.1 + .9·2) = .11/1.81. w₀₂ = ½ (.11/1.81 - .6075/1.315) = -0.20060148…
TEST(HandDerived, TheDiagonalOfAQuad) {
    const auto mesh = make_face({{0, 0, 0}, {1.6, 0.15, 0}, {1.9, 1, 0}, {-0.1, 0.9, 0}});
    const double delaunay = 0.5 * (0.685 / 1.67 - 0.025 / 1.455);
    const double cut = 0.5 * (0.11 / 1.81 - 0.6075 / 1.315);
    ASSERT_NEAR(delaunay, 0.1965, 5e-5);
    ASSERT_NEAR(cut, -0.2006, 5e-5);

    const Matrix best = planar(mesh, TriangulationRule::delaunay);
    EXPECT_NEAR(best(1, 3), -delaunay, 1e-14);
    EXPECT_EQ(best(0, 2), 0);
    // The angles of cut 0–2 include one of 114.8° at corner 1, those of cut 1–3 none above 91°; diagonal 1–3 is also
    // the shorter one.
    expect_equal(planar(mesh, TriangulationRule::min_max_angle), best);
    expect_equal(planar(mesh, TriangulationRule::shortest_diagonal), best);

    const Matrix fan = planar(mesh, TriangulationRule::fan);
    EXPECT_NEAR(fan(0, 2), -cut, 1e-14);
    EXPECT_EQ(fan(1, 3), 0);
}

// Regular n-gon of circumradius 1, cut anywhere: an edge is seen from the others under π/n, so w = ½ cot(π/n);
// diagonals are cocircular: 0.
TEST(HandDerived, PlanarOnRegularPolygons) {
    for (const int n : {5, 6}) {
        const double w = 0.5 / std::tan(std::numbers::pi / n);
        Matrix expected = Matrix::Zero(n, n);
        for (int i = 0; i < n; ++i) {
            expected(i, i) = 2 * w;
            expected(i, (i + 1) % n) = expected((i + 1) % n, i) = -w;
        }
        for (const TriangulationRule rule : rules) {
            expect_equal(planar(make_face(regular_polygon(n)), rule), expected, 1e-13);
        }
    }
}

// On a regular n-gon δ is diagonal in the Fourier basis: mode k has |1 - ω^k|² = 4 sin²(πk/n). Modes ±1 are x and y,
// whose energies are the area, A = (n/2) sin(2π/n), over |x|² = n/2: eigenvalue sin(2π/n). All others (but the
// constants) get λ · 4 sin²(πk/n). S_ij = (1/n) Σ_k μ_k cos(2πk(i-j)/n).
TEST(HandDerived, AlexaWardetzkyOnRegularPolygons) {
    const double pi = std::numbers::pi;
    for (const int n : {4, 5, 6, 11}) {
        for (const double lambda : {0.0, 0.5, 1.0, 2.0}) {
            Matrix expected = Matrix::Zero(n, n);
            for (int k = 1; k < n; ++k) {
                const bool linear = k == 1 || k == n - 1;
                const double mu = linear ? std::sin(2 * pi / n) : lambda * 4 * std::pow(std::sin(pi * k / n), 2);
                for (int i = 0; i < n; ++i) {
                    for (int j = 0; j < n; ++j) {
                        expected(i, j) += mu / n * std::cos(2 * pi * k * (i - j) / n);
                    }
                }
            }
            expect_equal(aw(make_face(regular_polygon(n)), lambda), expected, 1e-13);
        }
    }
}

// Four unit quads, 1 at the middles of the sides and 0 at the corners. Each square joins the centre to two middles by
// its edges (each of two squares: weight 2λ) and to one corner by its diagonal (½ - λ), so that the centre gets
// 4·2λ / (4·2λ + 4(½ - λ)) = 4λ/(1 + 2λ). The planar operator has no diagonals: 1; so has the umbrella.
TEST(HandDerived, TheCentreOfFourSquares) {
    const auto& mesh = specimen("grid-2x2");
    const auto centre = [](const Matrix& s) {
        double sum = 0;
        for (const int v : {1, 3, 5, 7}) {
            sum -= s(4, v);
        }
        return sum / s(4, 4);
    };
    ASSERT_EQ((mesh.position(4) - Vector3(0.5, 0.5, 0)).norm(), 0) << "vertex 4 is the centre";
    for (const double l : {0.25, 0.5, 1.0, 2.0}) {
        EXPECT_NEAR(centre(aw(mesh, l)), 4 * l / (1 + 2 * l), 1e-14);
    }
    EXPECT_NEAR(centre(planar(mesh, TriangulationRule::delaunay)), 1, 1e-14);
    EXPECT_NEAR(centre(Matrix(get(build_operator(mesh, {"cotan", {}})).stiffness)), 1, 1e-14);
    EXPECT_NEAR(centre(Matrix(get(build_operator(mesh, {"umbrella", {}})).stiffness)), 1, 1e-14);
}

// λ = 1 makes both diagonals of every quad negative, ½ - λ on squares: 4F ordered pairs, plus some edges.
TEST(HandDerived, NegativeWeightsOfAClosedQuadMesh) {
    for (const char* name : {"quad-torus-32x16", "quad-torus-32x16-noisy"}) {
        const auto& mesh = specimen(name);
        const SparseMatrix s = get(alexa_wardetzky_stiffness(mesh, {1}));
        Index diagonals = 0;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            diagonals += s.coeff(mesh.face(f)[0], mesh.face(f)[2]) > 0 ? 2 : 0;
            diagonals += s.coeff(mesh.face(f)[1], mesh.face(f)[3]) > 0 ? 2 : 0;
        }
        EXPECT_NEAR(diagonals, 4 * mesh.face_count(), 0.02 * mesh.face_count()) << name;
        const Index all = summarise_weights(s).negative_ordered;
        EXPECT_GE(all, diagonals) << name;
        EXPECT_LE(all, 5 * mesh.face_count()) << name;
    }
}

// 0 (0,0,0), 1 (1,0,0), 2 (1,1,1), 3 (0,1,0), fan from 0: the triangle 012 in space has its right angle at 1 and legs 1
// and √2, so that w₀₁ = ½ cot γ₂ = √½, w₁₂ = ½ cot γ₀ = ½ √½ and w₀₂ = 0; the triangle 023 is its mirror image.
TEST(HandDerived, CotanOfALiftedSquare) {
    const auto mesh = make_face({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}});
    const double w = std::sqrt(0.5);
    Matrix expected(4, 4);
    expected << 2 * w, -w, 0, -w,  //
        -w, 1.5 * w, -0.5 * w, 0,  //
        0, -0.5 * w, w, -0.5 * w,  //
        -w, 0, -0.5 * w, 1.5 * w;
    const auto spec = get(make_spec("cotan", std::vector<std::pair<std::string, std::string>>{{"rule", "fan"}}));
    expect_equal(Matrix(get(build_operator(mesh, spec)).stiffness), expected);
}

// Each corner gets |a|/n: a unit square next to a triangle of area ½.
TEST(HandDerived, LumpedMass) {
    const auto mesh =
        make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {7, 7, 7}}, {{0, 1, 2, 3}, {1, 4, 2}});
    const SparseMatrix m = get(lumped_mass(mesh));
    Vector expected(6);
    expected << 1.0 / 4, 1.0 / 4 + 1.0 / 6, 1.0 / 4 + 1.0 / 6, 1.0 / 4, 1.0 / 6, 0;
    expect_equal(Matrix(m), expected.asDiagonal());
}

}  // namespace
}  // namespace polylap::test

// Rows of vertices and reports of faces: by hand, and against the matrices they come from.

#include <cmath>
#include <map>

#include "operator_cases.hpp"
#include "polylap/apply/inspect.hpp"
#include "session_fixture.hpp"

namespace polylap::test {
namespace {

const std::vector<Vector3> unit_square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

OperatorSpec spec_of(std::string_view id, const std::vector<std::pair<std::string, std::string>>& settings = {}) {
    return get(make_spec(id, settings));
}

TEST(Row, IsThatOfTheMatrixWhetherItIsSymmetricOrNot) {
    for_all([](const Specimen& s, const OperatorSpec&, const OperatorMatrices& matrices, double) {
        const Matrix dense(matrices.stiffness);
        for (Index v = 0; v < s.mesh.vertex_count(); v += 1 + s.mesh.vertex_count() / 7) {
            const MatrixRow row = row_of(matrices, v);
            ASSERT_EQ(row.columns.size(), row.values.size());
            EXPECT_TRUE(std::is_sorted(row.columns.begin(), row.columns.end()));
            EXPECT_EQ(std::count(row.columns.begin(), row.columns.end(), v), 1);
            Matrix rebuilt = Matrix::Zero(1, dense.cols());
            for (std::size_t k = 0; k < row.columns.size(); ++k) {
                rebuilt(0, row.columns[k]) = row.values[k];
                EXPECT_TRUE(row.values[k] != 0 || row.columns[k] == v);
            }
            EXPECT_EQ(rebuilt, dense.row(v));
            EXPECT_EQ(row.mass, matrices.mass.coeff(v, v));
        }
    });
}

TEST(Row, LeadsFromTheVertexToEachOther) {
    for (const OperatorSpec& spec : all_specs()) {
        Session session = open_mesh(noisy_torus());
        check(session.set_operator(Side::b, spec));
        const auto row = session.row(Side::b, 17);
        if (!row) continue;
        const auto& [columns, values, mass] = row->entries;
        const auto place = [&](std::size_t at) {
            return Vector3(row->segments[at], row->segments[at + 1], row->segments[at + 2]);
        };
        const auto vertex = [&](Index v) -> Vector3 { return session.mesh().position(v) - session.origin(); };
        std::map<Index, double> lengths;
        std::map<Index, Vector3> last;
        for (std::size_t s = 0; s < row->segment_pairs.size(); ++s) {
            const Index pair = row->segment_pairs[s];
            if (row->segment_starts[s] == 0) {
                EXPECT_LT((place(6 * s) - vertex(17)).norm(), 1e-6);
            }
            last[pair] = place(6 * s + 3);
            lengths[pair] += (place(6 * s + 3) - place(6 * s)).norm();
        }
        EXPECT_EQ(lengths.size() + 1, columns.size()) << spec_name(spec);
        for (const auto& [pair, end] : last) {
            const Index j = columns[static_cast<std::size_t>(pair)];
            EXPECT_NE(j, 17);
            EXPECT_LT((end - vertex(j)).norm(), 1e-6);
            EXPECT_GE(lengths[pair], (vertex(j) - vertex(17)).norm() - 1e-6);
        }
    }
}

TEST(Row, RefusesVerticesThatAreNotThere) {
    Session session = open_mesh(make_face(unit_square));
    for (const Index v : {-1, 4}) {
        const auto row = session.row(Side::a, v);
        ASSERT_FALSE(row.ok());
        EXPECT_EQ(row.error().code, ErrorCode::bad_argument);
    }
}

// See hand_derived_test.cpp for both matrices.
TEST(Face, IsTheUnitSquareByHand) {
    const auto mesh = make_face(unit_square);
    const auto aw = get(inspect_face(mesh, spec_of("alexa-wardetzky", {{"lambda", "1"}}), 0));
    EXPECT_EQ(aw.corners, (std::vector<Index>{0, 1, 2, 3}));
    EXPECT_EQ(aw.vector_area, Vector3(0, 0, 1));
    EXPECT_EQ(aw.normal, Vector3(0, 0, 1));
    EXPECT_EQ(aw.non_planarity, 0);
    ASSERT_EQ(aw.projected.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR((aw.projected[k] - aw.projected[(k + 1) % 4]).norm(), 1, 1e-15);
    }
    EXPECT_TRUE(aw.triangles.empty());
    Matrix expected(4, 4);
    expected << 1.5, -1, 0.5, -1, -1, 1.5, -1, 0.5, 0.5, -1, 1.5, -1, -1, 0.5, -1, 1.5;
    EXPECT_LE((*aw.stiffness - expected).cwiseAbs().maxCoeff(), 1e-14);

    const auto planar = get(inspect_face(mesh, spec_of("planar"), 0));
    EXPECT_EQ(planar.triangles.size(), 2U);
    expected << 1, -0.5, 0, -0.5, -0.5, 1, -0.5, 0, 0, -0.5, 1, -0.5, -0.5, 0, -0.5, 1;
    EXPECT_LE((*planar.stiffness - expected).cwiseAbs().maxCoeff(), 1e-14);
}

// Corners ± h above a unit square, in turn: their plane is z = 0, |a| = 1, and each is h away.
TEST(Face, SaysHowFarItIsFromAPlane) {
    const double h = 0.125;
    const auto mesh = make_face({{0, 0, h}, {1, 0, -h}, {1, 1, h}, {0, 1, -h}});
    const auto face = get(inspect_face(mesh, spec_of("planar"), 0));
    EXPECT_LE((face.vector_area - Vector3(0, 0, 1)).norm(), 1e-15);
    EXPECT_NEAR(face.non_planarity, h, 1e-15);
}

TEST(Face, AddsUpToTheMatrixWhereTheOperatorIsASumOverFaces) {
    for_all(
        [](const Specimen& s, const OperatorSpec& spec, const OperatorMatrices& matrices, double scale) {
            const OperatorInfo& info = *get(find_operator(spec.id));
            Matrix sum = Matrix::Zero(s.mesh.vertex_count(), s.mesh.vertex_count());
            for (Index f = 0; f < s.mesh.face_count(); ++f) {
                const auto face = get(inspect_face(s.mesh, spec, f));
                ASSERT_EQ(face.stiffness.has_value(), info.sum_over_faces) << face.no_stiffness;
                EXPECT_EQ(face.no_stiffness.empty(), info.sum_over_faces);
                EXPECT_EQ(face.triangles.size(), info.rule == nullptr ? 0 : face.corners.size() - 2);
                if (!face.stiffness) continue;
                for (std::size_t i = 0; i < face.corners.size(); ++i)
                    for (std::size_t j = 0; j < face.corners.size(); ++j)
                        sum(face.corners[i], face.corners[j]) +=
                            (*face.stiffness)(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            }
            if (info.sum_over_faces) {
                EXPECT_LE((sum - Matrix(matrices.stiffness)).cwiseAbs().maxCoeff(), 1e-13 * scale);
            }
        },
        120);
}

/// Whether S is the sum of what the operator makes of each face alone.
bool adds_up(const PolygonMesh& mesh, const OperatorSpec& spec, const SparseMatrix& stiffness) {
    Matrix sum = Matrix::Zero(mesh.vertex_count(), mesh.vertex_count());
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        std::vector<Vector3> corners;
        for (const Index v : face)
            corners.push_back(mesh.position(v));
        const auto alone = build_operator(make_face(corners), spec);
        if (!alone) return false;
        for (std::size_t i = 0; i < face.size(); ++i)
            for (std::size_t j = 0; j < face.size(); ++j)
                sum(face[i], face[j]) += alone->stiffness.coeff(static_cast<Index>(i), static_cast<Index>(j));
    }
    return (sum - Matrix(stiffness)).cwiseAbs().maxCoeff() < 1e-6 * largest(stiffness);
}

TEST(Face, HasNoMatrixWhereTheOperatorIsNoSumOverFaces) {
    for (const OperatorInfo* info : operators()) {
        if (info->sum_over_faces) continue;
        const OperatorSpec spec = spec_of(info->id);
        EXPECT_TRUE(std::any_of(zoo().begin(), zoo().end(), [&](const Specimen& s) {
            const auto matrices = s.mesh.vertex_count() > 120 ? std::nullopt : try_build(s.mesh, spec);
            return matrices && !adds_up(s.mesh, spec, matrices->stiffness);
        })) << info->id;
    }
}

TEST(Face, ThatCannotBeCutSaysWhy) {
    // A bow tie with one wing larger: an area, but the outline crosses itself.
    const auto mesh = make_face({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 1, 0}});
    const auto face = get(inspect_face(mesh, spec_of("planar"), 0));
    EXPECT_FALSE(face.stiffness.has_value());
    EXPECT_FALSE(face.no_stiffness.empty());
    EXPECT_EQ(face.no_stiffness.find("face 0"), std::string::npos) << face.no_stiffness;
    EXPECT_TRUE(face.triangles.empty());
    EXPECT_EQ(face.projected.size(), 4U);
}

TEST(Face, OfNoAreaHasNoNormal) {
    const auto mesh = make_face({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    const auto face = get(inspect_face(mesh, spec_of("alexa-wardetzky"), 0));
    EXPECT_EQ(face.normal, Vector3(0, 0, 0));
    EXPECT_TRUE(face.projected.empty());
    EXPECT_FALSE(face.stiffness.has_value());
    EXPECT_NE(face.no_stiffness.find("area"), std::string::npos);
}

TEST(Face, OfManyCornersIsToldWithoutAMatrix) {
    const int n = most_inspected_corners;
    EXPECT_TRUE(get(inspect_face(make_face(regular_polygon(n)), spec_of("planar"), 0)).stiffness.has_value());
    const auto face = get(inspect_face(make_face(regular_polygon(n + 1)), spec_of("planar"), 0));
    EXPECT_FALSE(face.stiffness.has_value());
    EXPECT_EQ(face.triangles.size(), static_cast<std::size_t>(n - 1));
}

// With cotangents in space, Σ xᵀ S x is twice the area of the triangles [Pinkall & Polthier 1993]; planar faces keep
// it.
TEST(Energy, IsTwiceTheArea) {
    for (const Specimen& s : zoo()) {
        Session session = open_mesh(s.mesh);
        for (const char* id : {"cotan", "planar"}) {
            check(session.set_operator(Side::a, spec_of(id)));
            const auto energy = session.energy(Side::a);
            if (!energy) {
                EXPECT_EQ(energy.error().code, ErrorCode::degenerate_face) << s.name;
                continue;
            }
            const bool cut_in_space = only_triangles(s.mesh) || planar_faces(s.mesh);
            if (!cut_in_space) continue;
            EXPECT_NEAR(*energy, 2 * total_area(s.mesh), 1e-10 * total_area(s.mesh)) << id << " on " << s.name;
        }
    }
}

TEST(Energy, FollowsTheSurface) {
    Session session = open_mesh(noisy_torus());
    check(session.set_operator(Side::a, spec_of("alexa-wardetzky")));
    const double before = get(session.energy(Side::a));
    check(session.smooth(Side::a, {.time = 0.01}));
    EXPECT_LT(get(session.energy(Side::a)), 0.95 * before);
    EXPECT_EQ(get(session.energy(Side::b)), get(session.energy(Side::b)));
}

// The five-point star on a grid of unit squares, with its own mass: at least one eigenvalue 0, all within [0, 8].
TEST(Spectrum, IsThatOfTheMatrices) {
    Session session = open_mesh(get(make_shape("grid", std::vector<std::pair<std::string, std::string>>{})));
    check(session.set_operator(Side::b, spec_of("planar")));
    const auto pairs = get(session.spectrum(Side::b, 7));
    const OperatorMatrices& m = *get(session.matrices(Side::b));
    ASSERT_EQ(pairs.values.size(), 7);
    EXPECT_NEAR(pairs.values[0], 0, 1e-10);
    const Matrix left = m.stiffness * pairs.vectors - m.mass * pairs.vectors * pairs.values.asDiagonal();
    EXPECT_LE(left.cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_TRUE(std::is_sorted(pairs.values.begin(), pairs.values.end()));
}

TEST(Spectrum, IsRefusedWhereTheStiffnessIsNotSymmetric) {
    Session session = open_mesh(noisy_torus());
    check(session.set_operator(Side::a, spec_of("tutte")));
    const auto pairs = session.spectrum(Side::a, 3);
    ASSERT_FALSE(pairs.ok());
    EXPECT_EQ(pairs.error().code, ErrorCode::bad_argument);
    EXPECT_NE(pairs.error().message.find("not symmetric"), std::string::npos);
}

TEST(Face, IsRefusedWhereThereIsNone) {
    const auto mesh = make_face(unit_square);
    for (const Index f : {-1, 1}) {
        const auto face = inspect_face(mesh, spec_of("planar"), f);
        ASSERT_FALSE(face.ok());
        EXPECT_EQ(face.error().code, ErrorCode::bad_argument);
    }
}

}  // namespace
}  // namespace polylap::test

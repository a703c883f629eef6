// The claims of convergence, held against the study of every operator of the table.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "apply/refined_families.hpp"
#include "polylap/apply/convergence.hpp"
#include "polylap/face/vector_area.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

bool claimed(Claim claim, bool initial, const ConvergenceStudy& study) {
    switch (claim) {
        case Claim::yes:
            return true;
        case Claim::planar:
            return study.planar_faces;
        case Claim::triangles:
            return study.only_triangles;
        case Claim::some:
            return initial;
        case Claim::no:
            return false;
    }
    return false;
}

TEST(Convergence, HoldsWhereClaimedAndFailsWhereNot) {
    for (const OperatorInfo* info : operators()) {
        const Claim claim = info->claims.convergent.where;
        const OperatorSpec initial = get(make_spec(info->id, {}));
        int held = 0;
        std::string counter_example;
        for (const OperatorSpec& spec : all_specs()) {
            if (spec.id != info->id) continue;
            for (const ConvergenceStudy& study : get(study_convergence(spec))) {
                const bool shrinks =
                    std::none_of(study.levels.begin(), study.levels.end(),
                                 [](const ConvergenceLevel& level) { return level.order <= least_order; });
                EXPECT_EQ(study.converges, study.failure.empty() && shrinks) << spec_name(spec) << ", " << study.family;
                if (claimed(claim, spec == initial, study)) {
                    ++held;
                    EXPECT_TRUE(study.converges)
                        << spec_name(spec) << ", " << study.family << ": order " << study.order << study.failure;
                } else if (!study.converges) {
                    counter_example = spec_name(spec) + ", " + study.family;
                }
            }
        }
        if (claim != Claim::no) {
            EXPECT_GE(held, 2) << info->id;
        }
        // Weights of vertices belong to one mesh: what they break is not seen here.
        if (claim != Claim::yes && !info->takes_vertex_weights) {
            EXPECT_FALSE(counter_example.empty()) << info->id << " converges everywhere: the claim is too weak";
        }
    }
}

TEST(Convergence, IsOfSecondOrderForFiniteElements) {
    const auto studies = get(study_convergence(get(make_spec("planar", {}))));
    ASSERT_EQ(studies.size(), 8u);
    int triangles = 0;
    for (const ConvergenceStudy& study : studies) {
        SCOPED_TRACE(study.family);
        ASSERT_EQ(study.levels.size(), 4u);
        EXPECT_TRUE(std::isnan(study.levels[0].order));
        for (std::size_t k = 1; k < 4; ++k) {
            const ConvergenceLevel& level = study.levels[k];
            const ConvergenceLevel& before = study.levels[k - 1];
            EXPECT_GT(level.vertices, 3 * before.vertices);
            EXPECT_NEAR(before.h / level.h, 2, 0.3);
            EXPECT_NEAR(level.order, std::log(before.error / level.error) / std::log(before.h / level.h), 1e-12);
        }
        EXPECT_EQ(study.order, study.levels[3].order);
        EXPECT_NEAR(study.order, 2, 0.35);
        EXPECT_LT(study.levels[3].error, 2.5e-3);
        EXPECT_TRUE(study.converges);
        EXPECT_TRUE(study.failure.empty());
        triangles += study.only_triangles ? 1 : 0;
        EXPECT_TRUE(study.planar_faces || !study.only_triangles);
    }
    EXPECT_EQ(triangles, 2);
}

// Without stabilisation a closed quad mesh has a checkerboard in its kernel: the study says so and goes on.
TEST(Convergence, SaysWhyAFamilyEnds) {
    int failed = 0;
    for (const ConvergenceStudy& study : get(study_convergence({"alexa-wardetzky", {0}}))) {
        if (study.only_triangles) {
            EXPECT_TRUE(study.converges) << study.family;
        }
        if (study.failure.empty()) continue;
        ++failed;
        EXPECT_FALSE(study.converges);
        EXPECT_NE(study.failure.find("vertices: "), std::string::npos) << study.failure;
    }
    EXPECT_GE(failed, 1);
}

TEST(Convergence, FamiliesAreWhatTheirNamesSay) {
    for (const Family& family : refined_families()) {
        for (int level = 0; level < 3; ++level) {
            const PolygonMesh mesh = get(family.make(level));
            const Topology topology = build_topology(*mesh.connectivity());
            EXPECT_EQ(topology.boundary_vertices.empty(), family.sphere) << family.name;
            EXPECT_TRUE(topology.unreferenced.empty()) << family.name;
            std::vector<Vector3> corners;
            for (Index f = 0; f < mesh.face_count(); ++f) {
                gather_corners(mesh, f, corners);
                const Vector3 up = family.sphere ? mesh.position(mesh.face(f)[0]) : Vector3::UnitZ();
                ASSERT_GT(vector_area(corners).dot(up), 0) << family.name << ", face " << f;
            }
            for (Index v = 0; v < mesh.vertex_count() && family.sphere; ++v) {
                ASSERT_NEAR(mesh.position(v).norm(), 1, 1e-12) << family.name;
            }
        }
    }
}

TEST(Convergence, TellsProgressAndStopsWhenTold) {
    const OperatorSpec spec = get(make_spec("planar", {}));
    Ticks all;
    ASSERT_TRUE(study_convergence(spec, all.monitor()));
    EXPECT_TRUE(all.rise());
    EXPECT_EQ(all.fractions.back(), 1);
    for (const std::size_t stop : {std::size_t{1}, std::size_t{2}, all.fractions.size() / 2, all.fractions.size()}) {
        Ticks some;
        some.stop_at = stop;
        const auto stopped = study_convergence(spec, some.monitor());
        ASSERT_FALSE(stopped);
        EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
        EXPECT_EQ(some.fractions.size(), stop);
    }
}

TEST(Convergence, RefusesWhatIsNoOperator) {
    const auto unknown = study_convergence({"laplace", {}});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::unknown_operator);
    const auto range = study_convergence({"alexa-wardetzky", {-1}});
    ASSERT_FALSE(range);
    EXPECT_EQ(range.error().code, ErrorCode::parameter_out_of_range);
}

}  // namespace
}  // namespace polylap::test

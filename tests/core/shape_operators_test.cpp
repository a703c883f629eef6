// Every operator of the table on every shape of the table, each with its initial parameters.

#include <gtest/gtest.h>

#include "polylap/mesh/shapes.hpp"
#include "polylap/session.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

TEST(ShapesAndOperators, BuildMeasureAndSmoothTogether) {
    for (const ShapeInfo* shape : shapes()) {
        const PolygonMesh mesh = get(make_shape(shape->id));
        Session session = get(Session::from_mesh(mesh));
        const double time = 0.01 * session.shape(Session::Side::a).measures.mean_squared_edge;
        for (const OperatorInfo* info : operators()) {
            SCOPED_TRACE(std::string(info->id) + " on " + shape->id);
            check(session.set_operator(Session::Side::a, get(make_spec(info->id, {}))));
            const OperatorMatrices& matrices = *get(session.matrices(Session::Side::a));
            EXPECT_EQ(matrices.stiffness.rows(), mesh.vertex_count());
            EXPECT_GT(matrices.stiffness.nonZeros(), 0);
            EXPECT_TRUE(matrices.stiffness.coeffs().allFinite());
            const PropertyReport& report = *get(session.check(Session::Side::a));
            EXPECT_EQ(report.measurements.size() + 1, properties().size()) << "all but convergence";
            for (const Measurement& m : report.measurements) {
                const Claim claim = (info->claims.*m.property->claim).where;
                EXPECT_FALSE(claim == Claim::yes && m.verdict == Measurement::Verdict::fails)
                    << m.property->id << ": " << m.text;
            }
            check(session.smooth(Session::Side::a, {.time = time}));
            EXPECT_TRUE(session.surface(Session::Side::a).positions().allFinite());
            session.reset(Session::Side::a);
        }
    }
}

}  // namespace
}  // namespace polylap::test

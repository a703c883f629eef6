#include "polylap/face/vector_area.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "naive.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

TEST(VectorArea, OfKnownFaces) {
    EXPECT_EQ(vector_area(std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), Vector3(0, 0, 1));
    EXPECT_EQ(vector_area(std::vector<Vector3>{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}), Vector3(0, 0, -1));
    EXPECT_EQ(vector_area(std::vector<Vector3>{{0, 0, 0}, {0, 4, 0}, {0, 0, 3}}), Vector3(6, 0, 0));
    const double pi = 3.14159265358979323846;
    EXPECT_NEAR(vector_area(regular_polygon(1000)).z(), 500 * std::sin(2 * pi / 1000), 1e-12);
}

TEST(VectorArea, OfTheSaddleQuadIgnoresItsHeight) {
    for (const double h : {0.0, 0.5, 3.0, 1e6}) {
        const std::vector<Vector3> quad{{0, 0, 0}, {1, 0, h}, {1, 1, 0}, {0, 1, h}};
        EXPECT_NEAR((vector_area(quad) - Vector3(0, 0, 1)).norm(), 0, 1e-12 * (1 + h * h)) << h;
        // Two triangles along 0–2: each has area ½ |(1,0,h) × (1,1,0)| = ½ √(1 + 2h²).
        const double triangles = vector_area(std::vector<Vector3>{quad[0], quad[1], quad[2]}).norm() +
                                 vector_area(std::vector<Vector3>{quad[0], quad[2], quad[3]}).norm();
        EXPECT_NEAR(triangles, std::sqrt(1 + 2 * h * h), 1e-12 * (1 + h));
    }
}

TEST(VectorArea, KeepsItsDigitsFarFromTheOrigin) {
    std::vector<Vector3> quad{{0, 0, 0}, {1, 0, 0.5}, {1, 1, 0}, {0, 1, 0.5}};
    for (Vector3& p : quad) {
        p += Vector3(0x1p40, -0x1p41, 0x1p40);  // exact: the corners keep twelve bits after the point
    }
    EXPECT_EQ(vector_area(quad), Vector3(0, 0, 1));
}

TEST(ZeroArea, IsRelativeToTheFace) {
    const std::vector<Vector3> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    const std::vector<Vector3> bow_tie{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Vector3> point(3, Vector3(1, 2, 3));
    const std::vector<Vector3> thin{{0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}, {0, 1e-9, 0}};
    for (const double scale : {1e-60, 1e-6, 1.0, 1e6, 1e60}) {
        const auto scaled = [&](std::vector<Vector3> face) {
            for (Vector3& p : face) {
                p *= scale;
            }
            return face;
        };
        for (const auto& face : {line, bow_tie, point}) {
            EXPECT_TRUE(has_zero_area(scaled(face), vector_area(scaled(face)))) << scale;
            Projection projection;
            EXPECT_FALSE(project_maximally(scaled(face), projection)) << scale;
        }
        EXPECT_FALSE(has_zero_area(scaled(thin), vector_area(scaled(thin)))) << scale;
    }
}

TEST(Projection, KeepsTheAreaAndTheDistancesInThePlane) {
    std::vector<Vector3> corners;
    Projection projection;
    for (const auto& [name, mesh] : zoo()) {
        for (Index f = 0; f < std::min<Index>(mesh.face_count(), 40); ++f) {
            gather_corners(mesh, f, corners);
            ASSERT_EQ(corners.size(), mesh.face(f).size());
            EXPECT_EQ(corners[1], mesh.position(mesh.face(f)[1]));
            const Vector3 a = vector_area(corners);
            ASSERT_TRUE(project_maximally(corners, projection)) << name;
            ASSERT_EQ(projection.points.size(), corners.size());
            EXPECT_NEAR(projection.area, a.norm(), 1e-13 * a.norm());
            EXPECT_NEAR((projection.normal - a.normalized()).norm(), 0, 1e-13);
            EXPECT_TRUE(projection.points[0].isZero());
            EXPECT_NEAR(naive::area(projection.points), a.norm(), 1e-12 * a.norm()) << name << ": counter-clockwise";
            const Vector3 u = a.normalized();
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const Vector3 d = corners[k] - corners[0];
                EXPECT_NEAR(projection.points[k].squaredNorm(), (d - u.dot(d) * u).squaredNorm(),
                            1e-12 * d.squaredNorm() + 1e-300)
                    << name;
            }
        }
    }
}

}  // namespace
}  // namespace polylap::test

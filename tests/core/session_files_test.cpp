// Session: files of all formats, repairs, and what is measured on a side.

#include <gtest/gtest.h>

#include "polylap/apply/conversions.hpp"
#include "polylap/mesh/shapes.hpp"
#include "session_fixture.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using Side = Session::Side;

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text));
}

TEST(SessionFiles, OpensEveryFormat) {
    const PolygonMesh mesh = get(convert(load_mesh("saddle-12x12"), "triangles"));
    for (const auto& [name, format] : {std::pair("m.obj", MeshFormat::obj), std::pair("m.OFF", MeshFormat::off),
                                       std::pair("m.ply", MeshFormat::ply), std::pair("m.stl", MeshFormat::stl)}) {
        const std::string text = get(write_mesh(mesh, format));
        const Session session = get(Session::open(bytes_of(text), name));
        EXPECT_EQ(session.mesh().face_count(), mesh.face_count()) << name;
        EXPECT_EQ(session.mesh().vertex_count(), mesh.vertex_count()) << name;
        EXPECT_EQ(session.notes().empty(), format != MeshFormat::stl) << name;
        EXPECT_TRUE(session.repairs().changes.empty());
    }
}

TEST(SessionFiles, RepairsOnlyWhenAsked) {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 3 4\nf 4 3 2 1\n";
    const auto refused = Session::open(bytes_of(text), "twice.obj");
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::bad_mesh);
    EXPECT_EQ(refused.error().line, 5);
    EXPECT_EQ(refused.error().element, 0);
    const Session session = get(Session::open(bytes_of(text), "twice.obj", {.repair = true}));
    EXPECT_EQ(session.mesh().face_count(), 1);
    ASSERT_EQ(session.repairs().changes.size(), 2u);
    EXPECT_EQ(session.repairs().changes[0].kind, RepairChange::Kind::repeated_corners);
    EXPECT_EQ(session.repairs().changes[1].kind, RepairChange::Kind::duplicate_faces);
    EXPECT_EQ(session.repairs().original_vertices, (std::vector<Index>{0, 1, 2, 3}));
    EXPECT_EQ(session.repairs().original_faces, std::vector<Index>{0});
    // What is no mesh at all stays refused.
    EXPECT_FALSE(Session::open(bytes_of("v 0 0 x\n"), "x.obj", {.repair = true}).ok());
}

TEST(SessionFiles, CancelsReadingAndRepairing) {
    const std::string text = get(write_mesh(get(make_grid(120, 120)), MeshFormat::off));
    for (const bool repair : {false, true}) {
        Ticks all;
        get(Session::open(bytes_of(text), "grid.off", {.repair = repair}, all.monitor()));
        EXPECT_TRUE(all.rise());
        Ticks first{.fractions = {}, .stop_at = 1};
        const auto stopped = Session::open(bytes_of(text), "grid.off", {.repair = repair}, first.monitor());
        ASSERT_FALSE(stopped.ok());
        EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
    }
}

TEST(SessionMeasures, ChecksTheOperatorOfTheSide) {
    Session session = get(Session::from_mesh(load_mesh("quad-torus-32x16-noisy")));
    check(session.set_operator(Side::a, get(make_spec("alexa-wardetzky", {}))));
    check(session.set_operator(Side::b, get(make_spec("planar", {}))));
    const PropertyReport* a = get(session.check(Side::a));
    EXPECT_EQ(a->negative_ordered, 2048);
    EXPECT_EQ(get(session.check(Side::a)), a) << "kept while nothing has changed";
    EXPECT_EQ(get(session.check(Side::b))->negative_ordered, 0);
    check(session.smooth(Side::a, {.time = 1e-3}));
    const PropertyReport* moved = get(session.check(Side::a));
    EXPECT_NE(moved->largest_eigenvalue, 0);
    session.reset(Side::a);
    Ticks stop{.fractions = {}, .stop_at = 1};
    check(session.set_operator(Side::a, {"alexa-wardetzky", {0.25}}));
    const auto stopped = session.check(Side::a, stop.monitor());
    ASSERT_FALSE(stopped.ok());
    EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
}

TEST(SessionMeasures, DualFollowsTheSurfaceOfTheSide) {
    Session session = get(Session::from_mesh(load_mesh("quad-torus-32x16")));
    const OrthogonalDual before = get(session.dual(Side::a));
    EXPECT_EQ(before.null_space, 559);
    check(session.set_operator(Side::a, get(make_spec("planar", {}))));
    check(session.smooth(Side::a, {.time = 1e-3}));
    EXPECT_GT((get(session.dual(Side::a)).vertices - before.vertices).norm(), 1e-6);
    EXPECT_EQ(get(session.dual(Side::b)).vertices, before.vertices);
    EXPECT_FALSE(session.dual(Side::a, {.mu = -1}).ok());
}

}  // namespace
}  // namespace polylap::test

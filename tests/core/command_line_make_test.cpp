// The built command line: making meshes, converting and repairing them, all formats.
#include "command_line.hpp"

#include <nlohmann/json.hpp>

#include "polylap/apply/conversions.hpp"
#include "polylap/apply/noise.hpp"
#include "polylap/mesh/mesh_io.hpp"
#include "polylap/mesh/shapes.hpp"
#include "zoo.hpp"

namespace polylap {
namespace {

using nlohmann::json;
using test::get;

PolygonMesh load(const std::string& path) {
    const std::string text = slurp(path);
    return get(read_mesh(std::as_bytes(std::span(text)), get(format_of(path))));
}

void expect_same(const PolygonMesh& a, const PolygonMesh& b) {
    EXPECT_EQ(a.connectivity()->offsets, b.connectivity()->offsets);
    EXPECT_EQ(a.connectivity()->corners, b.connectivity()->corners);
    EXPECT_EQ(a.positions(), b.positions());
}

TEST_F(CommandLine, ListsShapesAndConversions) {
    const json listed = json::parse(succeed("shapes --json"));
    ASSERT_EQ(listed.size(), shapes().size());
    for (std::size_t k = 0; k < listed.size(); ++k) {
        EXPECT_EQ(listed[k]["id"], shapes()[k]->id);
        EXPECT_EQ(listed[k]["parameters"].size(), shapes()[k]->parameters.size());
    }
    const std::string text = succeed("shapes");
    for (const ShapeInfo* shape : shapes()) {
        EXPECT_NE(text.find(std::string(shape->id) + "  " + shape->summary), std::string::npos) << shape->id;
    }
    EXPECT_EQ(json::parse(succeed("conversions --json")).size(), conversions().size());
}

TEST_F(CommandLine, MakesEveryShape) {
    for (const ShapeInfo* shape : shapes()) {
        succeed("make " + std::string(shape->id) + " -o shape.obj");
        expect_same(load(path("shape.obj")), get(make_shape(shape->id)));
    }
}

TEST_F(CommandLine, MakesShapesWithParametersAndNoise) {
    succeed("make torus --set nu=12 --set nv=7 --noise 0.3 --seed 5 -o torus.off");
    const std::vector<std::pair<std::string, std::string>> settings{{"nu", "12"}, {"nv", "7"}};
    expect_same(load(path("torus.off")), get(add_normal_noise(get(make_shape("torus", settings)), 0.3, 5)));
    EXPECT_EQ(fail(1, "make torus --set nu=2 -o x.obj").find("nu must be a whole number between"), 0u);
    EXPECT_NE(fail(1, "make taurus -o x.obj").find("torus"), std::string::npos);
    EXPECT_NE(fail(2, "make torus --set nu -o x.obj").find("name=value"), std::string::npos);
    EXPECT_NE(fail(2, "make torus --noise -0.1 -o x.obj").find("≥ 0"), std::string::npos);
    EXPECT_NE(fail(2, "make torus --noise 0.1 --seed 0.5 -o x.obj").find("whole number"), std::string::npos);
    EXPECT_NE(fail(1, "make torus -o x.doc").find(".obj"), std::string::npos);
    EXPECT_EQ(files(), std::vector<std::string>{"torus.off"});
}

TEST_F(CommandLine, ConvertsBetweenFormats) {
    const PolygonMesh original = load(torus);
    std::string from = torus;
    for (const std::string to : {"a.off", "b.ply", "c.obj"}) {
        succeed("convert '" + from + "' -o " + to);
        expect_same(load(path(to)), original);
        from = to;
    }
    EXPECT_NE(fail(1, "convert '" + torus + "' -o d.stl").find("face 0"), std::string::npos);
    succeed("convert '" + torus + "' --to triangles -o d.stl");
    EXPECT_EQ(load(path("d.stl")).face_count(), 2 * original.face_count());
    EXPECT_NE(succeed("info d.stl").find("note "), std::string::npos) << "welding is said";
}

TEST_F(CommandLine, AppliesEveryConversionAndSeveralInOrder) {
    for (const ConversionInfo* conversion : conversions()) {
        succeed("convert '" + torus + "' --to " + conversion->id + " -o out.obj");
        expect_same(load(path("out.obj")), get(convert(load(torus), conversion->id)));
    }
    succeed("convert '" + torus +
            "' --to quads:rule=catmull-clark --to noise:amplitude=0.2,seed=3 --to dual -o out.obj");
    const std::vector<std::pair<std::string, std::string>> quads{{"rule", "catmull-clark"}},
        noise{{"amplitude", "0.2"}, {"seed", "3"}};
    expect_same(load(path("out.obj")),
                get(convert(get(convert(get(convert(load(torus), "quads", quads)), "noise", noise)), "dual")));
    EXPECT_NE(fail(1, "convert '" + torus + "' --to duel -o x.obj").find("dual"), std::string::npos);
    EXPECT_NE(fail(2, "convert '" + torus + "' --to quads:rule -o x.obj").find("name=value"), std::string::npos);
}

// Vertex 4 is vertex 1 again, face 1 has it twice, face 2 is face 0 again.
constexpr const char* broken =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\n"
    "f 1 2 3 4\nf 5 6 7 3 3\nf 1 2 3 4\n";

TEST_F(CommandLine, RepairsOnRequestOnly) {
    write(path("broken.obj"), broken);
    const std::string refusal = fail(1, "info broken.obj");
    EXPECT_NE(refusal.find("line 9"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("--repair"), std::string::npos) << refusal;

    const json facts = json::parse(succeed("info broken.obj --repair --json"));
    EXPECT_EQ(facts["vertices"], 6);
    EXPECT_EQ(facts["faces"], 2);
    std::map<std::string, json> repairs;
    for (const auto& repair : facts["repairs"]) {
        repairs[repair["kind"]] = repair["elements"];
        EXPECT_NE(repair["message"], "");
    }
    EXPECT_EQ(repairs["merged-vertices"], json({4}));
    EXPECT_EQ(repairs["repeated-corners"], json({1}));
    EXPECT_EQ(repairs["duplicate-faces"], json({2}));
    EXPECT_NE(succeed("info broken.obj --repair").find("repaired "), std::string::npos);

    const std::string told = succeed("convert broken.obj --repair -o fixed.obj --vertex-map map.csv");
    for (const auto& repair : facts["repairs"]) {
        EXPECT_NE(told.find("repaired              " + repair["message"].get<std::string>()), std::string::npos)
            << told;
    }
    EXPECT_EQ(slurp(path("map.csv")), "vertex,original\n0,0\n1,1\n2,2\n3,3\n4,5\n5,6\n");
    EXPECT_EQ(load(path("fixed.obj")).face_count(), 2);
    EXPECT_EQ(json::parse(succeed("info fixed.obj --json"))["issues"], json::array());
    // What no repair can mend is not offered any.
    write(path("text.obj"), "v 0 0 zero\n");
    EXPECT_EQ(fail(1, "info text.obj").find("--repair"), std::string::npos);
}

TEST_F(CommandLine, MergesNearVerticesWhenTold) {
    write(path("near.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1e-7 0\nv 1 1 0\nv 0 1 1e-7\nf 1 2 3\nf 4 5 6\n");
    EXPECT_EQ(json::parse(succeed("info near.obj --repair --json"))["vertices"], 6);
    EXPECT_EQ(json::parse(succeed("info near.obj --repair --merge-distance 1e-6 --json"))["vertices"], 4);
    EXPECT_NE(fail(2, "info near.obj --merge-distance 1e-6").find("--repair"), std::string::npos);
    EXPECT_NE(fail(2, "info near.obj --repair --merge-distance -1").find("≥ 0"), std::string::npos);
}

}  // namespace
}  // namespace polylap

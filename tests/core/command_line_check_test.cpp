// The built command line: properties, convergence, orthogonal duals and vertex weights.
#include "command_line.hpp"

#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "polylap/session.hpp"
#include "zoo.hpp"

namespace polylap {
namespace {

using nlohmann::json;

TEST_F(CommandLine, CheckMeasuresBesideTheClaims) {
    for (const OperatorInfo* info : operators()) {
        const json report = json::parse(succeed("check '" + grid + "' --operator " + info->id + " --json"));
        EXPECT_EQ(report["operator"], info->id);
        EXPECT_GE(report["properties"].size(), 7u);
        for (const auto& [id, property] : report["properties"].items()) {
            EXPECT_NE(property["why"], "") << id;
            EXPECT_NE(property["text"], "") << id;
            EXPECT_FALSE(property["claim"] == "yes" && property["measured"] == "fails") << info->id << id;
        }
    }
}

TEST_F(CommandLine, CheckHasTheKnownFigures) {
    json report = json::parse(succeed("check '" + torus + "' --operator alexa-wardetzky --json"));
    EXPECT_EQ(report["negativeOrdered"], 2048);
    EXPECT_EQ(report["negativePairs"], 1024);
    EXPECT_EQ(report["properties"]["positiveWeights"]["measured"], "fails");
    EXPECT_EQ(report["properties"]["positiveWeights"]["vertices"].size(), 2u);
    EXPECT_EQ(report["kernelDimension"], 1);
    report = json::parse(succeed("check '" + torus + "' --operator planar --json"));
    EXPECT_EQ(report["negativeOrdered"], 0);
    EXPECT_EQ(report["properties"]["positiveWeights"]["measured"], "holds");

    succeed("make grid --set nx=8 --set ny=8 -o grid.obj");
    report = json::parse(succeed("check grid.obj --operator alexa-wardetzky --set lambda=0 --json --modes modes.csv"));
    EXPECT_EQ(report["kernelDimension"], 2);
    EXPECT_EQ(report["components"], 1);
    std::istringstream rows(slurp(path("modes.csv")));
    std::string row;
    std::getline(rows, row);
    EXPECT_EQ(row, "vertex,mode0,mode1");
    int count = 0;
    double squares = 0;
    while (std::getline(rows, row)) {
        EXPECT_EQ(row.substr(0, row.find(',')), std::to_string(count++));
        squares += std::pow(std::stod(row.substr(row.find(',') + 1)), 2);
    }
    EXPECT_EQ(count, 81);
    EXPECT_NEAR(squares, 1, 1e-12);

    const std::string text = succeed("check '" + torus + "' --operator alexa-wardetzky");
    EXPECT_NE(text.find("2048 ordered, 1024 pairs"), std::string::npos) << text;
    const OperatorInfo& info = **find_operator("alexa-wardetzky");
    for (const PropertyInfo& property : properties()) {
        if (property.claim == &PropertyClaims::convergent) continue;
        EXPECT_NE(text.find(std::string(property.label) + ": "), std::string::npos) << text;
        EXPECT_NE(text.find((info.claims.*property.claim).why), std::string::npos) << text;
    }
    EXPECT_NE(fail(2, "check grid.obj --operator planar --modes -").find("--modes"), std::string::npos);
}

TEST_F(CommandLine, ConvergenceIsStudied) {
    const json study = json::parse(succeed("convergence --operator planar --json"));
    EXPECT_EQ(study["operator"], "planar");
    ASSERT_GE(study["studies"].size(), 2u);
    for (const auto& family : study["studies"]) {
        EXPECT_TRUE(family["converges"]) << family;
        EXPECT_GE(family["levels"].size(), 3u);
        EXPECT_GT(family["order"], 0.5);
    }
    const std::string text = succeed("convergence --operator planar");
    EXPECT_EQ(text.find("claimed: yes, "), 0u) << text;
    EXPECT_NE(text.find("\n  converges\n"), std::string::npos) << text;
    EXPECT_NE(fail(1, "convergence --operator planner").find("planar"), std::string::npos);
}

TEST_F(CommandLine, DualDescribesAndWritesTheOrthogonalDual) {
    const std::string regular = meshes + "quad-torus-32x16.obj";
    const json summary = json::parse(succeed("dual '" + regular + "' --json"));
    EXPECT_EQ(summary["constraints"], 1024);
    EXPECT_EQ(summary["rank"], 977);
    EXPECT_EQ(summary["nullSpace"], 559);
    EXPECT_LE(summary["residual"], 1e-8);
    EXPECT_EQ(summary["usable"], true);
    EXPECT_NE(succeed("dual '" + grid + "'").find("null space            8\n"), std::string::npos);

    succeed("dual '" + grid + "' --json -o dual.json");
    const json dual = json::parse(slurp(path("dual.json")));
    EXPECT_EQ(dual["vertices"].size(), 4u);
    ASSERT_EQ(dual["edges"].size(), 12u);
    for (const auto& edge : dual["edges"]) {
        const bool boundary = edge["faces"][0] == -1 || edge["faces"][1] == -1;
        EXPECT_NEAR(edge["weight"], boundary ? 0.5 : 1, 1e-12);
    }
    const std::string lines = succeed("dual '" + grid + "' -o -");
    int vertices = 0;
    for (auto at = lines.find("\nv "); at != std::string::npos; at = lines.find("\nv ", at + 1))
        ++vertices;
    EXPECT_EQ(vertices, 4 + 12);
    EXPECT_NE(lines.find("\nl "), std::string::npos);
    EXPECT_NE(fail(2, "dual '" + grid + "' --mu -1").find("≥ 0"), std::string::npos);
    EXPECT_EQ(json::parse(succeed("dual '" + grid + "' --json -o -"))["edges"].size(), 12u);
    EXPECT_NE(fail(1, "dual '" + grid + "' -o dual.ply").find(".obj"), std::string::npos);
}

TEST_F(CommandLine, VertexWeightsComeFromAFile) {
    const std::string mesh = meshes + "triangle-sphere-2.obj";
    write(path("weights.csv"), "vertex,weight\n0,0.01\n7,-0.02\n");
    for (const OperatorInfo* info : operators()) {
        const std::string operation =
            "matrix '" + mesh + "' --operator " + info->id + " --weights weights.csv -o S.mtx";
        if (!info->takes_vertex_weights) {
            EXPECT_NE(fail(1, operation).find("takes no vertex weights"), std::string::npos);
            continue;
        }
        succeed(operation);
        const std::string weighted = slurp(path("S.mtx"));
        succeed("matrix '" + mesh + "' --operator " + info->id + " -o S.mtx");
        EXPECT_FALSE(weighted == slurp(path("S.mtx"))) << info->id;
        write(path("zero.csv"), "3,0\n");
        succeed("matrix '" + mesh + "' --operator " + info->id + " --weights zero.csv -o Z.mtx");
        EXPECT_TRUE(slurp(path("Z.mtx")) == slurp(path("S.mtx"))) << info->id;
        write(path("bad.csv"), "3,heavy\n");
        EXPECT_NE(fail(1, "matrix '" + mesh + "' --operator " + info->id + " --weights bad.csv -o B.mtx")
                      .find("the weight of vertex 3 is no finite number"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace polylap

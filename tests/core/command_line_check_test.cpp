// The built command line: properties, convergence, spectra, orthogonal duals and vertex weights.
#include "command_line.hpp"

#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "polylap/mesh/mesh_io.hpp"
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

TEST_F(CommandLine, FaceIsTheUnitSquare) {
    succeed("make grid --set nx=1 --set ny=1 -o square.obj");
    const std::string square = "face square.obj --face 0 --operator ";
    const json face = json::parse(succeed(square + "alexa-wardetzky --set lambda=1 --json"));
    EXPECT_EQ(face["corners"].size(), 4u);
    EXPECT_NEAR(face["vectorArea"][2].get<double>(), face["normal"][2].get<double>(), 1e-15);
    EXPECT_EQ(face["triangles"].size(), 0u);
    EXPECT_NEAR(face["stiffness"][0][0].get<double>(), 1.5, 1e-12);
    EXPECT_NEAR(face["stiffness"][0][2].get<double>(), 0.5, 1e-12);
    EXPECT_EQ(json::parse(succeed(square + "planar --json"))["triangles"].size(), 2u);
    const std::string text = succeed(square + "planar");
    EXPECT_NE(text.find("cut into"), std::string::npos) << text;
    EXPECT_NE(succeed(square + "tutte").find("no sum over faces"), std::string::npos);
    EXPECT_NE(fail(1, "face square.obj --face 1 --operator planar").find("there is no face 1"), std::string::npos);
    EXPECT_NE(fail(2, "face square.obj --operator planar").find("--face"), std::string::npos);
}

TEST_F(CommandLine, OperatorsAreCitedOnce) {
    const std::string entries = succeed("operators --bibtex");
    const json table = json::parse(succeed("operators --json"));
    std::size_t length = 0;
    std::vector<std::string> seen;
    for (const json& entry : table) {
        const auto bibtex = entry["bibtex"].get<std::string>();
        const auto at = entries.find(bibtex);
        ASSERT_NE(at, std::string::npos) << bibtex;
        EXPECT_EQ(entries.find(bibtex, at + 1), std::string::npos) << bibtex;
        if (std::find(seen.begin(), seen.end(), bibtex) != seen.end()) continue;
        seen.push_back(bibtex);
        length += bibtex.size();
    }
    EXPECT_EQ(entries.size(), length + 2 * seen.size() - 1);  // line ends, and empty lines between
    EXPECT_NE(fail(2, "operators --bibtex --json").find("--json"), std::string::npos);
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

// On a sphere ℓ(ℓ+1), each 2ℓ+1 times.
TEST_F(CommandLine, SpectrumFindsTheLowestEigenvalues) {
    succeed("make hexagon-sphere -o sphere.obj");
    const json found = json::parse(succeed("spectrum sphere.obj --operator planar --count 9 --json --modes modes.csv"));
    EXPECT_EQ(found["operator"], "planar");
    ASSERT_EQ(found["pairs"].size(), 9u);
    for (std::size_t k = 0; k < 9; ++k) {
        const double l = k == 0 ? 0 : k < 4 ? 1 : 2;
        EXPECT_NEAR(found["pairs"][k]["eigenvalue"], l * (l + 1), 0.01 * l + 1e-9) << k;
        EXPECT_LE(found["pairs"][k]["residual"], 1e-6) << k;
    }

    const std::string text = slurp(path("sphere.obj"));
    const auto mesh = read_obj(std::as_bytes(std::span(text)));
    ASSERT_TRUE(mesh.ok());
    ASSERT_EQ(found["vertices"], mesh->vertex_count());
    std::istringstream rows(slurp(path("modes.csv")));
    std::string row;
    std::getline(rows, row);
    EXPECT_EQ(row, "vertex,mode0,mode1,mode2,mode3,mode4,mode5,mode6,mode7,mode8");
    Matrix modes(mesh->vertex_count(), 9);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
        ASSERT_TRUE(std::getline(rows, row));
        std::istringstream cells(row);
        std::string cell;
        std::getline(cells, cell, ',');
        EXPECT_EQ(cell, std::to_string(v));
        for (int k = 0; k < 9; ++k) {
            ASSERT_TRUE(std::getline(cells, cell, ','));
            modes(v, k) = std::strtod(cell.c_str(), nullptr);
        }
    }
    EXPECT_FALSE(std::getline(rows, row));
    const auto matrices = build_operator(*mesh, {"planar", {}});
    ASSERT_TRUE(matrices.ok());
    EXPECT_LE((modes.transpose() * matrices->mass * modes - Matrix::Identity(9, 9)).cwiseAbs().maxCoeff(), 1e-9);
    Vector values(9);
    for (int k = 0; k < 9; ++k)
        values[k] = found["pairs"][static_cast<std::size_t>(k)]["eigenvalue"];
    const Matrix residual = matrices->stiffness * modes - matrices->mass * modes * values.asDiagonal();
    EXPECT_LE(residual.cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_GT(modes.colwise().maxCoeff().minCoeff(), 0);
}

TEST_F(CommandLine, SpectrumSaysWhatItFoundAndWhyNot) {
    const std::string table = succeed("spectrum '" + grid + "' --operator alexa-wardetzky --count 100");
    EXPECT_NE(table.find("\n8       "), std::string::npos) << table;  // nine vertices, nine modes
    EXPECT_EQ(table.find("\n9       "), std::string::npos) << table;
    const std::string triangles = "spectrum '" + meshes + "triangle-sphere-2.obj' --operator ";
    EXPECT_NE(succeed(triangles + "cotan").find("\n9       "), std::string::npos);  // ten where nothing is said
    EXPECT_NE(fail(1, triangles + "tutte").find("not symmetric"), std::string::npos);
    EXPECT_NE(fail(1, triangles + "cotan --set mass=galerkin").find("diagonal (lumped) mass"), std::string::npos);
    EXPECT_NE(fail(2, triangles + "cotan --modes -").find("--modes"), std::string::npos);
    EXPECT_NE(fail(2, triangles + "cotan --count 0").find("--count"), std::string::npos);
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

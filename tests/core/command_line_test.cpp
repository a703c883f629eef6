// Runs the built command line, and compares what it writes with the library.
#include "command_line.hpp"

#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "polylap/mesh/mesh_io.hpp"
#include "polylap/session.hpp"

namespace polylap {
namespace {

using nlohmann::json;

PolygonMesh load(const std::string& path) {
    const std::string text = slurp(path);
    auto mesh = read_obj(std::as_bytes(std::span(text)));
    EXPECT_TRUE(mesh.ok()) << mesh.error().message;
    return *std::move(mesh);
}

OperatorSpec spec(const std::string& id, std::vector<std::pair<std::string, std::string>> settings = {}) {
    auto made = make_spec(id, settings);
    EXPECT_TRUE(made.ok()) << made.error().message;
    return *std::move(made);
}

/// Reads `coordinate real` MatrixMarket; a symmetric one is filled up.
SparseMatrix read_matrix_market(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    const bool symmetric = line == "%%MatrixMarket matrix coordinate real symmetric";
    EXPECT_TRUE(symmetric || line == "%%MatrixMarket matrix coordinate real general") << line;
    while (std::getline(lines, line) && line.starts_with('%')) {
    }
    Index rows = 0, columns = 0, count = 0;
    std::istringstream(line) >> rows >> columns >> count;
    std::vector<Eigen::Triplet<double>> entries;
    for (Index k = 0; k < count; ++k) {
        Index i = 0, j = 0;
        std::string value;
        EXPECT_TRUE(lines >> i >> j >> value);
        entries.emplace_back(i - 1, j - 1, std::stod(value));
        if (symmetric) {
            EXPECT_GE(i, j);
            if (i != j) entries.emplace_back(j - 1, i - 1, std::stod(value));
        }
    }
    EXPECT_FALSE(lines >> line) << "more entries than announced";
    SparseMatrix matrix(rows, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

// info and operators

TEST_F(CommandLine, InfoDescribesAnOpenMesh) {
    const json facts = json::parse(succeed("info '" + grid + "' --json"));
    EXPECT_EQ(facts["vertices"], 9);
    EXPECT_EQ(facts["faces"], 4);
    EXPECT_EQ(facts["edges"], 12);
    EXPECT_EQ(facts["components"], 1);
    EXPECT_EQ(facts["boundaryVertices"], 8);
    EXPECT_EQ(facts["boundaryLoops"], 1);
    EXPECT_EQ(facts["faceSizes"], (json{{"4", 4}}));
    EXPECT_EQ(facts["area"], 1.0);
    EXPECT_EQ(facts["volume"], nullptr);
    EXPECT_NE(facts["noVolume"].get<std::string>().find("open"), std::string::npos);
    EXPECT_EQ(facts["meanNonPlanarity"], 0.0);
    EXPECT_EQ(facts["meanSquaredEdge"], 0.25);
    EXPECT_EQ(facts["issues"], json::array());
}

TEST_F(CommandLine, InfoDescribesAClosedMesh) {
    write(path("tetrahedron.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    const json facts = json::parse(succeed("info --json tetrahedron.obj"));
    EXPECT_EQ(facts["boundaryLoops"], 0);
    EXPECT_NEAR(facts["volume"], 1.0 / 6, 1e-15);
    EXPECT_NEAR(facts["area"], 1.5 + std::sqrt(3.0) / 2, 1e-15);
    EXPECT_FALSE(facts.contains("noVolume"));
    const std::string text = succeed("info tetrahedron.obj");
    for (const char* line : {"vertices              4\n", "faces                 4\n", "edges                 6\n",
                             "boundary loops        0\n", "corners: faces        3: 4\n"})
        EXPECT_NE(text.find(line), std::string::npos) << text;
}

TEST_F(CommandLine, InfoReportsIssuesAndReasons) {
    // Three triangles at the edge 0-1, and vertex 5 in none.
    write(path("fins.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 9 9 9\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
    const json facts = json::parse(succeed("info --json fins.obj"));
    EXPECT_EQ(facts["boundaryLoops"], nullptr);
    EXPECT_NE(facts["noBoundaryLoops"].get<std::string>(), "");
    std::vector<std::string> kinds;
    for (const auto& issue : facts["issues"]) {
        kinds.push_back(issue["kind"]);
        EXPECT_EQ(issue["count"], 1);
        EXPECT_NE(issue["message"], "");
    }
    EXPECT_NE(std::find(kinds.begin(), kinds.end(), "unreferenced-vertices"), kinds.end());
    EXPECT_NE(std::find(kinds.begin(), kinds.end(), "non-manifold-edges"), kinds.end());
    const std::string text = succeed("info fins.obj");
    EXPECT_NE(text.find("boundary loops        none: " + facts["noBoundaryLoops"].get<std::string>()),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("issue                 "), std::string::npos) << text;
}

TEST_F(CommandLine, OperatorsListsTheWholeTable) {
    const json table = json::parse(succeed("operators --json"));
    ASSERT_EQ(table.size(), operators().size());
    const std::string text = succeed("operators");
    for (std::size_t k = 0; k < table.size(); ++k) {
        const OperatorInfo& info = *operators()[k];
        const json& row = table[k];
        EXPECT_EQ(row["id"], info.id);
        EXPECT_EQ(row["label"], info.label);
        EXPECT_EQ(row["formula"], info.formula_latex);
        EXPECT_EQ(row["citation"], info.citation);
        EXPECT_EQ(row["summary"], info.summary);
        for (const PropertyInfo& property : properties()) {
            EXPECT_EQ(row["claims"][property.id]["where"], claim_name((info.claims.*property.claim).where));
            EXPECT_EQ(row["claims"][property.id]["why"], (info.claims.*property.claim).why);
        }
        ASSERT_EQ(row["parameters"].size(), info.parameters.size());
        for (std::size_t p = 0; p < info.parameters.size(); ++p) {
            const Parameter& parameter = info.parameters[p];
            const json& cell = row["parameters"][p];
            EXPECT_EQ(cell["id"], parameter.id);
            EXPECT_EQ(cell["label"], parameter.label);
            EXPECT_EQ(cell["kind"], parameter.kind == Parameter::Kind::choice ? "choice" : "real");
            EXPECT_EQ(cell["min"], parameter.min);
            EXPECT_EQ(cell["max"], parameter.max);
            EXPECT_EQ(cell["sliderMax"], parameter.slider_max);
            EXPECT_EQ(cell["step"], parameter.step);
            EXPECT_EQ(cell["initial"], parameter.initial);
            EXPECT_EQ(cell["hint"], parameter.hint);
            EXPECT_EQ(cell.value("choices", std::vector<std::string>{}),
                      std::vector<std::string>(parameter.choices.begin(), parameter.choices.end()));
            EXPECT_NE(text.find("--set " + std::string(parameter.id) + '='), std::string::npos);
        }
        EXPECT_NE(text.find(info.id), std::string::npos);
        EXPECT_NE(text.find(info.citation), std::string::npos);
    }
}

TEST_F(CommandLine, HelpAndVersion) {
    EXPECT_TRUE(succeed("--version").starts_with("polylap "));
    const std::string help = succeed("--help");
    for (const char* command : {"info", "operators", "matrix", "smooth", "harmonic"}) {
        EXPECT_NE(help.find(command), std::string::npos);
        EXPECT_NE(succeed(std::string(command) + " --help").find("Usage: polylap " + std::string(command)),
                  std::string::npos);
    }
}

// matrix

TEST_F(CommandLine, MatrixWritesTheLibrarysMatrices) {
    const PolygonMesh mesh = load(torus);
    for (const OperatorInfo* info : operators()) {
        SCOPED_TRACE(info->id);
        EXPECT_EQ(succeed("matrix '" + torus + "' --operator " + info->id + " -o S.mtx --mass-out M.mtx"), "");
        const auto built = build_operator(mesh, {.id = info->id, .values = {}});
        ASSERT_TRUE(built.ok());
        const std::string text = slurp(path("S.mtx"));
        EXPECT_EQ(text.find(" symmetric\n") != std::string::npos, info->claims.symmetric.where == Claim::yes);
        const SparseMatrix stiffness = read_matrix_market(text), mass = read_matrix_market(slurp(path("M.mtx")));
        ASSERT_EQ(stiffness.rows(), mesh.vertex_count());
        ASSERT_EQ(stiffness.cols(), mesh.vertex_count());
        // The lower triangle comes back to the bit; the upper one as symmetric as the matrix is.
        const Matrix difference = Matrix(stiffness) - Matrix(built->stiffness);
        EXPECT_EQ(difference.triangularView<Eigen::Lower>().toDenseMatrix().cwiseAbs().maxCoeff(), 0);
        EXPECT_LE(difference.cwiseAbs().maxCoeff(), 1e-14 * Matrix(built->stiffness).cwiseAbs().maxCoeff());
        EXPECT_EQ((Matrix(mass) - Matrix(built->mass)).cwiseAbs().maxCoeff(), 0);
    }
    EXPECT_EQ(files(), (std::vector<std::string>{"M.mtx", "S.mtx"}));
}

TEST_F(CommandLine, MatrixTakesParametersAndStandardOutput) {
    // Unit square, λ: edge weights λ, diagonal weights ½ - λ.
    write(path("square.obj"), "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    const Matrix s = read_matrix_market(succeed("matrix --operator alexa-wardetzky --set lambda=0.75 -o - square.obj"));
    EXPECT_NEAR(s(0, 1), -0.75, 1e-15);
    EXPECT_NEAR(s(0, 2), 0.25, 1e-15);
    EXPECT_NEAR(s(0, 0), 1.25, 1e-15);
    const Matrix cut = read_matrix_market(succeed("matrix - --operator planar --set rule=fan -o -", "< square.obj"));
    EXPECT_NEAR(cut(0, 1), -0.5, 1e-15);
    EXPECT_EQ(files(), std::vector<std::string>{"square.obj"});
}

// smooth

TEST_F(CommandLine, SmoothTakesTheSessionsSteps) {
    const std::string bytes = slurp(torus);
    for (const bool rebuild : {true, false}) {
        auto session = Session::open(std::as_bytes(std::span(bytes)), "torus.obj");
        ASSERT_TRUE(session.ok());
        const auto side = Session::Side::a;
        ASSERT_TRUE(session->set_operator(side, spec("alexa-wardetzky", {{"lambda", "0.5"}})).ok());
        const double h2 = session->shape(side).measures.mean_squared_edge;
        ASSERT_TRUE(session->smooth(side, {.time = 0.25 * h2, .steps = 3, .rebuild = rebuild}).ok());

        const std::string flags = rebuild ? " -o out.obj" : " --keep-operator -o out.obj";
        const std::string said = succeed(
            "smooth '" + torus + "' --operator alexa-wardetzky --set lambda=0.5 --time-h2 0.25 --steps 3" + flags);
        EXPECT_EQ(said, "last step solved by cholesky\n");
        const PolygonMesh smoothed = load(path("out.obj"));
        EXPECT_EQ(smoothed.connectivity()->corners, session->mesh().connectivity()->corners);
        EXPECT_EQ(smoothed.positions(), session->surface(side).positions());
        EXPECT_NE(smoothed.positions(), session->mesh().positions());

        std::ostringstream time;
        time.precision(17);
        time << 0.25 * h2;
        const std::string same = succeed("smooth '" + torus + "' --operator alexa-wardetzky --set lambda=0.5 --time " +
                                         time.str() + " --steps 3 -o -" + (rebuild ? "" : " --keep-operator"));
        EXPECT_EQ(same, slurp(path("out.obj")));
    }
}

TEST_F(CommandLine, SmoothTakesTheSessionsFlows) {
    const std::string bytes = slurp(torus);
    const auto side = Session::Side::a;
    for (const Flow flow : {Flow::implicit_step, Flow::conformalised, Flow::explicit_step}) {
        auto session = Session::open(std::as_bytes(std::span(bytes)), "torus.obj");
        ASSERT_TRUE(session.ok());
        ASSERT_TRUE(session->set_operator(side, spec("planar", {})).ok());
        const double h2 = session->shape(side).measures.mean_squared_edge;
        const Session::SmoothOptions options{.time = 0.05 * h2, .steps = 2, .flow = flow, .keep_volume = true};
        const auto bound = session->stability(side, options);
        ASSERT_TRUE(bound.ok());
        ASSERT_TRUE(session->smooth(side, options).ok());
        const std::string said = succeed("smooth '" + torus + "' --operator planar --time-h2 0.05 --steps 2 --flow " +
                                         flow_name(flow) + " --keep-volume -o out.obj");
        EXPECT_EQ(load(path("out.obj")).positions(), session->surface(side).positions());
        if (flow != Flow::explicit_step) {
            EXPECT_EQ(said, "last step solved by cholesky\n");
            continue;
        }
        std::ostringstream expected;
        expected.precision(17);
        expected << "explicit steps stable for t < " << bound->limit() << " (" << bound->limit() / h2
                 << " h²); the first multiplies the roughest mode by " << bound->growth(options.time)
                 << "\nlast step solved by diagonal\n";
        EXPECT_EQ(said, expected.str());
    }
    const std::string open = "smooth '" + grid + "' --operator planar --time-h2 0.1 -o out.obj ";
    EXPECT_NE(fail(1, open + "--keep-volume").find("there is no volume to keep: the surface is open"),
              std::string::npos);
    succeed(open + "--fix-boundary --flow explicit");
    const PolygonMesh held = load(path("out.obj"));
    for (const Index v : {0, 1, 2, 3, 5, 6, 7, 8})
        EXPECT_EQ(held.position(v), load(grid).position(v));
}

TEST_F(CommandLine, KeepingTheOperatorDiffersFromRebuildingIt) {
    const std::string step = "smooth '" + torus + "' --operator planar --time 0.1 -o - --steps ";
    EXPECT_EQ(succeed(step + "1"), succeed(step + "1 --keep-operator"));
    EXPECT_NE(succeed(step + "2"), succeed(step + "2 --keep-operator"));
    EXPECT_EQ(succeed(step + "1"), succeed("smooth '" + torus + "' --operator planar --time 0.1 -o -"))
        << "one step unless told otherwise";
    EXPECT_EQ(succeed(step + "010 --keep-operator"), succeed(step + "10 --keep-operator"))
        << "decimal, whatever it begins with";
}

// harmonic

TEST_F(CommandLine, HarmonicInterpolatesTheCentreOfTheGrid) {
    write(path("rim.csv"), rim);
    const std::vector<std::pair<std::string, double>> expected = {{"alexa-wardetzky", 4.0 / 3},
                                                                  {"alexa-wardetzky --set lambda=0.5", 1},
                                                                  {"alexa-wardetzky --set lambda=2", 1.6},
                                                                  {"planar", 1}};
    for (const auto& [choice, centre] : expected) {
        SCOPED_TRACE(choice);
        succeed("harmonic '" + grid + "' --operator " + choice + " --fix rim.csv -o values.csv");
        const auto values = read_values(slurp(path("values.csv")));
        ASSERT_EQ(values.size(), 9u);
        EXPECT_NEAR(values[4], centre, 1e-14);
        for (const std::size_t corner : {0, 2, 6, 8})
            EXPECT_EQ(values[corner], 0);
        for (const std::size_t middle : {1, 3, 5, 7})
            EXPECT_EQ(values[middle], 1);
    }
}

TEST_F(CommandLine, HarmonicGivesNanAtVerticesInNoFace) {
    write(path("loose.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n");
    write(path("fix.csv"), "0,2\n1,2\n");
    EXPECT_NE(succeed("harmonic loose.obj --operator planar --fix fix.csv -o -").find("\n3,nan\n"), std::string::npos);
}

// What goes wrong

TEST_F(CommandLine, UsageErrorsEndWithTwo) {
    const std::string mesh = "'" + grid + "' ";
    for (const std::string& arguments : std::vector<std::string>{
             "",
             "bogus",
             "info",
             "info " + mesh + "extra",
             "info --nope " + mesh,
             "operators extra",
             "matrix " + mesh,
             "matrix " + mesh + "--operator planar",
             "matrix " + mesh + "-o S.mtx",
             "matrix " + mesh + "--operator planar -o S.mtx --set lambda",
             "matrix " + mesh + "--operator planar -o S.mtx --set =1",
             "matrix " + mesh + "--operator planar -o S.mtx --mass-out S.mtx",
             "matrix " + mesh + "--operator planar -o S.mtx --mass-out ''",
             "smooth " + mesh + "--operator planar -o o.obj",
             "smooth " + mesh + "--operator planar -o o.obj --time 1 --time-h2 1",
             "smooth " + mesh + "--operator planar -o o.obj --time abc",
             "smooth " + mesh + "--operator planar -o o.obj --time 1 --flow upwards",
             "smooth " + mesh + "--operator planar -o o.obj --time 1 --flow conformalised --keep-operator",
             "smooth " + mesh + "--operator planar -o o.obj --time -1",
             "smooth " + mesh + "--operator planar -o o.obj --time 0",
             "smooth " + mesh + "--operator planar -o o.obj --time nan",
             "smooth " + mesh + "--operator planar -o o.obj --time inf",
             "smooth " + mesh + "--operator planar -o o.obj --time 0x10",
             "smooth " + mesh + "--operator planar -o o.obj --time ' 1'",
             "smooth " + mesh + "--operator planar -o o.obj --time '1 '",
             "smooth " + mesh + "--operator planar -o o.obj --time ''",
             "smooth " + mesh + "--operator planar -o o.obj --time-h2 0x1p3",
             "smooth " + mesh + "--operator planar -o o.obj --time-h2 -2",
             "smooth " + mesh + "--operator planar -o o.obj --time 1 --steps 0",
             "smooth " + mesh + "--operator planar -o o.obj --time 1 --steps 1.5",
             "smooth " + mesh + "--operator planar -o o.obj --time 1 --steps 0x2",
             "smooth " + mesh + "--operator planar -o o.obj --time 1 --steps 1000001",
             "harmonic " + mesh + "--operator planar -o o.csv",
             "harmonic " + mesh + "--operator planar --fix f.csv"})
        EXPECT_NE(fail(2, arguments), "");
    EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(CommandLine, UsageErrorsNameWhatIsWrong) {
    const std::string commands =
        "the commands are info, operators, shapes, conversions, make, convert, matrix, smooth, harmonic, check, "
        "convergence, spectrum, face, dual";
    EXPECT_TRUE(fail(2, "foo").starts_with("there is no command 'foo'; " + commands));
    EXPECT_TRUE(fail(2, "infos x.obj").starts_with("there is no command 'infos'; " + commands));
    EXPECT_TRUE(fail(2, "").starts_with("expected a command; " + commands));
    const std::string matrix = "matrix '" + grid + "' --operator planar ", smooth = "smooth '" + grid + "' -o - ";
    EXPECT_TRUE(fail(2, matrix + "-o ''").starts_with("--output: needs the name of a file"));
    EXPECT_TRUE(fail(2, matrix + "-o S.mtx --mass-out ''").starts_with("--mass-out: needs the name of a file"));
    EXPECT_TRUE(
        fail(2, smooth + "--operator planar --time 0x10").starts_with("--time: must be a positive number, not '0x10'"));
    EXPECT_TRUE(fail(2, smooth + "--operator planar --time 1 --steps 010x")
                    .starts_with("--steps: must be a whole number from 1 to 1000000, not '010x'"));
}

TEST_F(CommandLine, FailuresEndWithOneAndWriteNothing) {
    write(path("bad.obj"), "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 2\n");
    write(path("flat.obj"), "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 4\nf 1 2 3\n");
    write(path("parts.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n");
    write(path("mesh.xyz"), "");
    write(path("fix.csv"), "0,1\n");
    write(path("old.txt"), "kept");
    const auto before = files();
    const std::string mesh = "'" + grid + "' ";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"info none.obj", "cannot read none.obj: "},
        {"info .", "cannot read .: "},
        {"info mesh.xyz", "mesh.xyz: "},
        {"info bad.obj", "bad.obj: line 5: face 1 has 2 corners, fewer than 3"},
        {"matrix bad.obj --operator planar -o old.txt", "bad.obj: line 5: "},
        {"matrix " + mesh + "--operator nope -o old.txt", "there is no operator 'nope'"},
        {"matrix " + mesh + "--operator alexa-wardetzky --set mu=1 -o old.txt",
         "operator 'alexa-wardetzky' has no parameter 'mu'"},
        {"matrix " + mesh + "--operator alexa-wardetzky --set lambda=x -o old.txt", "lambda must be a number"},
        {"matrix " + mesh + "--operator alexa-wardetzky --set lambda=-1 -o old.txt", "lambda must lie between"},
        {"matrix " + mesh + "--operator planar --set rule=x -o old.txt", "rule must be one of"},
        {"matrix " + mesh + "--operator planar -o old.txt --mass-out none/M.mtx", "cannot write none/M.mtx: "},
        {"matrix " + mesh + "--operator planar -o .", "cannot write .: "},
        {"matrix " + mesh + "--operator planar -o none/S.mtx --mass-out old.txt", "cannot write none/S.mtx: "},
        {"smooth flat.obj --operator planar --time 1 -o old.txt", "flat.obj: "},
        {"smooth flat.obj --operator alexa-wardetzky --time 1 -o old.txt", "flat.obj: "},
        {"harmonic " + mesh + "--operator planar --fix none.csv -o old.txt", "cannot read none.csv: "},
        {"harmonic parts.obj --operator planar --fix fix.csv -o old.txt", "parts.obj: "},
    };
    for (const auto& [arguments, message] : cases) {
        const std::string line = fail(1, arguments);
        EXPECT_TRUE(line.starts_with(message)) << arguments << '\n' << line;
        EXPECT_EQ(slurp(path("old.txt")), "kept") << arguments;
        EXPECT_EQ(files(), before) << arguments;
    }
    EXPECT_NE(fail(1, "matrix flat.obj --operator planar -o old.txt").find("face 1"), std::string::npos);
}

}  // namespace
}  // namespace polylap

// What the command line reads and writes beside meshes: rows of values, matrices, and the ways to a file.
#include "../../core/tools/tables.hpp"
#include "command_line.hpp"

namespace polylap {
namespace {

TEST_F(CommandLine, HarmonicReadsTidyAndUntidyRows) {
    write(path("rim.csv"), rim);
    write(path("untidy.csv"),
          "\xEF\xBB\xBF# made by hand\r\n\r\n \"Vertex\" , \"Value\"\r\n0,0\r\n 2 ,\t0 # "
          "corner\r\n6,0e5\r\n#7,9\r\n8,-0\r\n1,1\n3,1.0\n5,.1e1\n7,1");
    const std::string arguments = "harmonic '" + grid + "' --operator planar -o - --fix ";
    const auto tidy = read_values(succeed(arguments + "rim.csv")),
               untidy = read_values(succeed(arguments + "untidy.csv"));
    EXPECT_EQ(tidy, untidy);
    EXPECT_EQ(read_values(succeed(arguments + "-", "< rim.csv")), tidy);
    std::string returns = "VERTEX,value\n" + rim;
    std::replace(returns.begin(), returns.end(), '\n', '\r');
    write(path("returns.csv"), returns);
    EXPECT_EQ(read_values(succeed(arguments + "returns.csv")), tidy);
    write(path("quoted.csv"), "\"0\",\"0\"\n" + rim.substr(4));
    EXPECT_EQ(read_values(succeed(arguments + "quoted.csv")), tidy) << "numbers in quotes are no header";
    write(path("numbers.csv"), "0,1e-400\n2,-1e-400\n6,+0\n8,4e-324\n" + rim.substr(16));
    const auto numbers = read_values(succeed(arguments + "numbers.csv"));
    EXPECT_EQ(numbers[0], 0);
    EXPECT_EQ(numbers[2], 0);
    EXPECT_EQ(numbers[8], 4e-324);
    write(path("plus.csv"), "0,+1\n");
    EXPECT_EQ(read_values(succeed(arguments + "plus.csv"))[0], 1);
}

TEST_F(CommandLine, HarmonicRefusesBadRowsByLine) {
    const std::vector<std::pair<std::string, std::string>> rows = {
        {"0,0\n\nx,1\n", "line 3: expected a row 'vertex,value'"},
        {"0,0\n1\n", "line 2: expected a row 'vertex,value'"},
        {"0 0\n", "line 1: expected a row 'vertex,value'"},
        {"0.5,0\n", "line 1: expected a row 'vertex,value'"},
        {"vertex,value\nvertex,value\n0,1\n", "line 2: expected a row 'vertex,value'"},
        {"nan,nan\n0,1\n", "line 1: expected a row 'vertex,value'"},
        {"inf,value\n0,1\n", "line 1: expected a row 'vertex,value'"},
        {"v,temperature\n0,1\n", "line 1: expected a row 'vertex,value'"},
        {"\"vertex,value\"\n0,1\n", "line 1: expected a row 'vertex,value'"},
        {"0,0\r\n1,1\rx,1\r", "line 3: expected a row 'vertex,value'"},
        {"0,0\n9,1\n", "line 2: there is no vertex 9; the mesh has 9 vertices"},
        {"-1,0\n", "line 1: there is no vertex -1"},
        {"99999999999,0\n", "line 1: there is no vertex 99999999999"},
        {"0,abc\n", "line 1: the value of vertex 0 is no finite number"},
        {"0,nan\n", "line 1: the value of vertex 0 is no finite number"},
        {"0,1e999\n", "line 1: the value of vertex 0 is no finite number"},
        {"0,+-1\n", "line 1: the value of vertex 0 is no finite number"},
        {"0,0x1\n", "line 1: the value of vertex 0 is no finite number"},
        {"0,1,2\n", "line 1: the value of vertex 0 is no finite number"},
        {"0,\n", "line 1: the value of vertex 0 is no finite number"},
        {"0,1\n# again\n0,1\n", "line 3: vertex 0 has a value already, in line 1"},
        {"# nothing\n", "no rows 'vertex,value'"},
    };
    for (const auto& [text, message] : rows) {
        write(path("fix.csv"), text);
        EXPECT_TRUE(fail(1, "harmonic '" + grid + "' --operator planar --fix fix.csv -o out.csv")
                        .starts_with("fix.csv: " + message))
            << text;
        EXPECT_EQ(files(), std::vector<std::string>{"fix.csv"});
    }
}

TEST(MatrixMarket, GeneralHasEveryEntry) {
    SparseMatrix matrix(2, 3);
    const std::vector<Eigen::Triplet<double>> entries{{0, 0, 0.1}, {1, 0, -2.0}, {0, 1, 1.0 / 3}, {1, 2, 1e-300}};
    matrix.setFromTriplets(entries.begin(), entries.end());
    EXPECT_EQ(tool::matrix_market(matrix, false, "a comment"),
              "%%MatrixMarket matrix coordinate real general\n"
              "% a comment\n"
              "2 3 4\n"
              "1 1 0.10000000000000001\n"
              "2 1 -2\n"
              "1 2 0.33333333333333331\n"
              "2 3 1e-300\n");
}

TEST(MatrixMarket, SymmetricHasTheLowerTriangle) {
    SparseMatrix matrix(2, 2);
    const std::vector<Eigen::Triplet<double>> entries{{0, 0, 1.0}, {1, 0, -0.1}, {0, 1, -0.1}, {1, 1, 1.0}};
    matrix.setFromTriplets(entries.begin(), entries.end());
    EXPECT_EQ(tool::matrix_market(matrix, true, "s"),
              "%%MatrixMarket matrix coordinate real symmetric\n"
              "% s\n"
              "2 2 3\n"
              "1 1 1\n"
              "2 1 -0.10000000000000001\n"
              "2 2 1\n");
}

TEST_F(CommandLine, OutputReplacesAFileButNotALinkOrADevice) {
    write(path("real.mtx"), "old");
    fs::permissions(folder_ / "real.mtx", fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("real.mtx", folder_ / "link.mtx");
    succeed("matrix '" + grid + "' --operator planar -o link.mtx");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.mtx"));
    EXPECT_TRUE(slurp(path("real.mtx")).starts_with("%%MatrixMarket "));
    EXPECT_EQ(fs::status(folder_ / "real.mtx").permissions(), fs::perms::owner_read | fs::perms::owner_write);
    succeed("matrix '" + grid + "' --operator planar -o /dev/null");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_EQ(files(), (std::vector<std::string>{"link.mtx", "real.mtx"}));
}

TEST_F(CommandLine, OutputThroughALinkToNothingMakesWhatItNames) {
    fs::create_directory(folder_ / "deep");
    fs::create_symlink("deep/second.mtx", folder_ / "first.mtx");
    fs::create_symlink("../target.mtx", folder_ / "deep/second.mtx");  // relative to the folder of the link
    succeed("matrix '" + grid + "' --operator planar -o first.mtx");
    EXPECT_TRUE(fs::is_symlink(folder_ / "first.mtx"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "deep/second.mtx"));
    ASSERT_TRUE(fs::is_regular_file(fs::symlink_status(folder_ / "target.mtx")));
    EXPECT_TRUE(slurp(path("target.mtx")).starts_with("%%MatrixMarket "));

    fs::create_symlink("none/target.mtx", folder_ / "astray.mtx");
    fs::create_symlink("loop.mtx", folder_ / "loop.mtx");
    const auto before = files();
    for (const std::string name : {"astray.mtx", "loop.mtx"}) {
        EXPECT_TRUE(fail(1, "matrix '" + grid + "' --operator planar -o " + name).starts_with("cannot write " + name))
            << name;
        EXPECT_TRUE(fs::is_symlink(folder_ / name));
    }
    EXPECT_EQ(files(), before);
}

TEST_F(CommandLine, TwoOutputsMustNotBeOneFile) {
    const std::string matrix = "matrix '" + grid + "' --operator planar -o ";
    fs::create_directory(folder_ / "deep");
    fs::create_symlink("new.mtx", folder_ / "link.mtx");
    const auto refuse = [&](const std::string& stiffness, const std::string& mass) {
        EXPECT_TRUE(fail(2, matrix + stiffness + " --mass-out " + mass)
                        .starts_with("--mass-out: must be another file than --output"))
            << stiffness << ' ' << mass;
    };
    for (const std::string again : {"new.mtx", "./new.mtx", "deep/../new.mtx", "link.mtx", "\"$PWD/new.mtx\""}) {
        refuse("new.mtx", again);
        refuse(again, "new.mtx");
    }
    refuse("-", "-");
    EXPECT_EQ(files(), (std::vector<std::string>{"deep", "link.mtx"}));
    write(path("new.mtx"), "kept");
    fs::create_hard_link(folder_ / "new.mtx", folder_ / "hard.mtx");
    refuse("./new.mtx", "link.mtx");
    refuse("new.mtx", "hard.mtx");
    EXPECT_EQ(slurp(path("new.mtx")), "kept");
    succeed(matrix + "deep/new.mtx --mass-out new.mtx");
    EXPECT_NE(slurp(path("deep/new.mtx")), slurp(path("new.mtx")));
}

TEST_F(CommandLine, AFullDiskIsAnError) {
    EXPECT_TRUE(
        fail(1, "matrix '" + grid + "' --operator planar -o /dev/full").starts_with("cannot write /dev/full: "));
    const Ended ended = run("operators", "> /dev/full");
    EXPECT_EQ(ended.status, 1);
    EXPECT_TRUE(ended.err.starts_with("polylap: cannot write standard output")) << ended.err;
}

}  // namespace
}  // namespace polylap

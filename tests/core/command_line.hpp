// The built command line, run as a shell does.
#pragma once

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace polylap {

namespace fs = std::filesystem;

inline std::string slurp(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    EXPECT_TRUE(stream) << path;
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

inline const std::string meshes = POLYLAP_TEST_DATA "/meshes/";
inline const std::string grid = meshes + "grid-2x2.obj";
inline const std::string torus = meshes + "quad-torus-32x16-noisy.obj";
/// Corners of the 2×2 grid at 0, edge midpoints of its boundary at 1.
inline const std::string rim = "0,0\n2,0\n6,0\n8,0\n1,1\n3,1\n5,1\n7,1\n";

inline std::vector<double> read_values(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "vertex,value");
    std::vector<double> values;
    while (std::getline(lines, line)) {
        const auto comma = line.find(',');
        EXPECT_EQ(line.substr(0, comma), std::to_string(values.size()));
        values.push_back(std::strtod(line.c_str() + comma + 1, nullptr));  // stod() throws at denormal numbers
    }
    return values;
}

class CommandLine : public testing::Test {
protected:
    struct Ended {
        int status;
        std::string out, err;
    };

    CommandLine() {
        std::string pattern = testing::TempDir() + "polylap-XXXXXX";
        folder_ = mkdtemp(pattern.data());
    }
    ~CommandLine() override { fs::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    /// Runs in the scratch folder. `arguments` are shell words; `after` may redirect.
    Ended run(const std::string& arguments, const std::string& after = "") const {
        const fs::path out = folder_ / ".out", err = folder_ / ".err";
        const std::string command =
            "cd '" + folder_.string() + "' && '" POLYLAP_CLI "' " + arguments + " >.out 2>.err " + after;
        const int status = std::system(command.c_str());
        Ended ended{WIFEXITED(status) ? WEXITSTATUS(status) : -1, slurp(out), slurp(err)};
        fs::remove(out);
        fs::remove(err);
        return ended;
    }

    std::string succeed(const std::string& arguments, const std::string& after = "") const {
        const Ended ended = run(arguments, after);
        EXPECT_EQ(ended.status, 0) << arguments << '\n' << ended.err;
        EXPECT_EQ(ended.err, "") << arguments;
        return ended.out;
    }

    /// @return the line on standard error, without "polylap: " and line end
    std::string fail(int status, const std::string& arguments, const std::string& after = "") const {
        const Ended ended = run(arguments, after);
        EXPECT_EQ(ended.status, status) << arguments;
        EXPECT_EQ(ended.out, "") << arguments;
        EXPECT_TRUE(ended.err.starts_with("polylap: ")) << arguments << '\n' << ended.err;
        EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
        EXPECT_TRUE(ended.err.ends_with('\n')) << ended.err;
        return ended.err.size() > 10 ? ended.err.substr(9, ended.err.size() - 10) : "";
    }

    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder_))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

    fs::path folder_;
};

}  // namespace polylap

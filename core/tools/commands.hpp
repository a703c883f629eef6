#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files.hpp"

namespace polylap::tool {

/// An operator as the command line names it.
struct OperatorChoice {
    std::string id;
    std::vector<std::pair<std::string, std::string>> settings;
};

struct SmoothChoice {
    std::optional<double> time;     ///< length²
    std::optional<double> time_h2;  ///< In units of the mean squared edge length of the mesh.
    int steps = 1;
    bool keep_operator = false;
};

using Outputs = std::vector<Output>;

// Each command reads its files and returns what is to be written; nothing is written before all of it is known.
Result<Outputs> info(const std::string& mesh, bool json);
Result<Outputs> operator_table(bool json);
Result<Outputs> matrix(const std::string& mesh, const OperatorChoice& choice, const std::string& stiffness_path,
                       const std::string& mass_path);
Result<Outputs> smooth(const std::string& mesh, const OperatorChoice& choice, const SmoothChoice& options,
                       const std::string& path);
Result<Outputs> harmonic(const std::string& mesh, const OperatorChoice& choice, const std::string& fixed_path,
                         const std::string& path);

}  // namespace polylap::tool

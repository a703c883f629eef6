#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files.hpp"
#include "polylap/apply/flow.hpp"
#include "polylap/base/types.hpp"

namespace polylap::tool {

/// A mesh file and how it is to be read.
struct MeshChoice {
    std::string path;  ///< "-" is an OBJ on standard input.
    bool repair = false;
    double merge_distance = 0;  ///< In diagonals of the bounding box.
};

using SettingTexts = std::vector<std::pair<std::string, std::string>>;

/// An operator as the command line names it.
struct OperatorChoice {
    std::string id;
    SettingTexts settings;
    std::string weights;  ///< File of vertex weights; empty: none.
};

struct SmoothChoice {
    std::optional<double> time;     ///< length²
    std::optional<double> time_h2;  ///< In units of the mean squared edge length of the mesh.
    int steps = 1;
    Flow flow = Flow::implicit_step;
    bool keep_operator = false;
    bool keep_volume = false;
    bool fix_boundary = false;
};

/// A shape or a conversion, by name, with its parameters.
struct NamedChoice {
    std::string id;
    SettingTexts settings;
};

struct NoiseChoice {
    double amplitude = 0;  ///< In mean edge lengths.
    double seed = 1;
};

using Outputs = std::vector<Output>;

// Each command reads its files and returns what is to be written; nothing is written before all of it is known.
Result<Outputs> info(const MeshChoice& mesh, bool json);
/// @param bibtex only the entries of the works they come from, each once
Result<Outputs> operator_table(bool json, bool bibtex);
Result<Outputs> shape_table(bool json);
Result<Outputs> conversion_table(bool json);
Result<Outputs> matrix(const MeshChoice& mesh, const OperatorChoice& choice, const std::string& stiffness_path,
                       const std::string& mass_path);
Result<Outputs> smooth(const MeshChoice& mesh, const OperatorChoice& choice, const SmoothChoice& options,
                       const std::string& path);
Result<Outputs> harmonic(const MeshChoice& mesh, const OperatorChoice& choice, const std::string& fixed_path,
                         const std::string& path);
Result<Outputs> check(const MeshChoice& mesh, const OperatorChoice& choice, bool json, const std::string& modes_path);
Result<Outputs> convergence(const OperatorChoice& choice, bool json);
/// @param modes_path rows 'vertex,mode0,...' of the eigenvectors; empty: none
Result<Outputs> spectrum(const MeshChoice& mesh, const OperatorChoice& choice, Index count, bool json,
                         const std::string& modes_path);
Result<Outputs> face(const MeshChoice& mesh, const OperatorChoice& choice, Index face, bool json);
Result<Outputs> dual(const MeshChoice& mesh, double mu, bool json, const std::string& path);
Result<Outputs> make(const NamedChoice& shape, const NoiseChoice& noise, const std::string& path);
/// @param map_path rows 'vertex,original': the file's number of each vertex after repair; empty: none
Result<Outputs> convert(const MeshChoice& mesh, const std::vector<NamedChoice>& conversions, const std::string& path,
                        const std::string& map_path);

}  // namespace polylap::tool

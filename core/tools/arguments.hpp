#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "commands.hpp"

namespace polylap::tool {

/// What the options are read into.
struct Arguments {
    MeshChoice mesh;
    OperatorChoice choice;
    SmoothChoice smooth;
    NamedChoice shape;
    NoiseChoice noise;
    std::vector<NamedChoice> conversions;
    std::string fixed, out, second_out;
    double mu = 0;
    Index count = 10;
    Index face = 0;
    bool json = false;
    bool bibtex = false;
};

using Command = std::function<Result<Outputs>()>;

/// Declares the commands and their options; `chosen` becomes the one that was called.
void declare(CLI::App& app, Arguments& arguments, Command& chosen);

}  // namespace polylap::tool

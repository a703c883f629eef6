// The command line. Results go to files or standard output, one line about what went wrong to standard error.
#include <cmath>
#include <exception>
#include <functional>
#include <iostream>

#include <CLI/CLI.hpp>

#include "commands.hpp"

namespace {

using namespace polylap;

constexpr int failed = 1, wrong_usage = 2;

int complain(std::string message, int exit_code) {
    for (char& c : message)
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    std::cerr << "polylap: " << message << '\n';
    return exit_code;
}

/// What the options are read into.
struct Arguments {
    std::string mesh, fixed, out, mass_out;
    std::vector<std::string> settings;
    tool::OperatorChoice choice;
    tool::SmoothChoice smooth;
    bool json = false;
};

using Command = std::function<Result<tool::Outputs>()>;

/// @throws CLI::ValidationError
void split_settings(Arguments& arguments) {
    for (const std::string& setting : arguments.settings) {
        const auto equals = setting.find('=');
        if (equals == 0 || equals == std::string::npos)
            throw CLI::ValidationError("--set", "expected name=value, not '" + setting + "'");
        arguments.choice.settings.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
    }
}

/// CLI11's own check prints the range of all doubles.
CLI::Validator positive() {
    return {[](const std::string& text) {
                double value = 0;
                return CLI::detail::lexical_cast(text, value) && value > 0 && std::isfinite(value)
                           ? std::string()
                           : "must be a positive number, not '" + text + "'";
            },
            "POSITIVE", "positive"};
}

void add_mesh(CLI::App& command, Arguments& arguments) {
    command.add_option("MESH", arguments.mesh, "Mesh file (.obj); - reads an OBJ from standard input")->required();
}

void add_operator(CLI::App& command, Arguments& arguments) {
    command.add_option("--operator", arguments.choice.id, "Operator, see 'polylap operators'")
        ->required()
        ->type_name("ID");
    command.add_option("--set", arguments.settings, "Parameter of the operator; may be given several times")
        ->allow_extra_args(false)
        ->type_name("name=value");
}

void add_output(CLI::App& command, Arguments& arguments, const char* what) {
    command.add_option("-o,--output", arguments.out, std::string(what) + "; - writes to standard output")
        ->required()
        ->type_name("FILE");
}

/// Declares the commands; `chosen` becomes the one that was called.
void declare(CLI::App& app, Arguments& a, Command& chosen) {
    app.set_version_flag("--version", "polylap " POLYLAP_VERSION);
    app.require_subcommand(1);

    CLI::App* const info = app.add_subcommand("info", "Describe a mesh: counts, boundary, area, volume, issues");
    add_mesh(*info, a);
    info->add_flag("--json", a.json, "Write JSON");
    info->callback([&] { chosen = [&] { return tool::info(a.mesh, a.json); }; });

    CLI::App* const operators =
        app.add_subcommand("operators", "List the operators, their parameters and what they claim");
    operators->add_flag("--json", a.json, "Write JSON");
    operators->callback([&] { chosen = [&] { return tool::operator_table(a.json); }; });

    CLI::App* const matrix =
        app.add_subcommand("matrix", "Write the stiffness matrix S, and the mass M, as MatrixMarket");
    add_mesh(*matrix, a);
    add_operator(*matrix, a);
    add_output(*matrix, a, "Stiffness, unitless");
    matrix->add_option("--mass-out", a.mass_out, "Mass, length squared; - writes to standard output")
        ->type_name("FILE");
    matrix->callback([&] {
        if (a.out == a.mass_out) throw CLI::ValidationError("--mass-out", "must differ from --output");
        chosen = [&] { return tool::matrix(a.mesh, a.choice, a.out, a.mass_out); };
    });

    CLI::App* const smooth = app.add_subcommand("smooth", "Implicit smoothing steps (M + tS) x' = M x");
    add_mesh(*smooth, a);
    add_operator(*smooth, a);
    auto* const times = smooth->add_option_group("time", "How far a step goes");
    times->add_option("--time", a.smooth.time, "t, in length squared")->check(positive())->type_name("T");
    times->add_option("--time-h2", a.smooth.time_h2, "t in units of the mean squared edge length")
        ->check(positive())
        ->type_name("X");
    times->require_option(1);
    smooth->add_option("--steps", a.smooth.steps, "Number of steps")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str()
        ->type_name("N");
    smooth->add_flag("--keep-operator", a.smooth.keep_operator,
                     "Keep S and M of the loaded mesh instead of rebuilding them before each step");
    add_output(*smooth, a, "Smoothed mesh (OBJ)");
    smooth->callback([&] { chosen = [&] { return tool::smooth(a.mesh, a.choice, a.smooth, a.out); }; });

    CLI::App* const harmonic =
        app.add_subcommand("harmonic", "Interpolate values at some vertices harmonically over the mesh");
    add_mesh(*harmonic, a);
    add_operator(*harmonic, a);
    harmonic->add_option("--fix", a.fixed, "Rows 'vertex,value', vertices counted from 0; # starts a comment")
        ->required()
        ->type_name("FILE");
    add_output(*harmonic, a, "Rows 'vertex,value' of all vertices; nan at vertices in no face");
    harmonic->callback([&] { chosen = [&] { return tool::harmonic(a.mesh, a.choice, a.fixed, a.out); }; });
}

int run(int argc, char** argv) {
    Arguments arguments;
    Command command;
    CLI::App app("Discrete Laplace operators on general polygon meshes. Vertices and faces count from 0.", "polylap");
    declare(app, arguments, command);
    try {
        app.parse(argc, argv);
        split_settings(arguments);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {  // --help, --version
            app.exit(error);
            return std::cout.flush() ? 0 : complain("cannot write standard output", failed);
        }
        return complain(std::string(error.what()) + " (see polylap --help)", wrong_usage);
    }
    const auto outputs = command();
    if (!outputs) return complain(outputs.error().message, failed);
    if (auto status = tool::write_outputs(*outputs); !status) return complain(status.error().message, failed);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        return complain("not enough memory", failed);
    } catch (const std::exception& error) {
        return complain(error.what(), failed);
    }
}

// The command line. Results go to files or standard output, one line about what went wrong to standard error.
#include <cmath>
#include <exception>
#include <functional>
#include <iostream>

#include <CLI/CLI.hpp>

#include "commands.hpp"
#include "tables.hpp"

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

/// CLI11's own conversion takes hexadecimal and octal digits and spaces in front.
/// @param take keeps the number, unless it is none of those that `must_be` describes
CLI::Option* add_number(CLI::App& command, const std::string& name, const std::string& what, const std::string& must_be,
                        const std::function<bool(double)>& take) {
    const auto read = [=](const std::string& text) {
        const auto value = tool::parse_number(text);
        if (!value || !take(*value)) throw CLI::ValidationError(name, "must be " + must_be + ", not '" + text + "'");
    };
    return command.add_option_function<std::string>(name, read, what);
}

CLI::Option* add_time(CLI::App& command, const std::string& name, const std::string& what,
                      std::optional<double>& time) {
    return add_number(command, name, what, "a positive number", [&time](double value) {
        time = value;
        return value > 0;
    });
}

CLI::Validator file_name() {
    return {[](const std::string& text) { return text.empty() ? "needs the name of a file" : ""; }, ""};
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
        ->check(file_name())
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
        ->check(file_name())
        ->type_name("FILE");
    matrix->callback([&] {
        if (!a.mass_out.empty() && tool::same_output(a.out, a.mass_out))
            throw CLI::ValidationError("--mass-out", "must be another file than --output");
        chosen = [&] { return tool::matrix(a.mesh, a.choice, a.out, a.mass_out); };
    });

    CLI::App* const smooth = app.add_subcommand("smooth", "Implicit smoothing steps (M + tS) x' = M x");
    add_mesh(*smooth, a);
    add_operator(*smooth, a);
    auto* const times = smooth->add_option_group("time", "How far a step goes");
    add_time(*times, "--time", "t, in length squared", a.smooth.time)->type_name("T");
    add_time(*times, "--time-h2", "t in units of the mean squared edge length", a.smooth.time_h2)->type_name("X");
    times->require_option(1);
    constexpr int most_steps = 1'000'000;
    add_number(*smooth, "--steps", "Number of steps", "a whole number from 1 to " + std::to_string(most_steps),
               [&](double value) {
                   if (!(value >= 1 && value <= most_steps && value == std::floor(value))) return false;
                   a.smooth.steps = static_cast<int>(value);
                   return true;
               })
        ->default_str(std::to_string(a.smooth.steps))
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

/// CLI11 says neither which word it took for a command nor which there are.
std::string no_command(const CLI::App& app) {
    const auto words = app.remaining();
    std::string text = words.empty() ? "expected a command" : "there is no command '" + words.front() + "'";
    const char* separator = "; the commands are ";
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        text += separator + command->get_name();
        separator = ", ";
    }
    return text;
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
        const std::string what = app.get_subcommands().empty() ? no_command(app) : error.what();
        return complain(what + " (see polylap --help)", wrong_usage);
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

#include "arguments.hpp"

#include <cmath>
#include <limits>

#include "tables.hpp"

namespace polylap::tool {
namespace {

/// "name=value". @throws CLI::ValidationError
std::pair<std::string, std::string> split_setting(const std::string& option, const std::string& text) {
    const auto equals = text.find('=');
    if (equals == 0 || equals == std::string::npos)
        throw CLI::ValidationError(option, "expected name=value, not '" + text + "'");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

/// "id" or "id:name=value,name=value". @throws CLI::ValidationError
NamedChoice split_named(const std::string& option, const std::string& text) {
    const auto colon = text.find(':');
    NamedChoice choice{text.substr(0, colon), {}};
    for (std::size_t at = colon; at != std::string::npos;) {
        const auto comma = text.find(',', at + 1);
        choice.settings.push_back(split_setting(option, text.substr(at + 1, comma - at - 1)));
        at = comma;
    }
    return choice;
}

/// CLI11's own conversion takes hexadecimal and octal digits and spaces in front.
/// @param take keeps the number, unless it is none of those that `must_be` describes
CLI::Option* add_number(CLI::App& command, const std::string& name, const std::string& what, const std::string& must_be,
                        const std::function<bool(double)>& take) {
    const auto read = [=](const std::string& text) {
        const auto value = parse_number(text);
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

CLI::Option* add_not_negative(CLI::App& command, const std::string& name, const std::string& what, double& value) {
    return add_number(command, name, what, "a number ≥ 0", [&value](double given) {
        value = given;
        return given >= 0;
    });
}

CLI::Option* add_whole(CLI::App& command, const std::string& name, const std::string& what, double least, double most,
                       const std::function<void(double)>& take) {
    std::string bounds;
    append_number(bounds, least);
    append_number(bounds += " to ", most);
    return add_number(command, name, what, "a whole number from " + bounds, [=](double value) {
        if (!(value >= least && value <= most && value == std::floor(value))) return false;
        take(value);
        return true;
    });
}

CLI::Validator file_name() {
    return {[](const std::string& text) { return text.empty() ? "needs the name of a file" : ""; }, ""};
}

CLI::Option* add_file(CLI::App& command, const std::string& name, std::string& path, const std::string& what) {
    return command.add_option(name, path, what)->check(file_name())->type_name("FILE");
}

void add_mesh(CLI::App& command, Arguments& arguments) {
    command
        .add_option("MESH", arguments.mesh.path,
                    "Mesh file (.obj, .off, .ply, .stl); - reads an OBJ from standard input")
        ->required();
    auto* const repair = command.add_flag("--repair", arguments.mesh.repair,
                                          "Merge equal vertices, drop repeated corners, degenerate and duplicate "
                                          "faces, orient faces alike");
    add_not_negative(command, "--merge-distance",
                     "Also merge vertices closer than this, in diagonals of the bounding box",
                     arguments.mesh.merge_distance)
        ->needs(repair)
        ->type_name("X");
}

void add_settings(CLI::App& command, SettingTexts& settings, const char* whose) {
    command
        .add_option_function<std::vector<std::string>>(
            "--set",
            [&settings](const std::vector<std::string>& texts) {
                for (const std::string& text : texts)
                    settings.push_back(split_setting("--set", text));
            },
            std::string("Parameter of the ") + whose + "; may be given several times")
        ->allow_extra_args(false)
        ->type_name("name=value");
}

void add_operator(CLI::App& command, Arguments& arguments, bool on_mesh = true) {
    command.add_option("--operator", arguments.choice.id, "Operator, see 'polylap operators'")
        ->required()
        ->type_name("ID");
    add_settings(command, arguments.choice.settings, "operator");
    if (!on_mesh) return;
    add_file(command, "--weights", arguments.choice.weights,
             "Rows 'vertex,weight' for operators that take vertex weights, length squared; others have 0");
}

CLI::Option* add_output(CLI::App& command, Arguments& arguments, const char* what) {
    return add_file(command, "-o,--output", arguments.out, std::string(what) + "; - writes to standard output");
}

void add_json(CLI::App& command, Arguments& arguments) {
    command.add_flag("--json", arguments.json, "Write JSON");
}

void refuse_same_output(const Arguments& a, const char* option) {
    if (!a.second_out.empty() && same_output(a.out, a.second_out))
        throw CLI::ValidationError(option, "must be another file than --output");
}

void refuse_standard_output(const std::string& path, const char* option) {
    if (path == "-") throw CLI::ValidationError(option, "must be a file: the report is on standard output");
}

void declare_descriptions(CLI::App& app, Arguments& a, Command& chosen) {
    CLI::App* const info = app.add_subcommand("info", "Describe a mesh: counts, boundary, area, volume, issues");
    add_mesh(*info, a);
    add_json(*info, a);
    info->callback([&] { chosen = [&] { return tool::info(a.mesh, a.json); }; });

    const auto table = [&](const char* name, const char* what, Result<Outputs> (*list)(bool)) {
        CLI::App* const command = app.add_subcommand(name, what);
        add_json(*command, a);
        command->callback([&a, &chosen, list] { chosen = [&a, list] { return list(a.json); }; });
    };
    CLI::App* const operators =
        app.add_subcommand("operators", "List the operators, their parameters and what they claim");
    add_json(*operators, a);
    operators->add_flag("--bibtex", a.bibtex, "Write only the BibTeX entries of the works they come from")
        ->excludes("--json");
    operators->callback([&] { chosen = [&] { return operator_table(a.json, a.bibtex); }; });
    table("shapes", "List the shapes that 'make' makes, with their parameters", shape_table);
    table("conversions", "List what 'convert' can do, with parameters", conversion_table);
}

void declare_makers(CLI::App& app, Arguments& a, Command& chosen) {
    CLI::App* const make = app.add_subcommand("make", "Make a mesh, see 'polylap shapes'");
    make->add_option("NAME", a.shape.id, "Shape, see 'polylap shapes'")->required();
    add_settings(*make, a.shape.settings, "shape");
    auto* const noise = add_not_negative(
        *make, "--noise", "Move vertices along their normals by up to this, in mean edge lengths", a.noise.amplitude);
    noise->type_name("X");
    add_whole(*make, "--seed", "Which noise", 0, std::numeric_limits<std::uint32_t>::max(),
              [&](double value) { a.noise.seed = value; })
        ->needs(noise)
        ->default_str("1")
        ->type_name("N");
    add_output(*make, a, "Mesh, in the format that the ending says")->required();
    make->callback([&] { chosen = [&] { return tool::make(a.shape, a.noise, a.out); }; });

    CLI::App* const convert =
        app.add_subcommand("convert", "Write a mesh in another format, repaired, or made into another one");
    add_mesh(*convert, a);
    convert
        ->add_option_function<std::vector<std::string>>(
            "--to",
            [&](const std::vector<std::string>& texts) {
                for (const std::string& text : texts)
                    a.conversions.push_back(split_named("--to", text));
            },
            "Conversion, see 'polylap conversions'; several are applied in order")
        ->allow_extra_args(false)
        ->type_name("ID[:name=value,...]");
    add_output(*convert, a, "Mesh, in the format that the ending says")->required();
    add_file(*convert, "--vertex-map", a.second_out,
             "Rows 'vertex,original': which vertex of the file each vertex was, after --repair and before --to");
    convert->callback([&] {
        refuse_same_output(a, "--vertex-map");
        chosen = [&] { return tool::convert(a.mesh, a.conversions, a.out, a.second_out); };
    });
}

void declare_computations(CLI::App& app, Arguments& a, Command& chosen) {
    CLI::App* const matrix =
        app.add_subcommand("matrix", "Write the stiffness matrix S, and the mass M, as MatrixMarket");
    add_mesh(*matrix, a);
    add_operator(*matrix, a);
    add_output(*matrix, a, "Stiffness, unitless")->required();
    add_file(*matrix, "--mass-out", a.second_out, "Mass, length squared; - writes to standard output");
    matrix->callback([&] {
        refuse_same_output(a, "--mass-out");
        chosen = [&] { return tool::matrix(a.mesh, a.choice, a.out, a.second_out); };
    });

    CLI::App* const smooth = app.add_subcommand("smooth", "Smoothing steps, implicit or explicit");
    add_mesh(*smooth, a);
    add_operator(*smooth, a);
    auto* const times = smooth->add_option_group("time", "How far a step goes");
    add_time(*times, "--time", "t, in length squared", a.smooth.time)->type_name("T");
    add_time(*times, "--time-h2", "t in units of the mean squared edge length", a.smooth.time_h2)->type_name("X");
    times->require_option(1);
    constexpr int most_steps = 1'000'000;
    add_whole(*smooth, "--steps", "Number of steps", 1, most_steps,
              [&](double value) { a.smooth.steps = static_cast<int>(value); })
        ->default_str(std::to_string(a.smooth.steps))
        ->type_name("N");
    smooth
        ->add_option_function<std::string>(
            "--flow",
            [&](const std::string& name) {
                const auto flow = find_flow(name);
                if (!flow) throw CLI::ValidationError("--flow", flow.error().message);
                a.smooth.flow = *flow;
            },
            "implicit: (M + tS) x' = M x; conformalised: with S of the loaded mesh, scaled to its area; explicit: "
            "x' = x - t M^-1 S x, unstable for large t")
        ->default_str(flow_name(a.smooth.flow))
        ->type_name("FLOW");
    smooth->add_flag("--keep-operator", a.smooth.keep_operator,
                     "Keep S and M of the loaded mesh instead of rebuilding them before each step");
    smooth->add_flag("--keep-volume", a.smooth.keep_volume,
                     "Scale the surface after each step to the volume of the loaded mesh");
    smooth->add_flag("--fix-boundary", a.smooth.fix_boundary, "Leave the vertices on the boundary where they are");
    add_output(*smooth, a, "Smoothed mesh, in the format that the ending says")->required();
    smooth->callback([&] {
        if (a.smooth.keep_operator && a.smooth.flow == Flow::conformalised)
            throw CLI::ValidationError("--keep-operator", "the conformalised flow keeps S and rebuilds M");
        chosen = [&] { return tool::smooth(a.mesh, a.choice, a.smooth, a.out); };
    });

    CLI::App* const harmonic =
        app.add_subcommand("harmonic", "Interpolate values at some vertices harmonically over the mesh");
    add_mesh(*harmonic, a);
    add_operator(*harmonic, a);
    harmonic->add_option("--fix", a.fixed, "Rows 'vertex,value', vertices counted from 0; # starts a comment")
        ->required()
        ->type_name("FILE");
    add_output(*harmonic, a, "Rows 'vertex,value' of all vertices; nan at vertices in no face")->required();
    harmonic->callback([&] { chosen = [&] { return tool::harmonic(a.mesh, a.choice, a.fixed, a.out); }; });
}

void declare_measurements(CLI::App& app, Arguments& a, Command& chosen) {
    CLI::App* const check =
        app.add_subcommand("check", "Measure the properties of an operator on a mesh beside what it claims");
    add_mesh(*check, a);
    add_operator(*check, a);
    add_json(*check, a);
    add_file(*check, "--modes", a.second_out, "Rows 'vertex,mode0,...': an orthonormal basis of the kernel");
    check->callback([&] {
        refuse_standard_output(a.second_out, "--modes");
        chosen = [&] { return tool::check(a.mesh, a.choice, a.json, a.second_out); };
    });

    CLI::App* const convergence = app.add_subcommand(
        "convergence", "Study how an operator's solutions approach the smooth ones under refinement");
    add_operator(*convergence, a, false);
    add_json(*convergence, a);
    convergence->callback([&] { chosen = [&] { return tool::convergence(a.choice, a.json); }; });

    CLI::App* const spectrum = app.add_subcommand("spectrum", "Find the lowest eigenvalues of S x = μ M x");
    add_mesh(*spectrum, a);
    add_operator(*spectrum, a);
    add_whole(*spectrum, "--count", "How many, with multiplicity", 1, std::numeric_limits<Index>::max(),
              [&](double value) { a.count = static_cast<Index>(value); })
        ->default_str(std::to_string(a.count))
        ->type_name("K");
    add_json(*spectrum, a);
    add_file(*spectrum, "--modes", a.second_out,
             "Rows 'vertex,mode0,...': the eigenvectors, M-orthonormal; 0 at vertices in no face");
    spectrum->callback([&] {
        refuse_standard_output(a.second_out, "--modes");
        chosen = [&] { return tool::spectrum(a.mesh, a.choice, a.count, a.json, a.second_out); };
    });

    CLI::App* const face = app.add_subcommand("face", "Describe a face, and what it adds to the stiffness matrix");
    add_mesh(*face, a);
    add_operator(*face, a);
    add_whole(*face, "--face", "Its number, counted from 0", 0, std::numeric_limits<Index>::max(),
              [&](double value) { a.face = static_cast<Index>(value); })
        ->required()
        ->type_name("F");
    add_json(*face, a);
    face->callback([&] { chosen = [&] { return tool::face(a.mesh, a.choice, a.face, a.json); }; });

    CLI::App* const dual =
        app.add_subcommand("dual", "Orthogonal dual: a vertex per face, edges orthogonal to the mesh's");
    add_mesh(*dual, a);
    add_not_negative(*dual, "--mu",
                     "0: exactly orthogonal; above: nearer to the faces, with this weight on being orthogonal", a.mu)
        ->default_str("0")
        ->type_name("X");
    add_json(*dual, a);
    add_output(*dual, a, "The dual with all its vertices and edges, JSON (.json) or OBJ with lines (.obj)");
    dual->callback([&] { chosen = [&] { return tool::dual(a.mesh, a.mu, a.json, a.out); }; });
}

}  // namespace

void declare(CLI::App& app, Arguments& arguments, Command& chosen) {
    app.set_version_flag("--version", "polylap " POLYLAP_VERSION);
    app.require_subcommand(1);
    declare_descriptions(app, arguments, chosen);
    declare_makers(app, arguments, chosen);
    declare_computations(app, arguments, chosen);
    declare_measurements(app, arguments, chosen);
}

}  // namespace polylap::tool

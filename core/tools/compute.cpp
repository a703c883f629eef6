// The commands that compute: `matrix`, `smooth` and `harmonic`.
#include "commands.hpp"
#include "open_session.hpp"
#include "tables.hpp"

namespace polylap::tool {
namespace {

/// The operator and its parameters in one line.
std::string describe(const OperatorSpec& spec, const OperatorInfo& info) {
    std::string text = spec.id;
    for (std::size_t i = 0; i < info.parameters.size() && i < spec.values.size(); ++i) {
        const Parameter& parameter = info.parameters[i];
        text += std::string(", ") + parameter.id + " = ";
        if (parameter.kind == Parameter::Kind::choice)
            text += parameter.choices[static_cast<std::size_t>(spec.values[i])];
        else
            append_number(text, spec.values[i]);
    }
    return text;
}

std::string solve_text(const SmoothingSolve& solve) {
    std::string text = "last step solved by " + std::string(solver_name(solve.solver));
    if (solve.iterations > 0) text += ", " + std::to_string(solve.iterations) + " iterations";
    return text + "\n";
}

/// What bounds explicit steps, on the loaded mesh.
std::string stability_text(const Result<Stability>& stability, double time, double h2) {
    if (!stability) return "explicit steps: " + stability.error().message + "\n";
    std::string text;
    if (stability->limit() > 0) {
        append_number(text += "explicit steps stable for t < ", stability->limit());
        append_number(text += " (", stability->limit() / h2);
        text += " h²); the first multiplies the roughest mode by ";
    } else {
        append_number(text += "no explicit step is stable: S has the eigenvalue ", stability->smallest);
        text += "; the first multiplies a mode by ";
    }
    append_number(text, stability->growth(time));
    return text + "\n";
}

}  // namespace

Result<Outputs> matrix(const MeshChoice& mesh, const OperatorChoice& choice, const std::string& stiffness_path,
                       const std::string& mass_path) {
    auto session = open_with_operator(mesh, choice);
    if (!session) return session.error();
    const auto info = find_operator(choice.id);
    if (!info) return info.error();
    const auto matrices = session->matrices(side);
    if (!matrices) return in_file(mesh.path, matrices.error());
    const std::string description = describe(session->spec(side), **info);
    Outputs outputs{
        {stiffness_path, matrix_market((*matrices)->stiffness, (*info)->claims.symmetric.where == Claim::yes,
                                       "stiffness: " + description)}};
    if (!mass_path.empty())
        outputs.push_back({mass_path, matrix_market((*matrices)->mass, true, "mass: " + description)});
    return outputs;
}

Result<Outputs> smooth(const MeshChoice& mesh, const OperatorChoice& choice, const SmoothChoice& options,
                       const std::string& path) {
    auto session = open_with_operator(mesh, choice);
    if (!session) return session.error();
    const double h2 = session->shape(side).measures.mean_squared_edge;
    const double time = options.time ? *options.time : options.time_h2.value() * h2;
    const Session::SmoothOptions flow{.time = time,
                                      .steps = options.steps,
                                      .flow = options.flow,
                                      .rebuild = !options.keep_operator,
                                      .keep_volume = options.keep_volume,
                                      .fix_boundary = options.fix_boundary};
    std::string report;
    if (options.flow == Flow::explicit_step && path != "-")
        report = stability_text(session->stability(side, flow), time, h2);
    if (auto status = session->smooth(side, flow); !status) return in_file(mesh.path, status.error());
    auto output = mesh_output(session->surface(side), path);
    if (!output) return output.error();
    Outputs outputs{*std::move(output)};
    if (path != "-") outputs.push_back({"-", report + solve_text(session->last_solve(side).value())});
    return outputs;
}

Result<Outputs> harmonic(const MeshChoice& mesh, const OperatorChoice& choice, const std::string& fixed_path,
                         const std::string& path) {
    auto session = open_with_operator(mesh, choice);
    if (!session) return session.error();
    const auto text = read_file(fixed_path);
    if (!text) return text.error();
    const auto fixed = parse_vertex_values(*text, session->mesh().vertex_count(), "value");
    if (!fixed) return in_file(fixed_path, fixed.error());
    const auto result = session->harmonic(side, fixed->vertices, fixed->values);
    if (!result) return in_file(mesh.path, result.error());
    return Outputs{{path, values_csv(result->values)}};
}

}  // namespace polylap::tool

// The commands that measure: `check`, `convergence` and `dual`.
#include <cmath>
#include <iomanip>
#include <sstream>

#include "json_text.hpp"
#include "open_session.hpp"
#include "polylap/apply/convergence.hpp"
#include "tables.hpp"

namespace polylap::tool {
namespace {

const char* verdict_name(Measurement::Verdict verdict) {
    switch (verdict) {
        case Measurement::Verdict::holds:
            return "holds";
        case Measurement::Verdict::fails:
            return "fails";
        case Measurement::Verdict::not_measured:
            return "not-measured";
    }
    return "unknown";
}

std::string counted(Index count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

ordered_json report_json(const PropertyReport& report, const OperatorInfo& info) {
    ordered_json properties = ordered_json::object();
    for (const Measurement& m : report.measurements) {
        const PropertyClaim& claim = info.claims.*m.property->claim;
        properties[m.property->id] = {{"claim", claim_name(claim.where)},
                                      {"why", claim.why},
                                      {"measured", verdict_name(m.verdict)},
                                      {"value", m.value},
                                      {"text", m.text},
                                      {"vertices", m.vertices}};
    }
    return {{"operator", info.id},
            {"properties", properties},
            {"negativeOrdered", report.negative_ordered},
            {"negativePairs", report.negative_pairs},
            {"smallestEigenvalue", report.smallest_eigenvalue},
            {"largestEigenvalue", report.largest_eigenvalue},
            {"components", report.components},
            {"kernelDimension", report.kernel_dimension},
            {"kernelComplete", report.kernel_complete},
            {"condition", report.condition},
            {"smallestMass", report.smallest_mass},
            {"smallestMassVertex", report.smallest_mass_vertex}};
}

std::string report_text(const PropertyReport& report, const OperatorInfo& info) {
    std::ostringstream text;
    text << std::setprecision(6) << std::left;
    for (const Measurement& m : report.measurements) {
        const PropertyClaim& claim = info.claims.*m.property->claim;
        const bool measured = m.verdict != Measurement::Verdict::not_measured;
        text << m.property->label << ": " << (measured ? verdict_name(m.verdict) : "not measured") << ", " << m.text
             << "\n    claimed: " << claim_name(claim.where) << ", " << claim.why << '\n';
    }
    text << '\n';
    const auto line = [&text](const char* label) -> std::ostream& { return text << std::setw(24) << label; };
    line("negative weights") << report.negative_ordered << " ordered, "
                             << counted(report.negative_pairs, "pair", "pairs") << '\n';
    if (std::isfinite(report.smallest_eigenvalue)) {
        line("smallest eigenvalue") << report.smallest_eigenvalue << '\n';
        line("largest eigenvalue") << report.largest_eigenvalue << '\n';
        line("kernel dimension") << (report.kernel_complete ? "" : "at least ") << report.kernel_dimension << " on "
                                 << counted(report.components, "component", "components") << '\n';
        line("condition number");
        if (std::isfinite(report.condition))
            text << report.condition << '\n';
        else
            text << "unknown: no eigenvalue beside the kernel was found\n";
    }
    line("smallest mass") << report.smallest_mass << " at vertex " << report.smallest_mass_vertex << '\n';
    return text.str();
}

ordered_json point(const Vector3& p) {
    return {p.x(), p.y(), p.z()};
}

ordered_json dual_summary(const OrthogonalDual& dual) {
    return {{"constraints", dual.constraints}, {"rank", dual.rank},
            {"nullSpace", dual.null_space},    {"residual", dual.residual},
            {"worstEdge", dual.worst_edge},    {"largestShift", dual.largest_shift},
            {"worstFace", dual.worst_face},    {"usable", dual.usable}};
}

ordered_json dual_json(const OrthogonalDual& dual) {
    ordered_json json = dual_summary(dual);
    json["vertices"] = ordered_json::array();
    for (Eigen::Index f = 0; f < dual.vertices.rows(); ++f)
        json["vertices"].push_back(point(dual.vertices.row(f).transpose()));
    json["edges"] = ordered_json::array();
    for (const DualEdge& e : dual.edges)
        json["edges"].push_back({{"vertices", {e.v0, e.v1}},
                                 {"faces", {e.face0, e.face1}},
                                 {"point", point(e.point)},
                                 {"lengths", {e.length0, e.length1}},
                                 {"weight", e.weight}});
    return json;
}

/// Dual vertices, then edge points, and a line v_k – point – v_l per edge: what viewers of OBJ can draw.
std::string dual_obj(const OrthogonalDual& dual) {
    std::string text = "# orthogonal dual: a vertex per face, then one per edge\n";
    const auto vertex = [&text](const Vector3& p) {
        text += 'v';
        for (int k = 0; k < 3; ++k) {
            text += ' ';
            append_number(text, p[k]);
        }
        text += '\n';
    };
    for (Eigen::Index f = 0; f < dual.vertices.rows(); ++f)
        vertex(dual.vertices.row(f).transpose());
    for (const DualEdge& e : dual.edges)
        vertex(e.point);
    std::int64_t middle = dual.vertices.rows();
    for (const DualEdge& e : dual.edges) {
        ++middle;
        text += 'l';
        if (e.face0 >= 0) text += ' ' + std::to_string(e.face0 + 1);
        text += ' ' + std::to_string(middle);
        if (e.face1 >= 0) text += ' ' + std::to_string(e.face1 + 1);
        text += '\n';
    }
    return text;
}

std::string dual_text(const OrthogonalDual& dual) {
    std::ostringstream text;
    text << std::setprecision(4) << std::left;
    const auto line = [&text](const char* label) -> std::ostream& { return text << std::setw(22) << label; };
    line("dual vertices") << dual.vertices.rows() << '\n';
    line("constraints") << dual.constraints << '\n';
    line("rank") << dual.rank << '\n';
    line("null space") << dual.null_space << '\n';
    line("residual") << dual.residual << " of the largest squared edge\n";
    line("largest shift") << dual.largest_shift << " times the root of its area, of face " << dual.worst_face << '\n';
    line("usable") << (dual.usable ? "yes" : "no: its vertices lie faces away from their own") << '\n';
    return text.str();
}

}  // namespace

Result<Outputs> check(const MeshChoice& mesh, const OperatorChoice& choice, bool json, const std::string& modes_path) {
    auto session = open_with_operator(mesh, choice);
    if (!session) return session.error();
    const auto info = find_operator(choice.id);
    if (!info) return info.error();
    const auto report = session->check(side);
    if (!report) return in_file(mesh.path, report.error());
    Outputs outputs{{"-", json ? dump(report_json(**report, **info)) : report_text(**report, **info)}};
    if (!modes_path.empty()) outputs.push_back({modes_path, modes_csv((*report)->kernel_modes)});
    return outputs;
}

Result<Outputs> convergence(const OperatorChoice& choice, bool json) {
    const auto spec = make_spec(choice.id, choice.settings);
    if (!spec) return spec.error();
    const auto info = find_operator(choice.id);
    if (!info) return info.error();
    const auto studies = study_convergence(*spec);
    if (!studies) return studies.error();
    const PropertyClaim& claim = (*info)->claims.convergent;
    ordered_json document{{"operator", choice.id},
                          {"claim", claim_name(claim.where)},
                          {"why", claim.why},
                          {"studies", ordered_json::array()}};
    std::ostringstream text;
    text << std::setprecision(4) << std::left << "claimed: " << claim_name(claim.where) << ", " << claim.why << '\n';
    for (const ConvergenceStudy& study : *studies) {
        ordered_json levels = ordered_json::array();
        text << '\n'
             << study.family << ": " << study.problem << '\n'
             << std::setw(12) << "  vertices" << std::setw(12) << "h" << std::setw(14) << "error"
             << "order\n";
        for (const ConvergenceLevel& level : study.levels) {
            levels.push_back(
                {{"vertices", level.vertices}, {"h", level.h}, {"error", level.error}, {"order", level.order}});
            text << "  " << std::setw(10) << level.vertices << std::setw(12) << level.h << std::setw(14) << level.error;
            if (&level == &study.levels.front())
                text << "-\n";
            else
                text << level.order << '\n';
        }
        text << "  " << (study.converges ? "converges" : "does not converge");
        if (!study.failure.empty()) text << ": " << study.failure;
        text << '\n';
        document["studies"].push_back({{"family", study.family},
                                       {"problem", study.problem},
                                       {"levels", levels},
                                       {"order", study.order},
                                       {"converges", study.converges},
                                       {"failure", study.failure}});
    }
    return Outputs{{"-", json ? dump(document) : text.str()}};
}

Result<Outputs> dual(const MeshChoice& mesh, double mu, bool json, const std::string& path) {
    // Standard output has no ending: there, --json says it.
    const bool as_json = path == "-" ? json : path.ends_with(".json");
    if (!path.empty() && path != "-" && !as_json && !path.ends_with(".obj")) {
        return Error{ErrorCode::bad_argument, "the name '" + path + "' of a dual must end in .json or .obj"};
    }
    auto session = open_session(mesh);
    if (!session) return session.error();
    const auto dual = session->dual(side, {.mu = mu});
    if (!dual) return in_file(mesh.path, dual.error());
    Outputs outputs;
    if (!path.empty()) outputs.push_back({path, as_json ? dump(dual_json(*dual)) : dual_obj(*dual)});
    if (path != "-") outputs.push_back({"-", json ? dump(dual_summary(*dual)) : dual_text(*dual)});
    return outputs;
}

}  // namespace polylap::tool

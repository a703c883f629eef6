// The commands that describe: `info` and the tables `operators`, `shapes`, `conversions`.
#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>

#include "json_text.hpp"
#include "open_session.hpp"
#include "polylap/apply/conversions.hpp"
#include "polylap/mesh/shapes.hpp"
#include "polylap/mesh/topology.hpp"

namespace polylap::tool {
namespace {

std::string info_text(const ordered_json& facts, const Session& session) {
    std::ostringstream text;
    text << std::setprecision(10);
    const auto line = [&text](const char* label) -> std::ostream& {
        text << std::left << std::setw(22) << label;
        return text;
    };
    const auto or_why = [&facts](const char* value, const char* why) {
        return facts[value].is_null() ? "none: " + facts[why].get<std::string>() : facts[value].dump();
    };
    line("vertices") << facts["vertices"] << '\n';
    line("faces") << facts["faces"] << '\n';
    line("edges") << facts["edges"] << '\n';
    line("components") << facts["components"] << '\n';
    line("boundary vertices") << facts["boundaryVertices"] << '\n';
    line("boundary loops") << or_why("boundaryLoops", "noBoundaryLoops") << '\n';
    line("corners: faces");
    const char* separator = "";
    for (const auto& [corners, faces] : facts["faceSizes"].items()) {
        text << separator << corners << ": " << faces;
        separator = ", ";
    }
    text << '\n';
    line("area") << facts["area"] << '\n';
    line("volume") << or_why("volume", "noVolume") << '\n';
    line("mean non-planarity") << facts["meanNonPlanarity"] << '\n';
    line("mean squared edge") << facts["meanSquaredEdge"] << '\n';
    for (const auto& issue : facts["issues"])
        line("issue") << issue["message"].get<std::string>() << '\n';
    return text.str() + reading_text(session);
}

const char* kind_name(Parameter::Kind kind) {
    switch (kind) {
        case Parameter::Kind::real:
            return "real";
        case Parameter::Kind::integer:
            return "integer";
        case Parameter::Kind::choice:
            return "choice";
    }
    return "unknown";
}

ordered_json parameter_json(const Parameter& parameter) {
    const bool choice = parameter.kind == Parameter::Kind::choice;
    ordered_json json{{"id", parameter.id},     {"label", parameter.label},     {"kind", kind_name(parameter.kind)},
                      {"min", parameter.min},   {"max", parameter.max},         {"sliderMax", parameter.slider_max},
                      {"step", parameter.step}, {"initial", parameter.initial}, {"hint", parameter.hint}};
    if (choice) json["choices"] = std::vector<std::string>(parameter.choices.begin(), parameter.choices.end());
    return json;
}

void append_parameters(std::ostream& text, std::span<const Parameter> parameters) {
    for (const Parameter& parameter : parameters) {
        text << "  --set " << parameter.id << '=';
        if (parameter.kind == Parameter::Kind::choice) {
            const char* separator = "";
            for (const char* choice : parameter.choices) {
                text << separator << choice;
                separator = "|";
            }
            text << ", initially " << parameter.choices[static_cast<std::size_t>(parameter.initial)];
        } else {
            text << parameter.min << "..." << parameter.max << ", initially " << parameter.initial;
        }
        text << (*parameter.hint != '\0' ? "; " : "") << parameter.hint << '\n';
    }
}

ordered_json parameters_json(std::span<const Parameter> parameters) {
    ordered_json json = ordered_json::array();
    for (const Parameter& parameter : parameters)
        json.push_back(parameter_json(parameter));
    return json;
}

ordered_json operator_json(const OperatorInfo& info) {
    ordered_json claims = ordered_json::object();
    for (const PropertyInfo& property : properties()) {
        const PropertyClaim& claim = info.claims.*property.claim;
        claims[property.id] = {{"where", claim_name(claim.where)}, {"why", claim.why}};
    }
    return {{"id", info.id},
            {"label", info.label},
            {"formula", info.formula_latex},
            {"citation", info.citation},
            {"bibtex", info.bibtex},
            {"summary", info.summary},
            {"parameters", parameters_json(info.parameters)},
            {"takesVertexWeights", info.takes_vertex_weights},
            {"claims", claims}};
}

void append_operator_text(std::ostream& text, const OperatorInfo& info) {
    text << info.id << "  " << info.label << "\n  " << info.summary << "\n  " << info.formula_latex << "\n  "
         << info.citation << '\n';
    append_parameters(text, info.parameters);
    if (info.takes_vertex_weights) text << "  --weights FILE: a weight per vertex, length squared\n";
    for (const PropertyInfo& property : properties()) {
        const PropertyClaim& claim = info.claims.*property.claim;
        text << "  " << property.label << ": " << claim_name(claim.where) << ", " << claim.why << '\n';
    }
}

/// A table whose lines have id, label, summary and parameters.
template <class Table>
Result<Outputs> maker_table(const Table& table, bool json) {
    ordered_json document = ordered_json::array();
    std::ostringstream text;
    for (const auto* entry : table) {
        document.push_back({{"id", entry->id},
                            {"label", entry->label},
                            {"summary", entry->summary},
                            {"parameters", parameters_json(entry->parameters)}});
        text << entry->id << "  " << entry->summary << '\n';
        append_parameters(text, entry->parameters);
    }
    return Outputs{{"-", json ? dump(document) : text.str()}};
}

}  // namespace

Result<Outputs> shape_table(bool json) {
    return maker_table(shapes(), json);
}

Result<Outputs> conversion_table(bool json) {
    return maker_table(conversions(), json);
}

Result<Outputs> info(const MeshChoice& choice, bool json) {
    const auto session = open_session(choice);
    if (!session) return session.error();
    const PolygonMesh& mesh = session->mesh();
    const Topology& topology = session->topology();
    const Session::Shape shape = session->shape(Session::Side::a);
    const auto loops = boundary_loops(topology);
    std::map<std::size_t, Index> sizes;
    for (Index f = 0; f < mesh.face_count(); ++f)
        ++sizes[mesh.face(f).size()];

    ordered_json facts{{"vertices", mesh.vertex_count()},
                       {"faces", mesh.face_count()},
                       {"edges", topology.edges.size()},
                       {"components", topology.component_count},
                       {"boundaryVertices", topology.boundary_vertices.size()},
                       {"boundaryLoops", nullptr}};
    if (loops)
        facts["boundaryLoops"] = loops->size();
    else
        facts["noBoundaryLoops"] = loops.error().message;
    facts["faceSizes"] = ordered_json::object();
    for (const auto& [corners, faces] : sizes)
        facts["faceSizes"][std::to_string(corners)] = faces;
    facts["area"] = shape.measures.area;
    facts["volume"] = nullptr;
    if (shape.volume)
        facts["volume"] = *shape.volume;
    else
        facts["noVolume"] = shape.no_volume;
    facts["meanNonPlanarity"] = shape.measures.mean_non_planarity;
    facts["meanSquaredEdge"] = shape.measures.mean_squared_edge;
    facts["issues"] = ordered_json::array();
    for (const MeshIssue& issue : find_issues(topology))
        facts["issues"].push_back(
            {{"kind", issue_name(issue.kind)}, {"count", issue.count}, {"message", issue.message}});
    facts["notes"] = session->notes();
    facts["repairs"] = ordered_json::array();
    for (const RepairChange& change : session->repairs().changes)
        facts["repairs"].push_back(
            {{"kind", repair_name(change.kind)}, {"elements", change.elements}, {"message", change.message}});
    return Outputs{{"-", json ? dump(facts) : info_text(facts, *session)}};
}

Result<Outputs> operator_table(bool json, bool bibtex) {
    if (bibtex) {
        std::vector<std::string_view> entries;
        std::string text;
        for (const OperatorInfo* info : operators()) {
            if (std::find(entries.begin(), entries.end(), info->bibtex) != entries.end()) continue;
            text += (entries.empty() ? "" : "\n") + std::string(info->bibtex) + '\n';
            entries.emplace_back(info->bibtex);
        }
        return Outputs{{"-", text}};
    }
    if (json) {
        ordered_json table = ordered_json::array();
        for (const OperatorInfo* entry : operators())
            table.push_back(operator_json(*entry));
        return Outputs{{"-", dump(table)}};
    }
    std::ostringstream text;
    for (const OperatorInfo* entry : operators()) {
        if (entry != operators().front()) text << '\n';
        append_operator_text(text, *entry);
    }
    return Outputs{{"-", text.str()}};
}

}  // namespace polylap::tool

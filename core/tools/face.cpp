// The command `face`.
#include <iomanip>
#include <sstream>

#include "json_text.hpp"
#include "open_session.hpp"

namespace polylap::tool {
namespace {

ordered_json face_json(const FaceReport& report, Index face, const std::string& id) {
    const auto triple = [](const Vector3& v) { return std::array{v[0], v[1], v[2]}; };
    ordered_json json{{"face", face},
                      {"corners", report.corners},
                      {"vectorArea", triple(report.vector_area)},
                      {"normal", triple(report.normal)},
                      {"nonPlanarity", report.non_planarity},
                      {"projected", ordered_json::array()},
                      {"operator", id},
                      {"triangles", report.triangles},
                      {"stiffness", nullptr}};
    for (const Eigen::Vector2d& point : report.projected)
        json["projected"].push_back({point.x(), point.y()});
    if (!report.stiffness) {
        json["noStiffness"] = report.no_stiffness;
        return json;
    }
    json["stiffness"] = ordered_json::array();
    for (const auto& row : report.stiffness->rowwise())
        json["stiffness"].push_back(std::vector<double>(row.begin(), row.end()));
    return json;
}

std::string face_text(const FaceReport& report, const std::string& id) {
    std::ostringstream text;
    text << std::setprecision(10) << std::left;
    const auto line = [&text](const char* label) -> std::ostream& { return text << std::setw(22) << label; };
    const auto triple = [](const Vector3& v) {
        std::ostringstream words;
        words << std::setprecision(10) << v[0] + 0.0 << ' ' << v[1] + 0.0 << ' ' << v[2] + 0.0;  // a zero has no sign
        return words.str();
    };
    line("corners");
    for (const Index v : report.corners)
        text << v << ' ';
    text << '\n';
    line("vector area") << triple(report.vector_area) << '\n';
    line("area") << report.vector_area.norm() << '\n';
    line("normal") << triple(report.normal) << '\n';
    line("non-planarity") << report.non_planarity << '\n';
    line("cut into");
    if (report.triangles.empty()) text << "no triangles";
    for (const Triangle& t : report.triangles) {
        for (const Index k : t)
            text << report.corners[static_cast<std::size_t>(k)] << ' ';
        text << (t == report.triangles.back() ? "" : "| ");
    }
    text << "\n\nWhat it adds to S of " << id << ":\n";
    if (!report.stiffness) return text.str() + "nothing by itself: " + report.no_stiffness + '\n';
    text << std::setprecision(6) << std::right;
    for (const auto& row : report.stiffness->rowwise()) {
        for (const double entry : row)
            text << std::setw(13) << entry;
        text << '\n';
    }
    return text.str();
}

}  // namespace

Result<Outputs> face(const MeshChoice& mesh, const OperatorChoice& choice, Index face, bool json) {
    const auto session = open_with_operator(mesh, choice);
    if (!session) return session.error();
    const auto report = session->face(side, face);
    if (!report) return in_file(mesh.path, report.error());
    return Outputs{{"-", json ? dump(face_json(*report, face, choice.id)) : face_text(*report, choice.id)}};
}

}  // namespace polylap::tool

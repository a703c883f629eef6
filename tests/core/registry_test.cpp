#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "polylap/mesh/shapes.hpp"
#include "polylap/operators/alexa_wardetzky.hpp"
#include "polylap/operators/operator.hpp"
#include "polylap/operators/planar.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Settings = std::vector<std::pair<std::string, std::string>>;

bool is_kebab_case(std::string_view id) {
    return !id.empty() && id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string_view::npos &&
           id.front() != '-' && id.back() != '-';
}

/// key → what is between its braces; `type` and `key` of the entry itself too.
std::map<std::string, std::string> fields_of(const std::string& bibtex) {
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz";
    std::istringstream lines(bibtex);
    std::string line;
    std::getline(lines, line);
    const auto open = line.find('{');
    if (line.empty() || line.front() != '@' || line.back() != ',' || open == std::string::npos) return {};
    std::map<std::string, std::string> fields{{"type", line.substr(1, open - 1)},
                                              {"key", line.substr(open + 1, line.size() - open - 2)}};
    const std::string& key = fields["key"];
    EXPECT_EQ(fields["type"].find_first_not_of(letters), std::string::npos) << line;
    EXPECT_EQ(key.find_first_not_of(letters) + 4, key.size()) << "a name and a year: " << key;
    while (std::getline(lines, line) && line != "}") {
        if (line.back() == ',') line.pop_back();
        const auto equals = line.find(" = {");
        if (line.substr(0, 2) != "  " || equals == std::string::npos || line.back() != '}') {
            ADD_FAILURE() << line;
            continue;
        }
        const std::string name = line.substr(2, equals - 2);
        EXPECT_EQ(name.find_first_not_of(letters), std::string::npos) << name;
        const std::string value = line.substr(equals + 4, line.size() - equals - 5);
        EXPECT_TRUE(fields.emplace(name == "type" ? "kind" : name, value).second) << name;
    }
    EXPECT_EQ(line, "}");
    EXPECT_FALSE(std::getline(lines, line)) << line;
    return fields;
}

TEST(Table, CitesInBibtex) {
    std::map<std::string, std::string> by_key;
    for (const OperatorInfo* info : operators()) {
        const std::string entry = info->bibtex;
        int depth = 0;
        for (const char c : entry) {
            depth += c == '{' ? 1 : c == '}' ? -1 : 0;
            EXPECT_GE(depth, 0) << info->id;
            EXPECT_TRUE(c == '\n' || (c >= ' ' && c <= '~')) << info->id << ": not plain text";
        }
        EXPECT_EQ(depth, 0) << info->id;
        const auto fields = fields_of(entry);
        for (const char* needed : {"type", "key", "author", "title", "year"}) {
            ASSERT_EQ(fields.count(needed), 1U) << info->id << ": " << needed;
        }
        for (const auto& [name, value] : fields) {
            EXPECT_NE(value.find_first_not_of(" {}"), std::string::npos) << info->id << ": " << name;
        }
        EXPECT_NE(fields.at("key").find(fields.at("year")), std::string::npos) << info->id;
        // The line for people names the same year.
        EXPECT_NE(std::string(info->citation).find(fields.at("year")), std::string::npos) << info->id;
        // One key, one work.
        EXPECT_EQ(by_key.emplace(fields.at("key"), entry).first->second, entry) << info->id;
    }
    EXPECT_GT(by_key.size(), 5U);
}

TEST(Table, IsComplete) {
    std::set<std::string_view> ids;
    ASSERT_GE(operators().size(), 2u);
    for (const OperatorInfo* info : operators()) {
        ASSERT_NE(info, nullptr);
        EXPECT_TRUE(is_kebab_case(info->id)) << info->id;
        EXPECT_TRUE(ids.insert(info->id).second) << info->id;
        for (const char* text : {info->label, info->formula_latex, info->citation, info->summary}) {
            ASSERT_NE(text, nullptr) << info->id;
            EXPECT_GT(std::string_view(text).size(), 3u) << info->id;
        }
        EXPECT_NE(info->build, nullptr);
        std::set<std::string_view> names;
        for (const Parameter& p : info->parameters) {
            EXPECT_TRUE(is_kebab_case(p.id)) << p.id;
            EXPECT_TRUE(names.insert(p.id).second) << p.id;
            EXPECT_FALSE(std::string_view(p.label).empty());
            ASSERT_NE(p.hint, nullptr);
            EXPECT_LT(p.min, p.max);
            EXPECT_LE(p.min, p.initial);
            EXPECT_LE(p.initial, p.slider_max);
            EXPECT_LE(p.slider_max, p.max);
            EXPECT_GT(p.step, 0);
            EXPECT_EQ(p.kind == Parameter::Kind::choice, !p.choices.empty());
            if (p.kind != Parameter::Kind::choice) continue;
            EXPECT_EQ(p.min, 0);
            EXPECT_EQ(p.max, static_cast<double>(p.choices.size()) - 1);
            EXPECT_EQ(p.step, 1);
            for (const char* choice : p.choices) {
                EXPECT_TRUE(is_kebab_case(choice)) << choice;
            }
        }
    }
}

TEST(Table, ListsTheThesisInItsOrder) {
    const char* const thesis[] = {"umbrella",       "tutte",           "normalized-graph",         "cotan",
                                  "weighted-cotan", "alexa-wardetzky", "alexa-wardetzky-weighted", "planar"};
    auto at = operators().begin();
    for (const char* id : thesis) {
        at =
            std::find_if(at, operators().end(), [id](const OperatorInfo* info) { return std::string(info->id) == id; });
        ASSERT_NE(at, operators().end()) << id;
    }
    const OperatorInfo& aw = **find_operator("alexa-wardetzky");
    ASSERT_EQ(aw.parameters.size(), 1u);
    EXPECT_STREQ(aw.parameters[0].id, "lambda");
    EXPECT_EQ(aw.parameters[0].initial, 1);
    const OperatorInfo& planar = **find_operator("planar");
    ASSERT_EQ(planar.parameters.size(), 1u);
    EXPECT_STREQ(planar.parameters[0].id, "rule");
    EXPECT_STREQ(planar.parameters[0].choices[static_cast<std::size_t>(planar.parameters[0].initial)], "delaunay");
    EXPECT_EQ(opening_pair()[0], &alexa_wardetzky_info);
    EXPECT_EQ(opening_pair()[1], &planar_info);
}

TEST(Table, ChoicesAreTheRulesTheyName) {
    const auto& mesh = specimen("wavy-9");
    const std::pair<const char*, TriangulationRule> rules[] = {
        {"delaunay", TriangulationRule::delaunay},
        {"min-max-angle", TriangulationRule::min_max_angle},
        {"shortest-diagonal", TriangulationRule::shortest_diagonal},
        {"fan", TriangulationRule::fan}};
    for (const auto& [name, rule] : rules) {
        const auto spec = get(make_spec("planar", Settings{{"rule", name}}));
        EXPECT_EQ(
            (Matrix(get(build_operator(mesh, spec)).stiffness) - Matrix(get(planar_stiffness(mesh, {rule})))).norm(), 0)
            << name;
    }
}

TEST(Specs, AreFilledFromTheTable) {
    for (const OperatorInfo* info : operators()) {
        const auto spec = get(complete_spec({info->id, {}}));
        ASSERT_EQ(spec.values.size(), info->parameters.size());
        for (std::size_t k = 0; k < spec.values.size(); ++k) {
            EXPECT_EQ(spec.values[k], info->parameters[k].initial);
        }
        EXPECT_EQ(get(make_spec(info->id, {})), spec);
        EXPECT_EQ(get(find_operator(info->id)), info);
    }
    EXPECT_EQ(get(make_spec("alexa-wardetzky", Settings{{"lambda", "0.5"}})).values, std::vector<double>{0.5});
    EXPECT_EQ(get(make_spec("alexa-wardetzky", Settings{{"lambda", "1e-3"}})).values, std::vector<double>{0.001});
    EXPECT_EQ(get(make_spec("alexa-wardetzky", Settings{{"lambda", "0"}})).values, std::vector<double>{0});
    EXPECT_EQ(get(make_spec("planar", Settings{{"rule", "fan"}})).values, std::vector<double>{3});
}

template <class T>
void expect_error(const Result<T>& result, ErrorCode code, std::initializer_list<const char*> words,
                  const std::string& what) {
    ASSERT_FALSE(result.ok()) << what;
    EXPECT_EQ(result.error().code, code) << what << ": " << result.error().message;
    for (const char* word : words) {
        EXPECT_NE(result.error().message.find(word), std::string::npos) << what << ": " << result.error().message;
    }
}

TEST(Specs, UnknownOperatorsAreNamedWithTheKnownOnes) {
    for (const char* id : {"cotangent", "", "Planar", "planar "}) {
        expect_error(find_operator(id), ErrorCode::unknown_operator, {id, "alexa-wardetzky", "planar"}, id);
        expect_error(make_spec(id, {}), ErrorCode::unknown_operator, {"alexa-wardetzky"}, id);
        expect_error(complete_spec({id, {}}), ErrorCode::unknown_operator, {"alexa-wardetzky"}, id);
        expect_error(build_operator(specimen("grid-2x2"), {id, {}}), ErrorCode::unknown_operator, {"alexa-wardetzky"},
                     id);
    }
}

TEST(Specs, TextsMustBeNumbersOrChoices) {
    for (const char* text : {"abc", "", "1x", " 1", "1,5", "nan", "inf", "0x10", "1e999"}) {
        expect_error(make_spec("alexa-wardetzky", Settings{{"lambda", text}}), ErrorCode::bad_argument,
                     {"lambda", text}, text);
    }
    for (const char* text : {"Fan", "", "0", "fans"}) {
        expect_error(make_spec("planar", Settings{{"rule", text}}), ErrorCode::bad_argument,
                     {"rule", text, "delaunay", "fan"}, text);
    }
    expect_error(make_spec("planar", Settings{{"lambda", "1"}}), ErrorCode::bad_argument, {"planar", "lambda"},
                 "another's parameter");
}

TEST(Specs, ValuesMustLieInTheirRange) {
    for (const OperatorInfo* info : operators()) {
        expect_error(complete_spec({info->id, std::vector<double>(info->parameters.size() + 1, 0.0)}),
                     ErrorCode::bad_argument, {info->id}, "too many values");
        for (std::size_t k = 0; k < info->parameters.size(); ++k) {
            const Parameter& p = info->parameters[k];
            for (const double bad :
                 {p.min - 1, p.max + 1, std::nextafter(p.min, -infinity), nan, infinity, -infinity}) {
                OperatorSpec spec = get(complete_spec({info->id, {}}));
                spec.values[k] = bad;
                expect_error(complete_spec(spec), ErrorCode::parameter_out_of_range, {p.id}, std::to_string(bad));
                expect_error(build_operator(specimen("grid-2x2"), spec), ErrorCode::parameter_out_of_range, {p.id},
                             std::to_string(bad));
            }
            for (const double good : {p.min, p.max}) {
                OperatorSpec spec = get(complete_spec({info->id, {}}));
                spec.values[k] = good;
                EXPECT_TRUE(build_operator(specimen("grid-2x2"), spec).ok()) << p.id << " = " << good;
            }
            if (p.kind != Parameter::Kind::choice) continue;
            OperatorSpec spec = get(complete_spec({info->id, {}}));
            spec.values[k] = 0.5;
            expect_error(complete_spec(spec), ErrorCode::parameter_out_of_range, {p.id}, "between two choices");
        }
    }
    expect_error(make_spec("alexa-wardetzky", Settings{{"lambda", "-0.1"}}), ErrorCode::parameter_out_of_range,
                 {"lambda", "0"}, "λ < 0");
    for (const double bad : {-1e-9, nan, infinity}) {
        expect_error(alexa_wardetzky_stiffness(specimen("grid-2x2"), {bad}), ErrorCode::parameter_out_of_range, {},
                     "direct call");
    }
}

TEST(Specs, WeightsOfVertices) {
    const auto& mesh = specimen("grid-2x2");
    const std::vector<double> ones(static_cast<std::size_t>(mesh.vertex_count()), 1.0);
    std::vector<double> broken = ones;
    broken[3] = nan;
    int takers = 0;
    for (const OperatorInfo* info : operators()) {
        if (!info->takes_vertex_weights) {
            expect_error(build_operator(mesh, {info->id, {}, ones}), ErrorCode::bad_argument,
                         {info->id, "takes no vertex weights"}, info->id);
            continue;
        }
        ++takers;
        EXPECT_TRUE(build_operator(mesh, {info->id, {}, ones}).ok()) << info->id;
        expect_error(build_operator(mesh, {info->id, {}, {1, 2}}), ErrorCode::bad_argument, {"9 vertices", "2 vertex"},
                     info->id);
        const auto refused = build_operator(mesh, {info->id, {}, broken});
        expect_error(refused, ErrorCode::bad_argument, {"vertex 3", "not finite"}, info->id);
        EXPECT_EQ(refused.error().element, 3);
    }
    EXPECT_EQ(takers, 2);
}

TEST(Claims, HaveNames) {
    EXPECT_EQ(claim_name(Claim::yes), "yes");
    EXPECT_EQ(claim_name(Claim::planar), "planar");
    EXPECT_EQ(claim_name(Claim::triangles), "triangles");
    EXPECT_EQ(claim_name(Claim::some), "some");
    EXPECT_EQ(claim_name(Claim::no), "no");
}

/// The face is named, or the operator does not look at positions at all: then it is false.
bool expect_refused(const PolygonMesh& mesh, const OperatorSpec& spec, Index face, const std::string& what) {
    const auto result = build_operator(mesh, spec);
    if (result.ok()) {
        Points elsewhere = mesh.positions();
        elsewhere.col(2) += elsewhere.col(0).cwiseAbs2() + 0.3 * elsewhere.col(1);
        const auto moved = build_operator(get(mesh.with_positions(elsewhere)), spec);
        EXPECT_TRUE(moved.ok() && (Matrix(moved->stiffness) - Matrix(result->stiffness)).norm() == 0)
            << what << ", " << spec_name(spec) << " takes a face without area";
        return false;
    }
    EXPECT_EQ(result.error().code, ErrorCode::degenerate_face) << what;
    EXPECT_EQ(result.error().element, face) << what << ": " << result.error().message;
    EXPECT_NE(result.error().message.find("face " + std::to_string(face)), std::string::npos) << result.error().message;
    return true;
}

TEST(Refusals, AFaceWithoutVectorArea) {
    const std::vector<Vector3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}, {1, 1, 0}};
    for (const double scale : {1e-6, 1.0, 1e6}) {
        std::vector<Vector3> p = points;
        for (Vector3& x : p) {
            x *= scale;
        }
        const auto line = make_mesh(p, {{0, 1, 2, 3}, {1, 4, 5}});
        const auto bow_tie = make_mesh(p, {{0, 1, 2}, {0, 2, 3}, {0, 2, 1, 3}});
        const auto twice = make_mesh(p, {{0, 1, 2}, {1, 2, 6}});  // vertices 2 and 6 at one place
        int refused = 0;
        for (const OperatorSpec& spec : all_specs(line)) {
            const bool refuses = expect_refused(line, spec, 1, "line");
            EXPECT_EQ(expect_refused(bow_tie, spec, 2, "bow tie"), refuses);
            EXPECT_EQ(expect_refused(twice, spec, 1, "two corners at one place"), refuses);
            refused += refuses ? 1 : 0;
        }
        EXPECT_GE(refused, 20);
    }
}

TEST(Refusals, AProjectionThatCrossesItself) {
    const auto crossing = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {4, 0, 0}, {1, 1, 0.1}, {3, 1.5, 0}},
                                    {{0, 1, 2, 3}, {0, 4, 5, 6}});
    for (std::size_t k = 0; k < 4; ++k) {
        for (const char* id : {"planar", "cotan", "weighted-cotan"}) {
            EXPECT_TRUE(expect_refused(crossing, {id, {static_cast<double>(k)}}, 1, "crossing")) << id;
        }
    }
    EXPECT_TRUE(build_operator(crossing, {"alexa-wardetzky", {}}).ok());
}

TEST(Monitors, RiseFromZeroToOneAndCancel) {
    const auto grid = get(make_grid(120, 120));
    for (const OperatorInfo* info : operators()) {
        Ticks all;
        ASSERT_TRUE(build_operator(grid, {info->id, {}}, all.monitor()).ok());
        ASSERT_GE(all.fractions.size(), 2u) << "14400 faces in one breath";
        EXPECT_TRUE(all.rise());
        for (const std::size_t stop : {std::size_t{1}, all.fractions.size()}) {
            Ticks some;
            some.stop_at = stop;
            const auto cancelled = build_operator(grid, {info->id, {}}, some.monitor());
            ASSERT_FALSE(cancelled.ok());
            EXPECT_EQ(cancelled.error().code, ErrorCode::cancelled);
            EXPECT_EQ(some.fractions.size(), stop) << "went on after it was told to stop";
        }
    }
    Ticks direct;
    direct.stop_at = 1;
    EXPECT_EQ(alexa_wardetzky_stiffness(grid, {}, direct.monitor()).error().code, ErrorCode::cancelled);
    EXPECT_EQ(planar_stiffness(grid, {}, direct.monitor()).error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace polylap::test

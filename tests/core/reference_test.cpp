// All figures of tests/data/operators.json: operators and settings on eight meshes, computed once by a program that
// shares no code with this one. What its figures mean beyond their names was found by trying and holds to
// 1e-12 on every mesh:
// - negative and nonzeros are over ordered pairs (nonzeros with the diagonal), beyond 1e-10 of the largest diagonal
// entry;
// - the implicit step has t = (mean edge length)², not the mean squared length;
// - the harmonic function has u = x² - y² + z on the boundary of open meshes; on closed ones u = 0 at vertex 0 and u =
// 1 at vertex V/2;
// - the spectrum is that of M^-½ S M^-½, and its kernel ends at 1e-9 of the largest eigenvalue.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <nlohmann/json.hpp>

#include "polylap/apply/diagnostics.hpp"
#include "polylap/apply/smoothing.hpp"
#include "polylap/solve/dirichlet.hpp"
#include "zoo.hpp"

namespace polylap::test {
namespace {

using nlohmann::json;

const json& reference() {
    static const json all = [] {
        const auto bytes = read_bytes("operators.json");
        const auto* text = reinterpret_cast<const char*>(bytes.data());
        return json::parse(text, text + bytes.size());
    }();
    return all;
}

struct Setting {
    const char* name;  // in the file
    OperatorSpec spec;
};
const std::vector<Setting>& settings() {
    using Settings = std::vector<std::pair<std::string, std::string>>;
    static const std::vector<Setting> all{
        {"umbrella", get(make_spec("umbrella", {}))},
        {"tutte", get(make_spec("tutte", {}))},
        {"alexa-wardetzky", get(make_spec("alexa-wardetzky", {}))},
        {"alexa-wardetzky-unstabilised", get(make_spec("alexa-wardetzky", Settings{{"lambda", "0"}}))},
        {"planar", get(make_spec("planar", {}))},
        {"planar-min-max-angle", get(make_spec("planar", Settings{{"rule", "min-max-angle"}}))},
        {"cotan-fan", get(make_spec("cotan", Settings{{"rule", "fan"}, {"mass", "lumped"}}))}};
    return all;
}
const Setting& setting_of(const std::string& name) {
    const auto at =
        std::find_if(settings().begin(), settings().end(), [&](const Setting& s) { return s.name == name; });
    if (at == settings().end()) throw std::runtime_error("no setting " + name);
    return *at;
}

/// Every mesh with every operator that the file has for it.
std::vector<std::pair<std::size_t, std::string>> cases() {
    std::vector<std::pair<std::size_t, std::string>> all;
    for (std::size_t k = 0; k < reference().size(); ++k) {
        for (const auto& item : reference()[k]["operators"].items()) {
            all.emplace_back(k, item.key());
        }
    }
    return all;
}

constexpr double relative = 1e-9;

class Reference : public testing::TestWithParam<std::pair<std::size_t, std::string>> {
protected:
    const json& entry = reference()[GetParam().first];
    const Setting& setting = setting_of(GetParam().second);
    const json& figures = entry["operators"][setting.name];
    PolygonMesh mesh = load_mesh(entry["mesh"]);
    Topology topology = build_topology(*mesh.connectivity());
    OperatorMatrices matrices = get(build_operator(mesh, setting.spec));
    const SparseMatrix& s = matrices.stiffness;
    double scale = s.diagonal().maxCoeff();

    /// Relative where the figure is no rounded zero, else absolute against the size of what is summed.
    static void expect_near(double value, double expected, double size, const char* what) {
        EXPECT_NEAR(value, expected, relative * std::max(std::abs(expected), 1e-3 * size)) << what;
    }
};

TEST_P(Reference, Mesh) {
    EXPECT_EQ(mesh.vertex_count(), entry["vertices"].get<Index>());
    EXPECT_EQ(mesh.face_count(), entry["faces"].get<Index>());
    EXPECT_EQ(static_cast<Index>(topology.edges.size()), entry["edges"].get<Index>());
    EXPECT_EQ(static_cast<Index>(topology.boundary_vertices.size()), entry["boundary_vertices"].get<Index>());
    const double area = entry["vector_area_sum"];
    EXPECT_NEAR(measure_shape(mesh, topology).area, area, relative * area);
    EXPECT_NEAR(matrices.mass.sum(), area, relative * area);
}

TEST_P(Reference, Stiffness) {
    expect_near(s.norm(), figures["frobenius"], 0, "frobenius");
    expect_near(s.diagonal().sum(), figures["trace"], 0, "trace");
    const double size = std::pow(bounding_size(mesh), 2) * scale;
    for (int k = 0; k < 3; ++k) {
        const Vector x = mesh.positions().col(k);
        expect_near(x.dot(s * x), figures["dirichlet"][static_cast<std::size_t>(k)], size, "dirichlet");
    }
    const Matrix dense(s);
    EXPECT_NEAR((dense - dense.transpose()).cwiseAbs().maxCoeff(), figures["asymmetry"], 1e-12 * scale);
    EXPECT_NEAR(dense.rowwise().sum().cwiseAbs().maxCoeff(), figures["rowsum"], 1e-12 * scale);
    const WeightSummary weights = summarise_weights(s);
    EXPECT_EQ(weights.negative_ordered, figures["negative"].get<Index>());
    EXPECT_EQ(weights.nonzero_ordered + mesh.vertex_count(), figures["nonzeros"].get<Index>());
}

// Of symmetric matrices alone, be it by luck, the file has what solvers make of them.
TEST_P(Reference, SolvesWhatIsSymmetric) {
    const bool symmetric = figures["asymmetry"].get<double>() < 1e-12;
    EXPECT_TRUE(symmetric || matrices.structure == Structure::general);
    for (const char* figure : {"lowest_eigenvalues_lumped_mass", "kernel_dimension", "implicit_step_t_h2_frobenius"}) {
        EXPECT_EQ(figures.contains(figure), symmetric) << figure;
    }
}

TEST_P(Reference, Spectrum) {
    if (!figures.contains("lowest_eigenvalues_lumped_mass")) return;
    const Vector root = matrices.mass.diagonal().cwiseSqrt().cwiseInverse();
    const Matrix normalised = root.asDiagonal() * Matrix(s) * root.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(normalised, Eigen::EigenvaluesOnly);
    const Vector& values = solver.eigenvalues();
    const double largest = values[values.size() - 1];
    const json& expected = figures["lowest_eigenvalues_lumped_mass"];
    ASSERT_EQ(expected.size(), 8u);
    for (std::size_t k = 0; k < expected.size(); ++k) {
        const double value = expected[k];
        // Rounding disturbs each eigenvalue by about the largest one's last digits.
        EXPECT_NEAR(values[static_cast<Eigen::Index>(k)], value, relative * std::abs(value) + 1e-14 * largest)
            << "eigenvalue " << k;
    }
    EXPECT_EQ((values.array() < 1e-9 * largest).count(), figures["kernel_dimension"].get<Eigen::Index>());
}

TEST_P(Reference, ImplicitStep) {
    if (!figures.contains("implicit_step_t_h2_frobenius")) return;
    double h = 0;
    for (const Edge& e : topology.edges) {
        h += (mesh.position(e.v1) - mesh.position(e.v0)).norm() / static_cast<double>(topology.edges.size());
    }
    const Points moved = get(get(ImplicitSmoother::create(matrices, h * h)).step(mesh.positions()));
    expect_near(moved.norm(), figures["implicit_step_t_h2_frobenius"], 0, "frobenius");
    for (std::size_t k = 0; k < 3; ++k) {
        expect_near(moved(0, static_cast<Eigen::Index>(k)), figures["implicit_step_vertex0"][k], bounding_size(mesh),
                    "vertex 0");
    }
}

TEST_P(Reference, Harmonic) {
    // The unstabilised operator has no unique harmonic function, and so no figure.
    if (!figures.contains("harmonic_min_max_sum")) {
        EXPECT_TRUE(figures["asymmetry"].get<double>() > 0 ||
                    std::string(setting.name) == "alexa-wardetzky-unstabilised");
        return;
    }
    std::vector<Index> fixed = topology.boundary_vertices;
    Vector values(static_cast<Eigen::Index>(fixed.size()));
    for (std::size_t k = 0; k < fixed.size(); ++k) {
        const Vector3 p = mesh.position(fixed[k]);
        values[static_cast<Eigen::Index>(k)] = p.x() * p.x() - p.y() * p.y() + p.z();
    }
    if (fixed.empty()) {
        fixed = {0, mesh.vertex_count() / 2};
        values = Eigen::Vector2d(0, 1);
    }
    const Matrix u = get(get(DirichletProblem::create(s, fixed, matrices.structure)).solve(values));
    const json& expected = figures["harmonic_min_max_sum"];
    expect_near(u.minCoeff(), expected[0], 1, "min");
    expect_near(u.maxCoeff(), expected[1], 1, "max");
    expect_near(u.sum(), expected[2], 1, "sum");
}

INSTANTIATE_TEST_SUITE_P(Figures, Reference, testing::ValuesIn(cases()), [](const auto& test) {
    std::string name = reference()[test.param.first]["mesh"].template get<std::string>() + "_" + test.param.second;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(ReferenceFile, HasTheEightMeshes) {
    EXPECT_EQ(reference().size(), 8u);
    EXPECT_EQ(cases().size(), 55u);
}

}  // namespace
}  // namespace polylap::test

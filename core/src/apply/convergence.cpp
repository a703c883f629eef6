#include "polylap/apply/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apply/refined_families.hpp"
#include "polylap/apply/diagnostics.hpp"
#include "polylap/operators/mass.hpp"
#include "polylap/solve/dirichlet.hpp"
#include "polylap/solve/linear_factor.hpp"

namespace polylap {
namespace {

/// eˣ sin y: harmonic, no polynomial, and all its derivatives are of the size of the function.
double harmonic_function(const Vector3& p) {
    return std::exp(p.x()) * std::sin(p.y());
}

Result<Vector> solve_dirichlet(const PolygonMesh& mesh, const Topology& topology, const OperatorMatrices& matrices) {
    const auto problem =
        DirichletProblem::create(matrices.stiffness, topology.boundary_vertices, matrices.structure, mesh.positions());
    if (!problem) return problem.error();
    Vector given(static_cast<Eigen::Index>(topology.boundary_vertices.size()));
    for (std::size_t k = 0; k < topology.boundary_vertices.size(); ++k) {
        given[static_cast<Eigen::Index>(k)] = harmonic_function(mesh.position(topology.boundary_vertices[k]));
    }
    const auto u = problem->solve(given);
    if (!u) return u.error();
    return Vector(u->col(0));
}

/// xz + xyz: spherical harmonics of degree 2 and 3, -Δ(xz) = 6 xz and -Δ(xyz) = 12 xyz on the unit sphere.
double spherical_function(const Vector3& p) {
    return p.x() * p.z() * (1 + p.y());
}
double spherical_load(const Vector3& p) {
    return p.x() * p.z() * (6 + 12 * p.y());
}

/// S u = M f with u = 0 at vertex 0, whose equation follows from the others where rows and columns sum to 0.
Result<Vector> solve_poisson(const PolygonMesh& mesh, const OperatorMatrices& matrices) {
    const Eigen::Index n = mesh.vertex_count();
    Vector load(n);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        load[v] = spherical_load(mesh.position(v).normalized());
    }
    const Vector weights = matrices.mass * Vector::Ones(n);
    load = matrices.mass * load;
    load -= load.sum() / weights.sum() * weights;
    LinearFactor factor;
    const SparseMatrix inner = matrices.stiffness.bottomRightCorner(n - 1, n - 1);
    if (Status status = factor.factor(inner, matrices.structure); !status) {
        Error error = status.error();
        if (error.element >= 0) ++error.element;
        return error;
    }
    const auto solved = factor.solve(load.tail(n - 1));
    if (!solved) return solved.error();
    Vector u(n);
    u << 0, *solved;
    return u;
}

/// Root of the mean of squares, each vertex with its share of the area.
double norm(const Vector& u, const Vector& area) {
    return std::sqrt(u.cwiseAbs2().dot(area) / area.sum());
}

Result<ConvergenceLevel> solve_level(const Family& family, const PolygonMesh& mesh, const OperatorSpec& spec,
                                     Monitor monitor) {
    const Topology topology = build_topology(*mesh.connectivity());
    Stretch building{monitor, 0, 0.5};
    const auto matrices = build_operator(mesh, spec, building.monitor());
    if (!matrices) return matrices.error();
    if (!monitor.proceed(0.5)) return Error{ErrorCode::cancelled, "cancelled"};
    const auto solution = family.sphere ? solve_poisson(mesh, *matrices) : solve_dirichlet(mesh, topology, *matrices);
    if (!solution) return solution.error();
    const auto mass = lumped_mass(mesh);
    if (!mass) return mass.error();

    const Vector area = mass->diagonal();
    Vector exact(mesh.vertex_count());
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        exact[v] =
            family.sphere ? spherical_function(mesh.position(v).normalized()) : harmonic_function(mesh.position(v));
    }
    Vector error = *solution - exact;
    if (family.sphere) {  // functions up to a constant
        error.array() -= error.dot(area) / area.sum();
        exact.array() -= exact.dot(area) / area.sum();
    }
    ConvergenceLevel level;
    level.vertices = mesh.vertex_count();
    level.h = std::sqrt(measure_shape(mesh, topology).mean_squared_edge);
    level.error = norm(error, area) / norm(exact, area);
    level.order = std::numeric_limits<double>::quiet_NaN();
    return level;
}

bool has_planar_faces(const PolygonMesh& mesh) {
    // A face whose corners stray by less is flat: rounding of positions on the unit sphere or square.
    constexpr double flat = 1e-10;
    return measure_shape(mesh, build_topology(*mesh.connectivity())).mean_non_planarity < flat;
}

bool has_only_triangles(const PolygonMesh& mesh) {
    return static_cast<Index>(mesh.connectivity()->corners.size()) == 3 * mesh.face_count();
}

Result<ConvergenceStudy> study_family(const Family& family, const OperatorSpec& spec, Monitor monitor) {
    ConvergenceStudy study;
    study.family = family.name;
    study.problem =
        family.sphere ? "-Δu = 6xz + 12xyz on the unit sphere, u = xz + xyz" : "Δu = 0, u = eˣ sin y on the boundary";
    study.only_triangles = study.planar_faces = true;
    for (int k = 0; k < refinements; ++k) {
        const auto part = [](int level) { return (std::pow(4.0, level) - 1) / (std::pow(4.0, refinements) - 1); };
        Stretch stretch{monitor, part(k), part(k + 1)};
        if (!monitor.proceed(stretch.from)) return Error{ErrorCode::cancelled, "cancelled"};
        const auto mesh = family.make(k);
        if (!mesh) return mesh.error();
        study.only_triangles = study.only_triangles && has_only_triangles(*mesh);
        study.planar_faces = study.planar_faces && has_planar_faces(*mesh);
        if (!study.failure.empty()) continue;
        auto level = solve_level(family, *mesh, spec, stretch.monitor());
        if (!level) {
            const Error& error = level.error();
            if (error.code == ErrorCode::cancelled || error.code == ErrorCode::out_of_memory) return error;
            study.failure = "with " + std::to_string(mesh->vertex_count()) + " vertices: " + error.message;
            continue;
        }
        if (!study.levels.empty()) {
            const ConvergenceLevel& before = study.levels.back();
            level->order = std::log(before.error / level->error) / std::log(before.h / level->h);
        }
        study.levels.push_back(*level);
    }
    study.order = study.levels.empty() ? std::numeric_limits<double>::quiet_NaN() : study.levels.back().order;
    study.converges = study.failure.empty() && std::all_of(study.levels.begin() + 1, study.levels.end(),
                                                           [](const auto& level) { return level.order > least_order; });
    return study;
}

}  // namespace

Result<std::vector<ConvergenceStudy>> study_convergence(const OperatorSpec& spec, Monitor monitor) {
    return guard_memory([&]() -> Result<std::vector<ConvergenceStudy>> {
        auto complete = complete_spec(spec);
        if (!complete) return complete.error();
        complete->vertex_weights.clear();
        std::vector<ConvergenceStudy> studies;
        const auto families = refined_families();
        for (std::size_t k = 0; k < families.size(); ++k) {
            const auto count = static_cast<double>(families.size());
            Stretch stretch{monitor, static_cast<double>(k) / count, static_cast<double>(k + 1) / count};
            auto study = study_family(families[k], *complete, stretch.monitor());
            if (!study) return study.error();
            studies.push_back(*std::move(study));
        }
        if (!monitor.proceed(1)) return Error{ErrorCode::cancelled, "cancelled"};
        return studies;
    });
}

}  // namespace polylap

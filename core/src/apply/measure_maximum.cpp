// Does a harmonic function leave the range of its boundary values?

#include <algorithm>
#include <cmath>
#include <numeric>

#include "apply/measure.hpp"
#include "polylap/solve/dirichlet.hpp"

namespace polylap {
namespace {

/// Vertices to fix on a component without a boundary.
constexpr Index fixed_on_closed = 16;
/// Vertices × fixed vertices up to which all functions are computed: some seconds at most.
constexpr std::int64_t all_functions = 2'000'000;
/// Functions computed beyond.
constexpr Index sampled_functions = 64;
/// Functions solved at once: between them, the work can be stopped.
constexpr Index block = 16;

/// Up to `count` vertices of a component, each as far as can be from those before, starting at the lowest.
std::vector<Index> spread_vertices(const PolygonMesh& mesh, std::span<const Index> component, Index count) {
    std::vector<Index> chosen{component[0]};
    std::vector<double> distance(component.size(), std::numeric_limits<double>::infinity());
    while (static_cast<Index>(chosen.size()) < count) {
        std::size_t farthest = 0;
        for (std::size_t k = 0; k < component.size(); ++k) {
            distance[k] =
                std::min(distance[k], (mesh.position(component[k]) - mesh.position(chosen.back())).squaredNorm());
            if (distance[k] > distance[farthest]) farthest = k;
        }
        if (!(distance[farthest] > 0)) break;
        chosen.push_back(component[farthest]);
    }
    return chosen;
}

/// Per component: whether it has a boundary.
std::vector<char> open_components(const Topology& topology) {
    std::vector<char> open(static_cast<std::size_t>(topology.component_count), 0);
    for (const Index v : topology.boundary_vertices) {
        open[static_cast<std::size_t>(topology.component[static_cast<std::size_t>(v)])] = 1;
    }
    return open;
}

struct FixedVertices {
    std::vector<Index> vertices;  ///< Ascending.
    bool boundary = false;        ///< Some lie on a boundary …
    bool spread = false;          ///< … some on a closed component.

    std::string text() const {
        const std::string count = std::to_string(vertices.size());
        if (!spread) return count + " boundary vertices";
        if (!boundary) return count + " vertices spread over the closed surface";
        return count + " vertices (boundaries, and some spread over closed parts)";
    }
};

FixedVertices choose_fixed(const PolygonMesh& mesh, const Topology& topology) {
    std::vector<std::vector<Index>> members(static_cast<std::size_t>(topology.component_count));
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        const Index c = topology.component[static_cast<std::size_t>(v)];
        if (c >= 0) members[static_cast<std::size_t>(c)].push_back(v);
    }
    FixedVertices fixed;
    fixed.vertices = topology.boundary_vertices;
    fixed.boundary = !fixed.vertices.empty();
    const std::vector<char> open = open_components(topology);
    for (std::size_t c = 0; c < members.size(); ++c) {
        if (open[c] != 0) continue;
        const Index count = std::clamp(static_cast<Index>(members[c].size()) / 4, 2, fixed_on_closed);
        const auto chosen = spread_vertices(mesh, members[c], count);
        fixed.vertices.insert(fixed.vertices.end(), chosen.begin(), chosen.end());
        fixed.spread = true;
    }
    std::sort(fixed.vertices.begin(), fixed.vertices.end());
    return fixed;
}

/// The fixed vertices whose functions to compute, as positions in `fixed`: half those with the most negative weight,
/// half spread evenly.
std::vector<Index> choose_functions(const SparseMatrix& s, std::span<const Index> fixed) {
    const auto count = static_cast<Index>(fixed.size());
    std::vector<double> negative(fixed.size(), 0);
    for (std::size_t k = 0; k < fixed.size(); ++k) {
        for (SparseMatrix::InnerIterator it(s, fixed[k]); it; ++it) {
            if (it.row() != fixed[k]) negative[k] += std::max(0.0, it.value());
        }
    }
    std::vector<Index> order(fixed.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
        return negative[static_cast<std::size_t>(a)] > negative[static_cast<std::size_t>(b)];
    });
    order.resize(static_cast<std::size_t>(std::min(count, sampled_functions / 2)));
    for (Index k = 0; k < sampled_functions / 2; ++k) {
        order.push_back(static_cast<Index>(static_cast<std::int64_t>(k) * count / (sampled_functions / 2)));
    }
    std::sort(order.begin(), order.end());
    order.erase(std::unique(order.begin(), order.end()), order.end());
    return order;
}

/// The farthest that values in [0, 1] at the fixed vertices have led beyond.
struct Worst {
    double beyond = -1;
    double value = 0;
    Index vertex = -1;
    Index source = -1;  ///< Vertex with the value 1; -1: another function.
    std::string data;   ///< Its boundary values.

    void look(const Matrix& u, Eigen::Index column, Index source_vertex, const char* text) {
        for (Eigen::Index v = 0; v < u.rows(); ++v) {
            const double x = u(v, column);
            const double over = std::max(-x, x - 1);
            if (!(over > beyond)) continue;
            *this = {over, x, static_cast<Index>(v), source_vertex, text};
        }
    }
};

/// Functions pinned at all neighbours of one vertex, those that its row joins it to: 1 at one and 0 at the others.
struct AroundOneVertex {
    Index functions = 0;
    double lowest = 0;  ///< What they come to at the vertex: -S_ij / S_ii.
    Index vertex = -1;
    Index source = -1;  ///< The neighbour with the value 1.
};

/// Around the vertices of closed components, where any vertices may be the boundary.
AroundOneVertex look_around(const Subject& subject) {
    const SparseMatrix& s = subject.stiffness();
    const Topology& topology = subject.topology;
    const Vector diagonal = s.diagonal();
    const std::vector<char> open = open_components(topology);
    AroundOneVertex around;
    for (Index j = 0; j < s.cols(); ++j) {
        for (SparseMatrix::InnerIterator it(s, j); it; ++it) {
            const Index i = it.index();
            const Index c = topology.component[static_cast<std::size_t>(i)];
            if (i == j || c < 0 || open[static_cast<std::size_t>(c)] != 0) continue;
            // Without a diagonal entry, the row leaves the value open.
            if (std::abs(it.value()) <= subject.zero() || std::abs(diagonal[i]) <= subject.zero()) continue;
            ++around.functions;
            const double value = -it.value() / diagonal[i];
            if (value >= around.lowest) continue;
            around.lowest = value;
            around.vertex = i;
            around.source = j;
        }
    }
    return around;
}

Result<Measurement> measure_fixed(const Subject& subject, Monitor monitor) {
    const PolygonMesh& mesh = subject.mesh;
    const FixedVertices fixed = choose_fixed(mesh, subject.topology);
    const auto fixed_count = static_cast<Index>(fixed.vertices.size());
    const auto unreferenced = static_cast<Index>(subject.topology.unreferenced.size());
    if (fixed_count + unreferenced == mesh.vertex_count()) return not_measured("every vertex lies on the boundary");
    if (!monitor.proceed(0)) return Error{ErrorCode::cancelled, "cancelled"};
    const auto problem =
        DirichletProblem::create(subject.stiffness(), fixed.vertices, subject.matrices.structure, mesh.positions());
    if (!problem) {
        if (ends_check(problem.error())) return problem.error();
        return not_measured("with " + fixed.text() + " fixed: " + problem.error().message);
    }

    const bool all = static_cast<std::int64_t>(fixed_count) * mesh.vertex_count() <= all_functions;
    std::vector<Index> functions;
    if (all) {
        functions.resize(fixed.vertices.size());
        std::iota(functions.begin(), functions.end(), 0);
    } else {
        functions = choose_functions(subject.stiffness(), fixed.vertices);
    }
    // Constants, and the coordinates scaled to [0, 1], where not all functions speak for them.
    Matrix others = Matrix::Ones(fixed_count, all ? 1 : 4);
    for (int k = 1; k < others.cols(); ++k) {
        for (Index row = 0; row < fixed_count; ++row) {
            others(row, k) = mesh.position(fixed.vertices[static_cast<std::size_t>(row)])[k - 1];
        }
        const double low = others.col(k).minCoeff();
        const double width = others.col(k).maxCoeff() - low;
        others.col(k) = (others.col(k).array() - low) / (width > 0 ? width : 1);
    }
    const auto refused = [](const Error& error) -> Result<Measurement> {
        if (ends_check(error)) return error;
        return not_measured(error.message);
    };
    Worst worst;
    const auto whole = problem->solve(others);
    if (!whole) return refused(whole.error());
    constexpr const char* data[] = {"1 at every fixed vertex", "x at the fixed vertices, scaled to [0, 1]",
                                    "y at the fixed vertices, scaled to [0, 1]",
                                    "z at the fixed vertices, scaled to [0, 1]"};
    for (int k = 0; k < others.cols(); ++k) {
        worst.look(*whole, k, -1, data[k]);
        // That a constant falls short is as bad as that it overshoots.
        for (Eigen::Index v = 0; k == 0 && v < whole->rows(); ++v) {
            const double x = (*whole)(v, 0);
            if (1 - x > worst.beyond) worst = {1 - x, x, static_cast<Index>(v), -1, data[0]};
        }
    }
    for (std::size_t from = 0; from < functions.size(); from += block) {
        if (!monitor.proceed(0.2 + 0.8 * static_cast<double>(from) / static_cast<double>(functions.size()))) {
            return Error{ErrorCode::cancelled, "cancelled"};
        }
        const auto part = std::span(functions).subspan(from, std::min<std::size_t>(block, functions.size() - from));
        Matrix values = Matrix::Zero(fixed_count, static_cast<Eigen::Index>(part.size()));
        for (std::size_t k = 0; k < part.size(); ++k) {
            values(part[k], static_cast<Eigen::Index>(k)) = 1;
        }
        const auto u = problem->solve(values);
        if (!u) return refused(u.error());
        for (std::size_t k = 0; k < part.size(); ++k) {
            worst.look(*u, static_cast<Eigen::Index>(k), fixed.vertices[static_cast<std::size_t>(part[k])],
                       "1 at one and 0 at the others");
        }
    }

    std::string text = all ? "all " + std::to_string(functions.size()) + " harmonic functions that are 1 at one of " +
                                 fixed.text() + " and 0 at the others"
                           : std::to_string(functions.size()) + " harmonic functions that are 1 at one of " +
                                 fixed.text() + " and 0 at the others, and the coordinates (a sample)";
    const double value = std::max(0.0, worst.beyond);
    if (worst.beyond <= range_tolerance) {
        return measured(true, value, text + " stay in [0, 1]", {});
    }
    text = worst.source >= 0 ? "1 at " + vertex_name(worst.source) + " and 0 at the others of " + fixed.text()
                             : worst.data + " (" + fixed.text() + ")";
    text += " makes " + figure(worst.value) + " at " + vertex_name(worst.vertex) + ", the worst of " +
            std::to_string(functions.size() + static_cast<std::size_t>(others.cols())) + " functions" +
            (all ? "" : " (a sample)");
    std::vector<Index> place{worst.vertex};
    if (worst.source >= 0) place.push_back(worst.source);
    return measured(false, value, std::move(text), std::move(place));
}

}  // namespace

Result<Measurement> measure_maximum_principle(const Subject& subject, Monitor monitor) {
    auto found = measure_fixed(subject, monitor);
    const AroundOneVertex around = look_around(subject);
    if (!found || around.functions == 0) return found;
    const bool fails = found->verdict == Measurement::Verdict::fails;
    const double below = -around.lowest;
    if (below > range_tolerance && !(fails && found->value >= below)) {
        return measured(false, below,
                        "pinned to 1 at " + vertex_name(around.source) + " and to 0 at the other neighbours of " +
                            vertex_name(around.vertex) + ", a harmonic function is " + figure(around.lowest) +
                            " there, the lowest of " + std::to_string(around.functions) + " pinned like this",
                        {around.vertex, around.source});
    }
    if (found->verdict == Measurement::Verdict::holds) {
        found->value = std::max(found->value, below);
        found->text += ", and none of " + std::to_string(around.functions) +
                       " that are 1 at one neighbour of a vertex and 0 at its others falls below 0";
    }
    return found;
}

}  // namespace polylap

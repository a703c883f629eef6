#include "zoo.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <numeric>
#include <random>

#include "polylap/apply/diagnostics.hpp"
#include "polylap/apply/noise.hpp"
#include "polylap/face/vector_area.hpp"
#include "polylap/mesh/mesh_io.hpp"
#include "polylap/mesh/shapes.hpp"

namespace polylap::test {
namespace {

using Faces = std::vector<std::vector<Index>>;

/// A cube of side 1 whose sides are n × n quads: closed, with flat inner vertices in six directions.
PolygonMesh make_cube(Index n) {
    std::vector<Vector3> points;
    Faces faces;
    const auto vertex = [&](const Vector3& p) {
        const auto at =
            std::find_if(points.begin(), points.end(), [&](const Vector3& q) { return (p - q).norm() < 1e-9; });
        if (at != points.end()) return static_cast<Index>(at - points.begin());
        points.push_back(p);
        return static_cast<Index>(points.size() - 1);
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {0.0, 1.0}) {
            const auto at = [&](Index i, Index j) {
                Vector3 p;
                p[axis] = side;
                p[(axis + 1) % 3] = static_cast<double>(i) / n;
                p[(axis + 2) % 3] = static_cast<double>(j) / n;
                return vertex(p);
            };
            for (Index i = 0; i < n; ++i) {
                for (Index j = 0; j < n; ++j) {
                    std::vector<Index> face{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
                    if (side == 0) std::reverse(face.begin(), face.end());
                    faces.push_back(face);
                }
            }
        }
    }
    return make_mesh(points, faces);
}

PolygonMesh make_moebius(int n) {
    std::vector<Vector3> points;
    Faces faces;
    for (int i = 0; i < n; ++i) {
        const double t = 2 * std::numbers::pi * i / n;
        for (const double w : {-0.3, 0.3}) {
            const double r = 1 + w * std::cos(t / 2);
            points.emplace_back(r * std::cos(t), r * std::sin(t), w * std::sin(t / 2));
        }
        const Index a = 2 * i;
        if (i + 1 < n) {
            faces.push_back({a, a + 2, a + 3, a + 1});
        } else {
            faces.push_back({a, 1, 0, a + 1});
        }
    }
    return make_mesh(points, faces);
}

/// Planar, with concave and convex hexagons and pentagons around flat inner vertices.
PolygonMesh make_zigzag() {
    const auto grid = get(make_grid(6, 6, 6, 6));
    Points p = grid.positions();
    for (Index v = 0; v < p.rows(); ++v) {
        p(v, 1) += 0.31 * std::sin(2.3 * p(v, 0)) + 0.05 * p(v, 0) * p(v, 1);
    }
    std::vector<Vector3> points;
    for (Index v = 0; v < p.rows(); ++v) {
        points.emplace_back(p.row(v).transpose());
    }
    Faces faces;
    for (Index j = 0; j < 6; ++j) {
        for (Index i = 0; i < 6; i += 2) {
            const Index v = 7 * j + i;
            faces.push_back({v, v + 1, v + 2, v + 9, v + 8, v + 7});
        }
    }
    return make_mesh(points, faces);
}

std::vector<Vector3> wavy(std::vector<Vector3> polygon) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        polygon[k].z() += 0.2 * std::sin(2.1 * static_cast<double>(k) + 0.4);
    }
    return polygon;
}

PolygonMesh two_components() {
    const PolygonMesh a = get(make_grid(2, 3));
    std::vector<Vector3> points;
    Faces faces;
    for (Index v = 0; v < a.vertex_count(); ++v) {
        points.push_back(a.position(v));
    }
    for (Index f = 0; f < a.face_count(); ++f) {
        faces.emplace_back(a.face(f).begin(), a.face(f).end());
    }
    const auto n = static_cast<Index>(points.size());
    for (const Vector3& p : wavy(regular_polygon(5))) {
        points.push_back(p + Vector3(5, 0, 1));
    }
    faces.push_back({n, n + 1, n + 2, n + 3, n + 4});
    return make_mesh(points, faces);
}

std::vector<Specimen> build_zoo() {
    std::vector<Specimen> zoo;
    const auto add = [&](std::string name, PolygonMesh mesh) { zoo.push_back({std::move(name), std::move(mesh)}); };
    for (const char* name : {"grid-2x2", "grid-8x8-skew", "saddle-12x12", "triangle-sphere-2", "hexagon-sphere-2",
                             "concave-hexagons-6", "quad-torus-32x16", "quad-torus-32x16-noisy"}) {
        add(name, load_mesh(name));
    }
    add("grid-5x3", get(make_grid(5, 3, 2, 1)));
    add("saddle-7", get(make_saddle(7, 1.3)));
    add("torus-9x5", get(make_torus(9, 5)));
    add("torus-10x7-noisy", get(add_normal_noise(get(make_torus(10, 7)), 0.3, 5)));
    add("cube-3", make_cube(3));
    add("zigzag", make_zigzag());
    for (int n = 3; n <= 12; ++n) {
        add("regular-" + std::to_string(n), make_face(regular_polygon(n)));
        if (n > 3) add("wavy-" + std::to_string(n), make_face(wavy(regular_polygon(n))));
    }
    add("obtuse-triangle", make_face({{0, 0, 0}, {3, 0, 0}, {1, 0.4, 0}}));
    add("obtuse-fan", make_mesh({{0, 0, 0}, {4, 0.1, 0}, {0.3, 0.5, 0}, {-4, 0.2, 0}, {-0.2, -0.6, 0}},
                                {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}));
    add("l-shape", make_face({{0, 0, 0}, {2.1, 0, 0}, {2, 0.9, 0}, {1, 1.1, 0}, {0.9, 1.8, 0}, {0, 2, 0}}));
    std::vector<Vector3> star;
    for (int k = 0; k < 10; ++k) {
        const double t = 2 * std::numbers::pi * k / 10;
        const double r = (k % 2 == 0 ? 1.0 : 0.35) * (1 + 0.03 * k);
        star.emplace_back(r * std::cos(t), r * std::sin(t), 0);
    }
    add("star", make_face(star));
    add("wavy-star", make_face(wavy(star)));
    add("straight-corners", make_face({{0, 0, 0}, {1, 0, 0}, {2.5, 0, 0}, {2.5, 1, 0}, {1.5, 1.25, 0}, {0.5, 1.5, 0}}));
    add("two-components", two_components());
    add("moebius", make_moebius(11));
    add("three-quads-on-an-edge", make_mesh({{0, 0, 0},
                                             {0, 0, 1},
                                             {1, 0, 0},
                                             {1, 0, 1.2},
                                             {-0.5, 0.9, 0},
                                             {-0.4, 0.9, 1},
                                             {-0.5, -0.9, 0.1},
                                             {-0.5, -0.8, 1}},
                                            {{0, 2, 3, 1}, {0, 4, 5, 1}, {0, 6, 7, 1}}));
    add("unreferenced-vertices",
        make_mesh({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {1.2, 1, 0.1}, {-3, 0, 0}, {0, 0.8, 0}}, {{1, 2, 3, 5}}));
    return zoo;
}

}  // namespace

PolygonMesh make_mesh(const std::vector<Vector3>& points, const std::vector<std::vector<Index>>& faces) {
    Points positions(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v) {
        positions.row(static_cast<Eigen::Index>(v)) = points[v].transpose();
    }
    std::vector<Index> offsets{0};
    std::vector<Index> corners;
    for (const auto& face : faces) {
        corners.insert(corners.end(), face.begin(), face.end());
        offsets.push_back(static_cast<Index>(corners.size()));
    }
    return get(PolygonMesh::create(positions, offsets, corners));
}

PolygonMesh make_face(const std::vector<Vector3>& corners) {
    std::vector<Index> face;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        face.push_back(static_cast<Index>(k));
    }
    return make_mesh(corners, {face});
}

std::vector<Vector3> regular_polygon(int n) {
    std::vector<Vector3> corners;
    for (int k = 0; k < n; ++k) {
        const double t = 2 * std::numbers::pi * k / n;
        corners.emplace_back(std::cos(t), std::sin(t), 0);
    }
    return corners;
}

std::vector<std::byte> read_bytes(const std::string& path_in_data) {
    std::ifstream file(std::string(POLYLAP_TEST_DATA) + "/" + path_in_data, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read tests/data/" + path_in_data);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return {first, first + text.size()};
}

PolygonMesh load_mesh(const std::string& name) {
    return get(read_obj(read_bytes("meshes/" + name + ".obj")));
}

const std::vector<Specimen>& zoo() {
    static const std::vector<Specimen> all = build_zoo();
    return all;
}

std::vector<Specimen> oriented_zoo() {
    std::vector<Specimen> some;
    for (const Specimen& s : zoo()) {
        const auto edges = build_topology(*s.mesh.connectivity()).edges;
        if (std::all_of(edges.begin(), edges.end(), [](const Edge& e) { return e.oriented() && e.manifold(); })) {
            some.push_back(s);
        }
    }
    return some;
}

const PolygonMesh& specimen(const std::string& name) {
    for (const Specimen& s : zoo()) {
        if (s.name == name) return s.mesh;
    }
    throw std::runtime_error("no specimen " + name);
}

bool only_triangles(const PolygonMesh& mesh) {
    for (Index f = 0; f < mesh.face_count(); ++f) {
        if (mesh.face(f).size() != 3) return false;
    }
    return true;
}

double non_planarity(const PolygonMesh& mesh) {
    double worst = 0;
    std::vector<Vector3> corners;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        gather_corners(mesh, f, corners);
        const Vector3 a = vector_area(corners);
        for (const Vector3& p : corners) {
            worst = std::max(worst, std::abs(a.normalized().dot(p - corners[0])) / std::sqrt(a.norm()));
        }
    }
    return worst;
}

std::vector<Index> flat_inner_vertices(const PolygonMesh& mesh) {
    const Topology topology = build_topology(*mesh.connectivity());
    std::vector<char> flat(static_cast<std::size_t>(mesh.vertex_count()), 1);
    const auto exclude = [&](Index v) { flat[static_cast<std::size_t>(v)] = 0; };
    for (const Index v : topology.unreferenced) {
        exclude(v);
    }
    for (const Edge& e : topology.edges) {
        if (e.forward == 1 && e.backward == 1) continue;
        exclude(e.v0);
        exclude(e.v1);
    }
    std::vector<Vector3> normal(flat.size(), Vector3::Zero());
    std::vector<Vector3> corners;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        gather_corners(mesh, f, corners);
        const Vector3 u = vector_area(corners).normalized();
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Index v = mesh.face(f)[k];
            Vector3& n = normal[static_cast<std::size_t>(v)];
            if (n.isZero()) n = u;
            for (const Vector3& p : corners) {
                if (std::abs(n.dot(p - corners[k])) > 1e-12 * bounding_size(mesh) || n.dot(u) < 0) exclude(v);
            }
        }
    }
    std::vector<Index> inner;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        if (flat[static_cast<std::size_t>(v)] != 0) inner.push_back(v);
    }
    return inner;
}

double total_area(const PolygonMesh& mesh) {
    return measure_shape(mesh, build_topology(*mesh.connectivity())).area;
}

double bounding_size(const PolygonMesh& mesh) {
    return (mesh.positions().colwise().maxCoeff() - mesh.positions().colwise().minCoeff()).norm();
}

bool claimed(Claim claim, const PolygonMesh& mesh) {
    switch (claim) {
        case Claim::yes:
            return true;
        case Claim::planar:
            return planar_faces(mesh);
        case Claim::triangles:
            return only_triangles(mesh);
        case Claim::some:
        case Claim::no:
            return false;
    }
    return false;
}

std::vector<OperatorSpec> all_specs() {
    std::vector<OperatorSpec> specs;
    for (const OperatorInfo* info : operators()) {
        const OperatorSpec initial = get(complete_spec({info->id, {}}));
        specs.push_back(initial);
        for (std::size_t k = 0; k < info->parameters.size(); ++k) {
            const Parameter& p = info->parameters[k];
            std::vector<double> values{p.min, 0.5 * p.initial, p.slider_max};
            if (p.kind == Parameter::Kind::choice) {
                values.resize(p.choices.size());
                std::iota(values.begin(), values.end(), 0.0);
            }
            for (const double v : values) {
                if (v == p.initial) continue;
                specs.push_back(initial);
                specs.back().values[k] = v;
            }
        }
    }
    return specs;
}

std::vector<double> random_weights(const PolygonMesh& mesh, std::uint32_t seed) {
    double squared = 0;
    const auto edges = build_topology(*mesh.connectivity()).edges;
    for (const Edge& e : edges) {
        squared += (mesh.position(e.v1) - mesh.position(e.v0)).squaredNorm() / static_cast<double>(edges.size());
    }
    std::mt19937 random(seed);
    std::vector<double> weights(static_cast<std::size_t>(mesh.vertex_count()));
    for (double& w : weights) {
        w = squared * (2 * (static_cast<double>(random()) / 4294967296.0) - 1);
    }
    return weights;
}

std::vector<OperatorSpec> all_specs(const PolygonMesh& mesh) {
    std::vector<OperatorSpec> specs;
    for (const OperatorSpec& spec : all_specs()) {
        specs.push_back(spec);
        if (!get(find_operator(spec.id))->takes_vertex_weights) continue;
        specs.push_back(spec);
        specs.back().vertex_weights = random_weights(mesh, 7);
    }
    return specs;
}

std::string spec_name(const OperatorSpec& spec) {
    std::string name = spec.id;
    for (const double v : spec.values) {
        name += " " + std::to_string(v);
    }
    return name + (spec.vertex_weights.empty() ? "" : ", weighted");
}

}  // namespace polylap::test

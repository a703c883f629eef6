// How the matrices of faces become one: the pattern, the kernels for small faces, and what large faces take.

#include <cmath>
#include <random>
#include <thread>

#include "naive.hpp"
#include "operator_cases.hpp"
#include "polylap/face/triangulate_mesh.hpp"
#include "polylap/mesh/shapes.hpp"
#include "polylap/operators/alexa_wardetzky.hpp"
#include "polylap/operators/alexa_wardetzky_weighted.hpp"
#include "polylap/operators/cotan.hpp"
#include "polylap/operators/planar.hpp"
#include "polylap/operators/umbrella.hpp"

namespace polylap::test {
namespace {

bool same_pattern(const SparseMatrix& a, const SparseMatrix& b) {
    return a.isCompressed() && b.isCompressed() && a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
           std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}
bool same_bits(const SparseMatrix& a, const SparseMatrix& b) {
    return same_pattern(a, b) && std::equal(a.valuePtr(), a.valuePtr() + a.nonZeros(), b.valuePtr());
}

/// The same faces, each vertex moved by up to a tenth of the mean edge.
PolygonMesh jittered(const PolygonMesh& mesh, std::uint32_t seed) {
    double length = 0;
    const auto edges = build_topology(*mesh.connectivity()).edges;
    for (const Edge& e : edges) {
        length += (mesh.position(e.v1) - mesh.position(e.v0)).norm() / static_cast<double>(edges.size());
    }
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-0.1 * length, 0.1 * length);
    Points moved = mesh.positions();
    for (auto row : moved.rowwise()) {
        for (int k = 0; k < 3; ++k) {
            row[k] += uniform(random);
        }
    }
    return get(mesh.with_positions(moved));
}

/// Σ of the matrices that `local` makes of the corners of each face.
template <class Local>
Matrix dense_sum(const PolygonMesh& mesh, Local&& local) {
    Matrix sum = Matrix::Zero(mesh.vertex_count(), mesh.vertex_count());
    std::vector<Vector3> x;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        gather_corners(mesh, f, x);
        const Matrix part = local(x);
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            for (std::size_t j = 0; j < face.size(); ++j) {
                sum(face[i], face[j]) += part(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            }
        }
    }
    return sum;
}

Matrix plain_planar(const std::vector<Vector3>& x, TriangulationRule rule) {
    Projection projection;
    EXPECT_TRUE(project_maximally(x, projection));
    std::vector<Triangle> triangles;
    check(triangulate_polygon(projection.points, rule, triangles));
    return naive::cotan(projection.points, triangles);
}

double distance(const SparseMatrix& a, const Matrix& b) {
    return (Matrix(a) - b).cwiseAbs().maxCoeff();
}

/// n corners on a circle, every second one pulled in, and bent out of the plane.
std::vector<Vector3> star(Index n, double depth, double bend) {
    std::vector<Vector3> x;
    for (Index k = 0; k < n; ++k) {
        const double r = k % 2 == 0 ? 1 : 1 - depth;
        const double angle = 2 * M_PI * k / n;
        x.emplace_back(r * std::cos(angle), r * std::sin(angle), bend * std::sin(2 * angle));
    }
    return x;
}

/// A face of n corners with a quad along each of its sides.
PolygonMesh framed(Index n, double depth, double bend) {
    std::vector<Vector3> points = star(n, depth, bend);
    std::vector<std::vector<Index>> faces(1);
    for (Index k = 0; k < n; ++k) {
        points.push_back(2 * points[static_cast<std::size_t>(k)]);
        faces[0].push_back(k);
        const Index next = (k + 1) % n;
        faces.push_back({k, n + k, n + next, next});
    }
    return make_mesh(points, faces);
}

/// Triangles and quads in turn around vertex 0.
PolygonMesh wheel(Index spokes) {
    std::vector<Vector3> points{Vector3::Zero()};
    std::vector<std::vector<Index>> faces;
    for (Index k = 0; k < spokes; ++k) {
        for (const double shift : {0.0, 0.5}) {
            const double angle = 2 * M_PI * (k + shift) / spokes;
            points.emplace_back(std::cos(angle), std::sin(angle), 0.1 * std::cos(3 * angle));
        }
        const Index a = 2 * k + 1;
        const Index next = (a + 1) % (2 * spokes) + 1;
        if (k % 2 == 0)
            faces.push_back({0, a, a + 1, next});
        else
            faces.insert(faces.end(), {{0, a, a + 1}, {0, a + 1, next}});
    }
    return make_mesh(points, faces);
}

TEST(Pattern, DependsOnTheConnectivityAlone) {
    int flipped = 0;
    for (const auto& [name, mesh] : zoo()) {
        const PolygonMesh moved = jittered(mesh, 7);
        for (const OperatorSpec& spec : all_specs(mesh)) {
            const auto before = try_build(mesh, spec);
            const auto after = try_build(moved, spec);
            if (!before || !after) continue;
            EXPECT_TRUE(same_pattern(before->stiffness, after->stiffness)) << spec_name(spec) << " on " << name;
            EXPECT_TRUE(same_pattern(before->mass, after->mass)) << spec_name(spec) << " on " << name;
            SparseMatrix couplings[]{before->stiffness, after->stiffness};
            for (SparseMatrix& s : couplings) {
                s.prune([](Eigen::Index, Eigen::Index, double value) { return value != 0; });
            }
            if (!same_pattern(couplings[0], couplings[1])) ++flipped;
        }
    }
    EXPECT_GE(flipped, 50);
}

TEST(Pattern, IsAllPairsOfCornersWithoutTheVerticesInNoFace) {
    const auto mesh = get(PolygonMesh::create(Points::Random(8, 3), {0, 4, 8}, {0, 1, 2, 3, 3, 2, 5, 7}));
    for (const char* id : {"alexa-wardetzky", "planar", "cotan"}) {
        const auto flat = get(mesh.with_positions([] {
            Points p(8, 3);
            p << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 9, 9, 9, 1, 2, 0, 9, 9, 9, 0, 2, 0;
            return p;
        }()));
        const auto m = get(build_operator(flat, {id, {}}));
        EXPECT_EQ(m.stiffness.nonZeros(), 4 + 4 + 6 + 6 + 4 + 4) << id;
        EXPECT_EQ(m.stiffness.col(4).nonZeros() + m.stiffness.col(6).nonZeros(), 0) << id;
        EXPECT_EQ(m.mass.nonZeros(), 8) << id;
    }
}

TEST(Assembly, EqualsThePlainSumOverFaces) {
    int compared = 0;
    for (const auto& [name, mesh] : zoo()) {
        SCOPED_TRACE(name);
        for (const double lambda : {0.0, 0.3, 2.0}) {
            const auto s = alexa_wardetzky_stiffness(mesh, {lambda});
            if (!s) continue;
            ++compared;
            const auto local = [&](const std::vector<Vector3>& x) { return naive::alexa_wardetzky(x, lambda); };
            EXPECT_LE(distance(*s, dense_sum(mesh, local)), 1e-11 * largest(*s)) << lambda;
        }
        for (const auto rule : {TriangulationRule::delaunay, TriangulationRule::shortest_diagonal}) {
            const auto s = planar_stiffness(mesh, {rule});
            if (!s) continue;
            ++compared;
            const auto local = [&](const std::vector<Vector3>& x) { return plain_planar(x, rule); };
            EXPECT_LE(distance(*s, dense_sum(mesh, local)), 1e-12 * largest(*s));
            const auto cotan = get(cotan_matrices(mesh, {rule, MassRule::lumped}));
            EXPECT_LE(distance(cotan.stiffness, naive::cotan(get(triangulate_mesh(mesh, rule)))),
                      1e-12 * largest(cotan.stiffness));
        }
        Matrix graph = Matrix::Zero(mesh.vertex_count(), mesh.vertex_count());
        for (const Edge& e : build_topology(*mesh.connectivity()).edges) {
            graph(e.v0, e.v1) = graph(e.v1, e.v0) = -1;
            graph(e.v0, e.v0) += 1;
            graph(e.v1, e.v1) += 1;
        }
        EXPECT_EQ(distance(get(umbrella_stiffness(mesh)), graph), 0);
    }
    EXPECT_GE(compared, 100);
}

TEST(Assembly, SumsTheMassOfTheTriangles) {
    std::vector<Specimen> meshes = zoo();
    meshes.push_back({"framed", framed(40, 0.3, 0.1)});
    for (const auto& [name, mesh] : meshes) {
        const auto triangles = triangulate_mesh(mesh, TriangulationRule::delaunay);
        if (!triangles) continue;
        for (const auto rule : {MassRule::lumped, MassRule::barycentric, MassRule::ring, MassRule::circumcentric,
                                MassRule::mixed_voronoi, MassRule::galerkin}) {
            const SparseMatrix expected = get(surface_mass(mesh, *triangles, rule));
            const auto built = get(cotan_matrices(mesh, {TriangulationRule::delaunay, rule}));
            EXPECT_LE(difference(built.mass, expected), 1e-12 * largest(expected)) << name;
        }
    }
}

// Faces of three and four corners have kernels of their own; the face on its own always takes the general one.
TEST(Kernels, OfFewCornersAgreeWithTheGeneralOne) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (Index n = 3; n <= 9; ++n) {
        for (int round = 0; round < 200; ++round) {
            std::vector<Vector3> x;
            const double thin = round % 4 == 0 ? 1e-3 : 1;
            for (const Vector3& p : star(n, 0.3 * uniform(random), 0.5 * uniform(random))) {
                x.emplace_back(p.x() + 0.2 * uniform(random), thin * (p.y() + 0.2 * uniform(random)), p.z());
            }
            if (thin < 1) {
                for (Vector3& p : x)
                    p.z() *= thin;
            }
            const double lambda = round % 3 == 0 ? 0 : 0.1 * round;
            std::vector<double> half;
            for (Index k = 0; k < n; ++k) {
                half.push_back(
                    0.5 * (x[static_cast<std::size_t>((k + 1) % n)] - x[static_cast<std::size_t>(k)]).stableNorm());
            }
            const Matrix general = get(alexa_wardetzky_weighted_face(x, half, {lambda}));
            const SparseMatrix own = get(alexa_wardetzky_stiffness(make_face(x), {lambda}));
            EXPECT_LE(distance(own, general), 1e-11 * largest(own)) << n << " corners";
        }
    }
}

// The shortcut for convex quads must decide as triangulate_polygon does, ties included.
TEST(Kernels, CutQuadsAsTriangulatePolygonDoes) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<std::vector<Vector3>> quads;
    for (int round = 0; round < 2000; ++round) {
        std::vector<Vector3> x;
        for (const double quarter : {0.0, 1.0, 2.0, 3.0}) {  // on a circle: a tie
            const double angle = (quarter + 0.45 * uniform(random)) * M_PI / 2;
            x.emplace_back(std::cos(angle), std::sin(angle), 0);
        }
        if (round % 2 == 1) x[2] *= 1 + 0.6 * uniform(random);  // concave when far in
        if (round % 5 == 1) x[1] = 0.5 * (x[0] + x[2]);         // a straight corner
        if (round % 3 == 1) x[3] += Vector3(0, 0, 0.3);
        if (round % 7 == 1) x[2] *= 1 + std::pow(10, -6 + 5 * uniform(random));
        const Eigen::AngleAxisd turn(3 * uniform(random), Vector3(uniform(random), 1, uniform(random)).normalized());
        for (Vector3& p : x) {
            p = turn * p + Vector3(3, 4, 5);
        }
        quads.push_back(x);
    }
    int compared = 0;
    for (const auto& x : quads) {
        const PolygonMesh mesh = make_face(x);
        const auto s = planar_stiffness(mesh);
        if (!s) continue;
        ++compared;
        const Matrix expected = plain_planar(x, TriangulationRule::delaunay);
        ASSERT_LE(distance(*s, expected), 1e-9 * expected.cwiseAbs().maxCoeff());
        // In a tie the matrix has nothing across; what area each corner gets tells the diagonal.
        const SparseMatrix masses =
            get(surface_mass(mesh, get(triangulate_mesh(mesh, TriangulationRule::delaunay)), MassRule::barycentric));
        const auto cotan = get(cotan_matrices(mesh, {TriangulationRule::delaunay, MassRule::barycentric}));
        ASSERT_LE(difference(cotan.mass, masses), 1e-12 * largest(masses));
    }
    EXPECT_GE(compared, 1500);
}

TEST(Assembly, OfAMovedMeshIsThatOfAFreshOne) {
    for (const auto& [name, mesh] : zoo()) {
        const PolygonMesh moved = jittered(mesh, 11);
        const auto& faces = *mesh.connectivity();
        const auto fresh = get(PolygonMesh::create(moved.positions(), faces.offsets, faces.corners));
        OperatorMatrices reused;  // of whatever was built before
        for (const OperatorSpec& spec : all_specs(mesh)) {
            const auto expected = try_build(fresh, spec);
            if (!expected) continue;
            const auto built = get(build_operator(moved, spec));
            EXPECT_TRUE(same_bits(built.stiffness, expected->stiffness)) << spec_name(spec) << " on " << name;
            EXPECT_TRUE(same_bits(built.mass, expected->mass)) << spec_name(spec) << " on " << name;
            (void)rebuild_operator(mesh, spec, reused);
            check(rebuild_operator(moved, spec, reused));
            EXPECT_TRUE(same_bits(reused.stiffness, expected->stiffness)) << spec_name(spec) << " on " << name;
            EXPECT_TRUE(same_bits(reused.mass, expected->mass)) << spec_name(spec) << " on " << name;
            EXPECT_EQ(reused.structure, expected->structure);
        }
    }
}

TEST(Assembly, RebuildKeepsTheMemory) {
    const auto torus = get(make_torus(30, 20));
    auto matrices = get(build_operator(torus, {"planar", {}}));
    const double* const values = matrices.stiffness.valuePtr();
    check(rebuild_operator(jittered(torus, 1), {"alexa-wardetzky", {0.3}}, matrices));
    EXPECT_EQ(matrices.stiffness.valuePtr(), values);
}

TEST(Assembly, OfOneMeshInSeveralThreads) {
    const auto torus = get(make_torus(60, 40));
    const auto expected = get(build_operator(get(make_torus(60, 40)), {"alexa-wardetzky", {}}));
    std::vector<OperatorMatrices> built(4);
    std::vector<std::thread> threads;
    for (auto& matrices : built) {
        threads.emplace_back([&] { matrices = get(build_operator(torus, {"alexa-wardetzky", {}})); });
    }
    for (auto& thread : threads) {
        thread.join();
    }
    for (const auto& matrices : built) {
        EXPECT_TRUE(same_bits(matrices.stiffness, expected.stiffness));
    }
}

// More neighbours than a byte can count.
TEST(Assembly, AtAVertexOfManyFaces) {
    for (const Index spokes : {84, 86, 300}) {
        const PolygonMesh mesh = wheel(spokes);
        const SparseMatrix s = get(alexa_wardetzky_stiffness(mesh, {0.7}));
        EXPECT_GT(s.col(0).nonZeros(), 2 * spokes);
        const auto local = [](const std::vector<Vector3>& x) { return naive::alexa_wardetzky(x, 0.7); };
        EXPECT_LE(distance(s, dense_sum(mesh, local)), 1e-11 * largest(s)) << spokes;
    }
}

TEST(LargeFaces, TakeOnlyTheSidesOfTheirTriangles) {
    for (const Index n : {31, 32, 33, 34, 61}) {
        for (const double depth : {0.0, 0.4}) {
            const PolygonMesh mesh = framed(n, depth, depth);
            SCOPED_TRACE(n);
            const auto local = [](const std::vector<Vector3>& x) {
                return plain_planar(x, TriangulationRule::delaunay);
            };
            const SparseMatrix planar = get(planar_stiffness(mesh));
            EXPECT_LE(distance(planar, dense_sum(mesh, local)), 1e-12 * largest(planar));
            const auto cotan = get(cotan_matrices(mesh));
            EXPECT_LE(distance(cotan.stiffness, naive::cotan(get(triangulate_mesh(mesh, TriangulationRule::delaunay)))),
                      1e-12 * largest(cotan.stiffness));
            // Diagonal, outer ring, spokes, diagonals of the quads; and within the face its sides and diagonals.
            const Index quads = 2 * n + 2 * n + 2 * n + 4 * n;
            const Index face = n <= 32 ? n * (n - 1) : 2 * (2 * n - 3);
            EXPECT_EQ(planar.nonZeros(), quads + face);
            EXPECT_EQ(cotan.stiffness.nonZeros(), quads + face);
        }
    }
}

TEST(LargeFaces, OfTenThousandCorners) {
    const Index n = 10'000;
    const PolygonMesh mesh = make_face(star(n, 0, 0));
    EXPECT_EQ(get(umbrella_stiffness(mesh)).nonZeros(), 3 * n);
    const double area = n / 2.0 * std::sin(2 * M_PI / n);
    for (const SparseMatrix& s : {get(planar_stiffness(mesh)), get(cotan_matrices(mesh)).stiffness}) {
        EXPECT_EQ(s.nonZeros(), n + 2 * (2 * n - 3));
        for (int k = 0; k < 2; ++k) {
            const Vector u = mesh.positions().col(k);
            EXPECT_NEAR(u.dot(s * u), area, 1e-9 * area);
        }
    }
}

TEST(LargeFaces, NameThemselvesAndAreCancelled) {
    std::vector<Vector3> points = star(40, 0.2, 0);
    std::swap(points[3], points[20]);  // crosses itself
    for (const Vector3& p : star(3, 0, 0)) {
        points.emplace_back(p + Vector3(5, 0, 0));
    }
    std::vector<std::vector<Index>> faces{{40, 41, 42}, {}};
    for (Index k = 0; k < 40; ++k) {
        faces[1].push_back(k);
    }
    for (const char* id : {"planar", "cotan"}) {
        const auto refused = build_operator(make_mesh(points, faces), {id, {}});
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::degenerate_face);
        EXPECT_EQ(refused.error().element, 1);
        EXPECT_EQ(refused.error().message, "face 1: its projection crosses or touches itself");

        const PolygonMesh mesh = framed(40, 0.3, 0.1);
        Ticks all;
        ASSERT_TRUE(build_operator(mesh, {id, {}}, all.monitor()));
        EXPECT_TRUE(all.rise());
        for (std::size_t k = 1; k <= all.fractions.size(); ++k) {
            Ticks ticks{.fractions = {}, .stop_at = k};
            const auto stopped = build_operator(mesh, {id, {}}, ticks.monitor());
            ASSERT_FALSE(stopped);
            EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
        }
    }
}

}  // namespace
}  // namespace polylap::test

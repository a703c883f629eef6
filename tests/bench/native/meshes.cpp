#include "meshes.hpp"

#include <cmath>
#include <random>
#include <string>

#include "harness.hpp"
#include "polylap/apply/noise.hpp"
#include "polylap/mesh/shapes.hpp"

namespace polylap::bench {
namespace {

Index root_of(double n) {
    return std::max<Index>(4, static_cast<Index>(std::lround(std::sqrt(n))));
}

}  // namespace

PolygonMesh torus_of(Index n) {
    const Index side = root_of(n);
    return opened(add_normal_noise(opened(make_torus(side, side)), 0.1, 1));
}

PolygonMesh grid_of(Index n) {
    const Index side = root_of(n) - 1;
    return opened(make_grid(side, side));
}

PolygonMesh hexagon_sphere_of(Index n) {
    const double level = std::round(std::log(n / 20.0) / std::log(4.0));
    const std::pair<std::string, std::string> settings[] = {{"level", std::to_string(static_cast<int>(level))}};
    return opened(make_shape("hexagon-sphere", settings));
}

PolygonMesh thin_shell_of(Index n) {
    const Index side = root_of(n / 2.0);
    const double edge = 1.0 / (side - 1);
    std::mt19937 random(1);
    const auto noise = [&] { return edge * (static_cast<double>(random()) / 4294967296.0 - 0.5) / 2; };
    Points points(2 * side * side, 3);
    std::vector<Index> offsets{0};
    std::vector<Index> corners;
    const auto at = [&](Index sheet, Index i, Index j) { return (sheet * side + j) * side + i; };
    const auto quad = [&](Index a, Index b, Index c, Index d) {
        corners.insert(corners.end(), {a, b, c, d});
        offsets.push_back(static_cast<Index>(corners.size()));
    };
    for (Index sheet = 0; sheet < 2; ++sheet) {
        for (Index j = 0; j < side; ++j) {
            for (Index i = 0; i < side; ++i)
                points.row(at(sheet, i, j)) << i * edge + noise(), j * edge + noise(), sheet * edge / 2 + noise();
        }
    }
    for (Index j = 0; j + 1 < side; ++j) {
        for (Index i = 0; i + 1 < side; ++i) {
            quad(at(0, i, j), at(0, i, j + 1), at(0, i + 1, j + 1), at(0, i + 1, j));
            quad(at(1, i, j), at(1, i + 1, j), at(1, i + 1, j + 1), at(1, i, j + 1));
        }
    }
    const Index last = side - 1;
    for (Index k = 0; k < last; ++k) {
        quad(at(0, k, 0), at(0, k + 1, 0), at(1, k + 1, 0), at(1, k, 0));
        quad(at(0, k + 1, last), at(0, k, last), at(1, k, last), at(1, k + 1, last));
        quad(at(0, 0, k + 1), at(0, 0, k), at(1, 0, k), at(1, 0, k + 1));
        quad(at(0, last, k), at(0, last, k + 1), at(1, last, k + 1), at(1, last, k));
    }
    return opened(PolygonMesh::create(std::move(points), std::move(offsets), std::move(corners)));
}

PolygonMesh tori_of(Index n) {
    constexpr Index count = 8;
    const PolygonMesh torus = torus_of(n / count);
    const Index size = torus.vertex_count();
    Points points(count * size, 3);
    std::vector<Index> offsets{0};
    std::vector<Index> corners;
    for (Index k = 0; k < count; ++k) {
        points.middleRows(k * size, size) = torus.positions().rowwise() + Eigen::RowVector3d(3.0 * k, 0, 0);
        for (Index f = 0; f < torus.face_count(); ++f) {
            for (const Index v : torus.face(f))
                corners.push_back(k * size + v);
            offsets.push_back(static_cast<Index>(corners.size()));
        }
    }
    return opened(PolygonMesh::create(std::move(points), std::move(offsets), std::move(corners)));
}

}  // namespace polylap::bench

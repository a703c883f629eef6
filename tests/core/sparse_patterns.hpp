#pragma once

#include <random>
#include <string>
#include <vector>

#include "zoo.hpp"

namespace polylap::test {

/// A positive definite matrix, and where its unknowns may lie.
struct System {
    std::string name;
    SparseMatrix a;
    std::vector<Points> positions;  ///< Each n×3, or without rows.
};

/// Symmetric, with the given edges (both ends once), and positive definite by its diagonal.
inline SparseMatrix with_edges(Index n, const std::vector<std::pair<Index, Index>>& edges) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    Vector diagonal = Vector::Constant(n, 0.5);
    for (const auto& [i, j] : edges) {
        if (i == j) continue;
        const double w = -1 + 0.4 * std::sin(1.0 + std::min(i, j) + 3.0 * std::max(i, j));
        entries.emplace_back(i, j, w);
        entries.emplace_back(j, i, w);
        diagonal[i] -= w;
        diagonal[j] -= w;
    }
    for (Index i = 0; i < n; ++i)
        entries.emplace_back(i, i, diagonal[i]);
    SparseMatrix a(n, n);
    a.setFromTriplets(entries.begin(), entries.end(), [](double, double last) { return last; });
    return a;
}

inline Points scattered(Index n, unsigned seed) {
    std::mt19937 random(seed);
    Points x(n, 3);
    for (Index i = 0; i < n; ++i) {
        for (int k = 0; k < 3; ++k)
            x(i, k) = static_cast<double>(random() % 1000);
    }
    return x;
}

/// Grid of p×q vertices, each coupled with up to eight around it.
inline System grid_system(Index p, Index q) {
    std::vector<std::pair<Index, Index>> edges;
    Points plane(p * q, 3);
    for (Index i = 0; i < p; ++i) {
        for (Index j = 0; j < q; ++j) {
            plane.row(i * q + j) = Vector3(i, j, 0).transpose();
            if (j + 1 < q) edges.emplace_back(i * q + j, i * q + j + 1);
            if (i + 1 == p) continue;
            edges.emplace_back(i * q + j, (i + 1) * q + j);
            if (j + 1 < q) edges.emplace_back(i * q + j, (i + 1) * q + j + 1);
            if (j + 1 < q) edges.emplace_back(i * q + j + 1, (i + 1) * q + j);
        }
    }
    Points folded = plane;  // two sheets on each other
    for (Index v = 0; v < p * q; ++v)
        folded(v, 0) = std::abs(folded(v, 0) - (p - 1) / 2.0);
    Points broken = plane;
    broken(0, 1) = std::numeric_limits<double>::quiet_NaN();
    broken(p * q / 2, 0) = std::numeric_limits<double>::infinity();
    return {"grid " + std::to_string(p) + "×" + std::to_string(q),
            with_edges(p * q, edges),
            {{}, plane, Points::Zero(p * q, 3), scattered(p * q, 1), folded, broken}};
}

/// Patterns that meshes do not have, from empty to dense; up to 4000 unknowns.
inline std::vector<System> sparse_systems() {
    std::vector<System> systems;
    const auto add = [&](std::string name, Index n, const std::vector<std::pair<Index, Index>>& edges) {
        systems.push_back({std::move(name), with_edges(n, edges), {Points(0, 3), scattered(n, 2), Points::Zero(n, 3)}});
    };
    for (const Index n : {0, 1, 2, 3, 1000})
        add("diagonal " + std::to_string(n), n, {});
    std::vector<std::pair<Index, Index>> path, arrow, all, pairs;
    for (Index i = 1; i < 1500; ++i) {
        path.emplace_back(i - 1, i);
        arrow.emplace_back(0, i);
        if (i % 2 == 1) pairs.emplace_back(i - 1, i);
    }
    for (Index i = 0; i < 260; ++i) {
        for (Index j = 0; j < i; ++j)
            all.emplace_back(i, j);
    }
    add("tridiagonal", 1500, path);
    add("arrow", 1500, arrow);
    add("pairs", 1500, pairs);
    add("dense", 260, all);
    auto hub = path;
    for (Index i = 2; i < 1500; i += 3)
        hub.emplace_back(0, i);
    add("path with a dense row", 1500, hub);
    std::mt19937 random(7);
    for (const Index n : {5, 50, 300, 900}) {
        for (const Index degree : {1, 3, 6}) {
            std::vector<std::pair<Index, Index>> edges;
            for (Index k = 0; k < n * degree / 2; ++k) {
                edges.emplace_back(static_cast<Index>(random() % n), static_cast<Index>(random() % n));
            }
            add("random " + std::to_string(n) + " of degree " + std::to_string(degree), n, edges);
        }
    }
    auto grids = grid_system(30, 21);  // several components of different size
    std::vector<std::pair<Index, Index>> islands;
    for (Index column = 0; column < grids.a.cols(); ++column) {
        for (SparseMatrix::InnerIterator it(grids.a, column); it; ++it) {
            if (it.row() > column && it.row() % 100 > 20 && column % 100 > 20) islands.emplace_back(it.row(), column);
        }
    }
    add("islands", 630, islands);
    systems.push_back(grid_system(7, 5));
    systems.push_back(grid_system(24, 24));
    systems.push_back(grid_system(4, 400));
    systems.push_back(grid_system(64, 60));
    return systems;
}

}  // namespace polylap::test

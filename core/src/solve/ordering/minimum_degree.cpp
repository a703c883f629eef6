// Minimum degree on the elimination graph itself, kept as bit sets: exact, and for a hundred vertices faster than
// quotient graphs. That it sees the neighbours outside (the halo) is what makes it fit under nested dissection:
// Pellegrini, Roman & Amestoy, Hybridizing nested dissection and halo approximate minimum degree, 2000.

#include "solve/ordering/minimum_degree.hpp"

#include <algorithm>
#include <bit>

#include <Eigen/OrderingMethods>

namespace polylap {

void MinimumDegree::order(std::span<Index> vertices) {
    const std::size_t n = vertices.size();
    if (n < 2) return;
    for (std::size_t k = 0; k < n; ++k) {
        local_[static_cast<std::size_t>(vertices[k])] = static_cast<Index>(k);
    }
    halo_.clear();
    for (const Index v : vertices) {
        for (const Index u : graph_.around(v)) {
            Index& number = local_[static_cast<std::size_t>(u)];
            if (number >= 0) continue;
            number = static_cast<Index>(n + halo_.size());
            halo_.push_back(u);
        }
    }
    const std::size_t words = (n + halo_.size() + 63) / 64;
    adjacent_.assign(n * words, 0);
    degree_.resize(n);
    const auto row = [&](std::size_t k) { return adjacent_.data() + k * words; };
    const auto count = [&](std::size_t k) {
        int bits = 0;
        for (std::size_t w = 0; w < words; ++w)
            bits += std::popcount(row(k)[w]);
        degree_[k] = bits;
    };
    for (std::size_t k = 0; k < n; ++k) {
        for (const Index u : graph_.around(vertices[k])) {
            const auto number = static_cast<std::size_t>(local_[static_cast<std::size_t>(u)]);
            row(k)[number / 64] |= std::uint64_t{1} << number % 64;
        }
        count(k);
    }
    result_.clear();
    constexpr Index gone = -1;
    for (std::size_t step = 0; step < n; ++step) {
        std::size_t best = n;
        for (std::size_t k = 0; k < n; ++k) {
            if (degree_[k] != gone && (best == n || degree_[k] < degree_[best])) best = k;
        }
        result_.push_back(vertices[best]);
        degree_[best] = gone;
        const std::uint64_t* const reached = row(best);
        for (std::size_t w = 0; w < (n + 63) / 64; ++w) {
            for (std::uint64_t bits = reached[w]; bits != 0; bits &= bits - 1) {
                const std::size_t k = w * 64 + static_cast<std::size_t>(std::countr_zero(bits));
                if (k >= n) break;  // the halo
                std::uint64_t* const mine = row(k);
                for (std::size_t i = 0; i < words; ++i)
                    mine[i] |= reached[i];
                mine[k / 64] &= ~(std::uint64_t{1} << k % 64);
                mine[best / 64] &= ~(std::uint64_t{1} << best % 64);
                count(k);
            }
        }
    }
    for (const Index v : vertices)
        local_[static_cast<std::size_t>(v)] = -1;
    for (const Index v : halo_)
        local_[static_cast<std::size_t>(v)] = -1;
    std::copy(result_.begin(), result_.end(), vertices.begin());
}

void order_by_amd(const Graph& graph, std::span<Index> vertices) {
    const auto n = static_cast<Index>(vertices.size());
    if (n < 2) return;
    std::vector<Index> local(static_cast<std::size_t>(graph.size()), -1);
    for (Index k = 0; k < n; ++k)
        local[static_cast<std::size_t>(vertices[static_cast<std::size_t>(k)])] = k;
    std::vector<Index> outer{0};
    std::vector<Index> inner;
    for (const Index v : vertices) {
        inner.push_back(local[static_cast<std::size_t>(v)]);  // without its diagonal, Eigen puts a row last
        for (const Index u : graph.around(v)) {
            if (const Index k = local[static_cast<std::size_t>(u)]; k >= 0) inner.push_back(k);
        }
        std::sort(inner.begin() + outer.back(), inner.end());
        outer.push_back(static_cast<Index>(inner.size()));
    }
    const std::vector<double> ones(inner.size(), 1);  // the ordering wants a matrix, but reads its pattern alone
    const SparseMatrix pattern =
        Eigen::Map<const SparseMatrix>(n, n, outer.back(), outer.data(), inner.data(), ones.data());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> permutation;
    Eigen::AMDOrdering<Index>()(pattern, permutation);
    std::vector<Index> ordered(vertices.size());
    for (Index k = 0; k < n; ++k) {
        ordered[static_cast<std::size_t>(k)] = vertices[static_cast<std::size_t>(permutation.indices()[k])];
    }
    std::copy(ordered.begin(), ordered.end(), vertices.begin());
}

}  // namespace polylap

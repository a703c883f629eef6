#include "operators/edge_gradient.hpp"

#include <cmath>

namespace polylap {
namespace {

/// x minus its part along the unit vector q, twice: once leaves rounding errors of the size of what was removed.
template <class Column, class Unit>
void orthogonalise(Column&& x, const Unit& q) {
    x -= q * q.dot(x);
    x -= q * q.dot(x);
}

}  // namespace

Status EdgeGradient::operator()(Corners x, std::span<const double> shift, LocalMatrix& s) {
    if (!project_maximally(x, projection_)) {
        return Error{ErrorCode::degenerate_face, "its vector area is zero"};
    }
    const auto n = static_cast<Index>(x.size());
    const auto next = [n](Index i) { return i + 1 == n ? 0 : i + 1; };
    const auto at = [x](Index i) -> const Vector3& { return x[static_cast<std::size_t>(i)]; };
    const auto& p = projection_.points;
    basis_.resize(n, 2);
    for (Index i = 0; i < n; ++i) {
        basis_.row(i) = p[static_cast<std::size_t>(next(i))] - p[static_cast<std::size_t>(i)];
    }
    // The longer column first: the other one cannot vanish against it unless the area does.
    if (basis_.col(0).squaredNorm() < basis_.col(1).squaredNorm()) basis_.col(0).swap(basis_.col(1));
    basis_.col(0).normalize();
    orthogonalise(basis_.col(1), basis_.col(0));
    basis_.col(1).normalize();

    rows_.resize(n, 8);
    const double lambda_root = std::sqrt(lambda_);
    const double area_root = std::sqrt(projection_.area);
    for (Index i = 0; i < n; ++i) {
        const Index before = i == 0 ? n - 1 : i - 1;
        const Vector3 chord = at(before) - at(next(i));
        rows_.row(i).head<3>() = chord / (2 * area_root);
        rows_.row(i).segment<3>(3) = rows_.row(i).head<3>();
        if (!shift.empty()) {
            // Beyond ½ (xᵢ₋₁ - xᵢ₊₁), so that no shift changes no bit.
            const double s0 = shift[static_cast<std::size_t>(before)];
            const double s1 = shift[static_cast<std::size_t>(i)];
            rows_.row(i).segment<3>(3) -= (s0 * (at(before) - at(i)) + s1 * (at(next(i)) - at(i))) / area_root;
        }
        rows_.row(i).tail<2>() = lambda_root * (basis_.row(before) - basis_.row(i));
    }
    for (Index j = 0; j < n; ++j) {
        for (Index i = 0; i < n; ++i) {
            s(i, j) = rows_.row(i).head<3>().dot(rows_.row(j).segment<3>(3)) -
                      rows_.row(i).tail<2>().dot(rows_.row(j).tail<2>());
        }
    }
    for (Index i = 0; i < n; ++i) {
        s(i, i) += 2 * lambda_;
        s(i, next(i)) -= lambda_;
        s(next(i), i) -= lambda_;
    }
    return Done{};
}

}  // namespace polylap

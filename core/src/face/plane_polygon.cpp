#include "face/plane_polygon.hpp"

namespace polylap {
/// c, known to lie on the line a–b, lies on the closed segment.
bool PlanePolygon::within(Index a, Index b, Index c) const {
    return ((*this)[c] - (*this)[a]).dot((*this)[c] - (*this)[b]) <= 0;
}

/// The edges i → i+1 and j → j+1 share a point that is no common corner.
bool PlanePolygon::touch(Index i, Index j) const {
    const Index i1 = next(i);
    const Index j1 = next(j);
    if (i1 == j) return side(i, i1, j1) == 0 && ((*this)[i] - (*this)[i1]).dot((*this)[j1] - (*this)[i1]) >= 0;
    if (j1 == i) return touch(j, i);
    const int a = side(i, i1, j);
    const int b = side(i, i1, j1);
    const int c = side(j, j1, i);
    const int d = side(j, j1, i1);
    if (a * b < 0 && c * d < 0) return true;
    return (a == 0 && within(i, i1, j)) || (b == 0 && within(i, i1, j1)) || (c == 0 && within(j, j1, i)) ||
           (d == 0 && within(j, j1, i1));
}

bool PlanePolygon::simple() const {
    if (strictly_convex()) return true;
    for (Index i = 0; i < size(); ++i) {
        for (Index j = 0; j < i; ++j) {
            if (touch(i, j)) return false;
        }
    }
    return true;
}

bool PlanePolygon::inside_diagonal(Index i, Index j) const {
    if (next(i) == j || next(j) == i) return false;
    // It must leave i between the two edges there, on the inner side.
    const Index before = previous(i);
    const Index after = next(i);
    const bool convex = side(before, i, after) > 0;
    const bool left_of_after = side(i, after, j) > 0;
    const bool left_of_before = side(before, i, j) > 0;
    if (convex ? !(left_of_after && left_of_before) : !(left_of_after || left_of_before)) {
        // At a straight corner both tests are the same; at a reflex one either is enough.
        return false;
    }
    // No corner may lie on it and no edge cross it, between j and i nor between i and j.
    const Eigen::Vector2d u = (*this)[j] - (*this)[i];
    const double u_size = u.lpNorm<1>();
    int last = 0;  // the side of the corner before, 0 at either end
    for (Index k = after; k != i; k = next(k)) {
        if (k == j) {
            last = 0;
            continue;
        }
        const Eigen::Vector2d v = (*this)[k] - (*this)[i];
        const int now = side_of_noise(cross(u, v), u_size + v.lpNorm<1>());
        if (now == 0 && within(i, j, k)) return false;
        if (now * last < 0 && side(previous(k), k, i) * side(previous(k), k, j) < 0) return false;
        last = now;
    }
    return true;
}

}  // namespace polylap

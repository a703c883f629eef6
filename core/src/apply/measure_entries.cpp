// What can be read off the entries of a stiffness matrix.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "apply/measure.hpp"
#include "polylap/face/vector_area.hpp"

namespace polylap {
namespace {

std::string pair_name(Index i, Index j) {
    return "vertices " + std::to_string(i) + " and " + std::to_string(j);
}

std::string counted(Index count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// The faces at each vertex, ascending.
class FacesAtVertices {
public:
    explicit FacesAtVertices(const PolygonMesh& mesh) : first_(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0) {
        const auto& corners = mesh.connectivity()->corners;
        for (const Index v : corners) {
            ++first_[static_cast<std::size_t>(v) + 1];
        }
        for (std::size_t v = 1; v < first_.size(); ++v) {
            first_[v] += first_[v - 1];
        }
        faces_.resize(corners.size());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (Index f = 0; f < mesh.face_count(); ++f) {
            for (const Index v : mesh.face(f)) {
                faces_[next[static_cast<std::size_t>(v)]++] = f;
            }
        }
    }

    bool share_face(Index i, Index j) const {
        auto few = at(i);
        auto many = at(j);
        if (few.size() > many.size()) std::swap(few, many);
        return std::any_of(few.begin(), few.end(),
                           [&](Index f) { return std::binary_search(many.begin(), many.end(), f); });
    }

private:
    std::span<const Index> at(Index v) const {
        const std::size_t from = first_[static_cast<std::size_t>(v)];
        return std::span(faces_).subspan(from, first_[static_cast<std::size_t>(v) + 1] - from);
    }

    std::vector<std::size_t> first_;
    std::vector<Index> faces_;
};

/// Faces that differ from their plane, or normals from each other, by less are flat: below what sums of S can tell.
constexpr double flatness = 1e-10;

/// Unit normals of planar faces; zero where a face is not planar.
std::vector<Vector3> plane_normals(const PolygonMesh& mesh) {
    std::vector<Vector3> normals;
    normals.reserve(static_cast<std::size_t>(mesh.face_count()));
    std::vector<Vector3> corners;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        gather_corners(mesh, f, corners);
        const Vector3 a = vector_area(corners);
        Vector3& normal = normals.emplace_back(Vector3::Zero());
        if (has_zero_area(corners, a)) continue;
        const double area = a.stableNorm();
        const Vector3 u = a / area;
        const double allowed = flatness * std::sqrt(area);
        if (std::all_of(corners.begin(), corners.end(),
                        [&](const Vector3& p) { return std::abs(u.dot(p - corners[0])) <= allowed; })) {
            normal = u;
        }
    }
    return normals;
}

/// V normals: of the plane of all faces at a vertex; zero where there is none, or at the boundary.
std::vector<Vector3> flat_normals(const PolygonMesh& mesh, const Topology& topology) {
    const auto n = static_cast<std::size_t>(mesh.vertex_count());
    std::vector<char> flat(n, 1);
    for (const Edge& e : topology.edges) {
        if (e.forward == 1 && e.backward == 1) continue;
        flat[static_cast<std::size_t>(e.v0)] = flat[static_cast<std::size_t>(e.v1)] = 0;
    }
    const std::vector<Vector3> faces = plane_normals(mesh);
    std::vector<Vector3> normals(n, Vector3::Zero());
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const Vector3& u = faces[static_cast<std::size_t>(f)];
        for (const Index corner : mesh.face(f)) {
            const auto v = static_cast<std::size_t>(corner);
            if (normals[v].isZero()) normals[v] = u;
            if (u.isZero() || (normals[v] - u).norm() > flatness) flat[v] = 0;
        }
    }
    for (std::size_t v = 0; v < n; ++v) {
        if (flat[v] == 0) normals[v].setZero();
    }
    return normals;
}

}  // namespace

std::string figure(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string vertex_name(Index v) {
    return "vertex " + std::to_string(v);
}

std::vector<Index> flat_inner_vertices(const PolygonMesh& mesh, const Topology& topology) {
    const std::vector<Vector3> normals = flat_normals(mesh, topology);
    std::vector<Index> inner;
    for (std::size_t v = 0; v < normals.size(); ++v) {
        if (!normals[v].isZero()) inner.push_back(static_cast<Index>(v));
    }
    return inner;
}

Measurement measure_symmetry(const Subject& subject) {
    const SparseMatrix& s = subject.stiffness();
    const SparseMatrix transposed = s.transpose();
    const SparseMatrix difference = s - transposed;
    double worst = 0;
    Index i = -1;
    Index j = -1;
    for (Index column = 0; column < difference.cols(); ++column) {
        for (SparseMatrix::InnerIterator it(difference, column); it; ++it) {
            if (std::abs(it.value()) <= worst) continue;
            worst = std::abs(it.value());
            i = it.index();
            j = column;
        }
    }
    const double norm = s.norm();
    const double value = norm > 0 ? difference.norm() / norm : 0;
    std::string text = "‖S - Sᵀ‖ is " + figure(value) + " of ‖S‖";
    if (worst <= subject.zero()) return measured(true, value, std::move(text), {});
    text += "; the worst pair: " + figure(s.coeff(i, j)) + " from " + vertex_name(i) + " to " + std::to_string(j) +
            ", " + figure(s.coeff(j, i)) + " back";
    return measured(false, value, std::move(text), {i, j});
}

Measurement measure_locality(const Subject& subject) {
    const SparseMatrix& s = subject.stiffness();
    const FacesAtVertices faces(subject.mesh);
    Index joined = 0;
    Index distant = 0;
    double worst = 0;
    Index i = -1;
    Index j = -1;
    for (Index column = 0; column < s.cols(); ++column) {
        for (SparseMatrix::InnerIterator it(s, column); it; ++it) {
            if (it.index() == column || std::abs(it.value()) <= subject.zero()) continue;
            ++joined;
            if (faces.share_face(it.index(), column)) continue;
            ++distant;
            if (std::abs(it.value()) <= std::abs(worst)) continue;
            worst = it.value();
            i = it.index();
            j = column;
        }
    }
    if (distant == 0) {
        return measured(true, 0,
                        "all " + counted(joined, "ordered pair", "ordered pairs") + " with a weight share a face", {});
    }
    return measured(false, subject.relative(std::abs(worst)),
                    std::to_string(distant) + " of " + counted(joined, "ordered pair", "ordered pairs") +
                        " with a weight share no face; the largest weight is " + figure(-worst) + " between " +
                        pair_name(i, j),
                    {i, j});
}

Measurement measure_positive_weights(const Subject&, const WeightSummary& weights) {
    const std::string all = counted(weights.nonzero_ordered, "ordered pair", "ordered pairs");
    if (weights.negative.empty()) return measured(true, 0, "no weight is negative among " + all, {});
    const Weight& worst = *std::min_element(weights.negative.begin(), weights.negative.end(),
                                            [](const Weight& a, const Weight& b) { return a.value < b.value; });
    return measured(false, -worst.value,
                    std::to_string(weights.negative_ordered) + " of " + all + " (" +
                        counted(static_cast<Index>(weights.negative.size()), "unordered pair", "unordered pairs") +
                        ") have a negative weight; the worst is " + figure(worst.value) + " between " +
                        pair_name(worst.i, worst.j),
                    {worst.i, worst.j});
}

Measurement measure_constants(const Subject& subject) {
    const SparseMatrix& s = subject.stiffness();
    if (s.rows() == 0) return not_measured("there are no vertices");
    const Vector sums = s * Vector::Ones(s.cols());
    Eigen::Index row = 0;
    const double worst = sums.cwiseAbs().maxCoeff(&row);
    const auto v = static_cast<Index>(row);
    const double value = subject.relative(worst);
    const bool holds = worst <= subject.zero();
    return measured(holds, value,
                    holds ? "no row sum exceeds " + figure(value) + " of the largest diagonal entry"
                          : "the row of " + vertex_name(v) + " sums to " + figure(sums[v]) + ", " + figure(value) +
                                " of the largest diagonal entry",
                    {v});
}

Measurement measure_linear_precision(const Subject& subject) {
    // Weights join the vertex to its faces' corners as a rule; those of wider stencils must lie in the plane as well.
    const PolygonMesh& mesh = subject.mesh;
    const SparseMatrix columns_are_rows = subject.stiffness().transpose();
    const std::vector<Vector3> normals = flat_normals(mesh, subject.topology);
    Index places = 0;
    double value = -1;
    Index vertex = -1;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        const Vector3& normal = normals[static_cast<std::size_t>(v)];
        if (normal.isZero()) continue;
        Vector3 sum = Vector3::Zero();
        double terms = 0;
        bool flat = true;
        for (SparseMatrix::InnerIterator it(columns_are_rows, v); it; ++it) {
            if (std::abs(it.value()) <= subject.zero()) continue;  // a row of rounding alone has no precision to lose
            const Vector3 edge = mesh.position(it.index()) - mesh.position(v);
            const double length = edge.stableNorm();
            if (std::abs(normal.dot(edge)) > 1e2 * flatness * length) {
                flat = false;
                break;
            }
            sum += it.value() * edge;
            terms += std::abs(it.value()) * length;
        }
        if (!flat) continue;
        ++places;
        const double relative = terms > 0 ? sum.stableNorm() / terms : 0;
        if (relative <= value) continue;
        value = relative;
        vertex = v;
    }
    if (places == 0) return not_measured("no inner vertex has surroundings in one plane");
    const std::string over = counted(places, "flat inner vertex", "flat inner vertices");
    if (value <= linear_tolerance) {
        return measured(true, value, "(S x)ᵢ is at most " + figure(value) + " of its terms at " + over, {});
    }
    return measured(false, value,
                    "(S x)ᵢ is " + figure(value) + " of its terms at " + vertex_name(vertex) + ", the worst of " + over,
                    {vertex});
}

}  // namespace polylap

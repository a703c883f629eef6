#include "naive_assembly.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace polylap::bench {
namespace {

Matrix corners_of(const PolygonMesh& mesh, Index f) {
    const auto face = mesh.face(f);
    Matrix x(static_cast<Eigen::Index>(face.size()), 3);
    for (std::size_t i = 0; i < face.size(); ++i)
        x.row(static_cast<Eigen::Index>(i)) = mesh.positions().row(face[i]);
    return x;
}

Vector3 vector_area_of(const Matrix& x) {
    Vector3 a = Vector3::Zero();
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
        const Vector3 p = x.row(i);
        const Vector3 q = x.row((i + 1) % x.rows());
        a += p.cross(q) / 2;
    }
    return a;
}

/// Sums the local matrices of all faces, and |a| / n at their corners.
template <class Local>
OperatorMatrices assemble(const PolygonMesh& mesh, Local&& local) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    Vector mass = Vector::Zero(mesh.vertex_count());
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        const Matrix x = corners_of(mesh, f);
        const Vector3 a = vector_area_of(x);
        const Matrix s = local(x, a);
        for (std::size_t j = 0; j < face.size(); ++j) {
            mass[face[j]] += a.norm() / static_cast<double>(face.size());
            for (std::size_t i = 0; i < face.size(); ++i)
                entries.emplace_back(face[i], face[j], s(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
        }
    }
    OperatorMatrices matrices;
    matrices.stiffness.resize(mesh.vertex_count(), mesh.vertex_count());
    matrices.stiffness.setFromTriplets(entries.begin(), entries.end());
    matrices.mass = mass.asDiagonal();
    return matrices;
}

Matrix edge_gradient(const Matrix& x, const Vector3& a) {
    const Eigen::Index n = x.rows();
    Matrix d = Matrix::Zero(n, n);  // the coboundary: edge i runs from corner i to corner i + 1
    Matrix b(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Index next = (i + 1) % n;
        d(i, i) = -1;
        d(i, next) = 1;
        b.row(i) = (x.row(i) + x.row(next)) / 2;
    }
    const Vector3 normal = a.normalized();
    const Matrix flat = x - (x * normal) * normal.transpose();
    const Eigen::JacobiSVD<Matrix> svd((d * flat).transpose(), Eigen::ComputeFullV);
    const Matrix c = svd.matrixV().rightCols(n - 2);
    return d.transpose() * (b * b.transpose() / a.norm() + c * c.transpose()) * d;
}

bool inside_circle(const Matrix& p, Eigen::Index i, Eigen::Index j, Eigen::Index k, Eigen::Index other) {
    Eigen::Matrix3d m;
    const Eigen::Index corners[] = {i, j, k};
    for (Eigen::Index row = 0; row < 3; ++row) {
        const Eigen::RowVector2d q = p.row(corners[row]) - p.row(other);
        m.row(row) << q.x(), q.y(), q.squaredNorm();
    }
    return m.determinant() > 0;
}

void add_cotan(const Matrix& p, Eigen::Index i, Eigen::Index j, Eigen::Index at, Matrix& s) {
    const Eigen::RowVector2d u = p.row(i) - p.row(at);
    const Eigen::RowVector2d v = p.row(j) - p.row(at);
    const double w = 0.5 * u.dot(v) / (u.x() * v.y() - u.y() * v.x());
    s(i, i) += w;
    s(j, j) += w;
    s(i, j) -= w;
    s(j, i) -= w;
}

Matrix projected_cotan(const Matrix& x, const Vector3& a) {
    const Eigen::Index n = x.rows();
    Matrix frame(3, 2);
    frame.col(0) = a.unitOrthogonal();
    frame.col(1) = a.normalized().cross(Vector3(frame.col(0)));
    const Matrix p = x * frame;
    Matrix s = Matrix::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = i + 1; j < n; ++j) {
            for (Eigen::Index k = j + 1; k < n; ++k) {
                bool empty = true;
                for (Eigen::Index other = 0; other < n; ++other) {
                    if (other != i && other != j && other != k) empty &= !inside_circle(p, i, j, k, other);
                }
                if (!empty) continue;
                add_cotan(p, i, j, k, s);
                add_cotan(p, j, k, i, s);
                add_cotan(p, k, i, j, s);
            }
        }
    }
    return s;
}

}  // namespace

OperatorMatrices naive_edge_gradient(const PolygonMesh& mesh) {
    return assemble(mesh, edge_gradient);
}

OperatorMatrices naive_projected_cotan(const PolygonMesh& mesh) {
    return assemble(mesh, projected_cotan);
}

}  // namespace polylap::bench

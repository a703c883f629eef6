#pragma once

#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "operators/assemble_faces.hpp"
#include "polylap/base/parameter.hpp"

namespace polylap {

/// The matrix of one face after Alexa & Wardetzky 2011, with free points on its edges [Herholz 2012, eq. 4.29 and
/// 4.31]: S_f = δᵀ( B (Bʷ)ᵀ/|a| + λ CCᵀ )δ. B are the midpoints of the edges, Bʷ the points xᵢ + (½ + shiftᵢ) eᵢ, C an
/// orthonormal basis of ker Ēᵀ, what projected edges do not see.
///
/// δᵀB has the rows ½(xᵢ₋₁ - xᵢ₊₁), half a chord each. The kernel of Ēᵀ always holds the constants, which δ removes:
/// nothing else is in it for a triangle, one more vector for a quad.
class EdgeGradient {
public:
    explicit EdgeGradient(double lambda) : lambda_(lambda) {}

    template <std::size_t n>
    Status operator()(const Face<n>& face, LocalMatrix<n>& s, std::span<double, n>) {
        fill(face, s);
        return Done{};
    }

    /// @param shift n: how far the point of each edge lies past its middle, in lengths of the edge
    template <std::size_t n>
    void fill_shifted(const Face<n>& face, std::span<const double> shift, LocalMatrix<n>& s) {
        fill(face, s);
        for (std::size_t j = 0; j < face.x.size(); ++j) {
            const auto edge = [&](std::size_t to) -> Vector3 { return face.x[to] - face.x[j]; };
            const std::size_t b = before(face, j);
            const Vector3 moved = (shift[b] * edge(b) + shift[j] * edge(next(face, j))) / (2 * face.area);
            for (std::size_t i = 0; i < face.x.size(); ++i) {
                at(s, i, j) -= chord(face, i).dot(moved);
            }
        }
    }

private:
    template <std::size_t n>
    static std::size_t next(const Face<n>& face, std::size_t i) {
        return i + 1 == face.x.size() ? 0 : i + 1;
    }
    template <std::size_t n>
    static std::size_t before(const Face<n>& face, std::size_t i) {
        return i == 0 ? face.x.size() - 1 : i - 1;
    }
    template <std::size_t n>
    static Vector3 chord(const Face<n>& face, std::size_t i) {
        return face.x[before(face, i)] - face.x[next(face, i)];
    }
    template <class Local>
    static double& at(Local& s, std::size_t i, std::size_t j) {
        return s(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }

    void fill(const Face<3>& face, LocalMatrix<3>& s) const {
        const double scale = 1 / (4 * face.area);
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t i = 0; i <= j; ++i) {
                at(s, i, j) = at(s, j, i) = chord(face, i).dot(chord(face, j)) * scale;
            }
        }
    }

    /// In the plane (e₁×e₂) e₀ - (e₀×e₂) e₁ + (e₀×e₁) e₂ = 0: these factors, and 0 for e₃, are in the kernel. Less
    /// their mean they are orthogonal to the constants, and what δᵀ makes of them is r, with or without the mean.
    void fill(const Face<4>& face, LocalMatrix<4>& s) const {
        const Vector3 e0 = face.x[1] - face.x[0];
        const Vector3 e1 = face.x[2] - face.x[1];
        const Vector3 e2 = face.x[3] - face.x[2];
        const double inverse = 1 / face.area;
        const Vector3 normal = face.vector_area * inverse * inverse;  // so that the factors are near 1
        const double k0 = e1.cross(e2).dot(normal);
        const double k1 = -e0.cross(e2).dot(normal);
        const double k2 = e0.cross(e1).dot(normal);
        const double mean = (k0 + k1 + k2) / 4;
        const auto square = [mean](double k) { return (k - mean) * (k - mean); };
        const double factor = lambda_ / (square(k0) + square(k1) + square(k2) + square(0));
        const double r0 = -k0;
        const double r1 = k0 - k1;
        const double r2 = k1 - k2;
        const double r3 = k2;
        const double f0 = factor * r0;
        const double f1 = factor * r1;
        const double f2 = factor * r2;
        const double f3 = factor * r3;

        const Vector3 c = face.x[3] - face.x[1];  // the chords are c, d, -c, -d
        const Vector3 d = face.x[0] - face.x[2];
        const double scale = inverse / 4;
        const double cc = c.squaredNorm() * scale;
        const double cd = c.dot(d) * scale;
        const double dd = d.squaredNorm() * scale;
        s(0, 0) = cc + f0 * r0;
        s(1, 1) = dd + f1 * r1;
        s(2, 2) = cc + f2 * r2;
        s(3, 3) = dd + f3 * r3;
        s(0, 1) = s(1, 0) = f0 * r1 + cd;
        s(0, 2) = s(2, 0) = f0 * r2 - cc;
        s(0, 3) = s(3, 0) = f0 * r3 - cd;
        s(1, 2) = s(2, 1) = f1 * r2 - cd;
        s(1, 3) = s(3, 1) = f1 * r3 - dd;
        s(2, 3) = s(3, 2) = f2 * r3 + cd;
    }

    /// CCᵀ = I - QQᵀ, Q an orthonormal basis of the columns of Ē: with R = δᵀQ that is δᵀδ - RRᵀ.
    void fill(const Face<std::dynamic_extent>& face, LocalMatrix<std::dynamic_extent>& s) {
        const std::size_t size = face.x.size();
        points_.resize(size);
        project_along(face.x, face.vector_area / face.area, points_);
        basis_.resize(size);
        for (std::size_t i = 0; i < size; ++i) {
            basis_[i] = points_[next(face, i)] - points_[i];
        }
        orthonormalise(basis_);
        rows_.resize(5, static_cast<Eigen::Index>(size));
        const double scale = 1 / (2 * std::sqrt(face.area));
        const double root = std::sqrt(lambda_);
        for (std::size_t i = 0; i < size; ++i) {
            rows_.col(static_cast<Eigen::Index>(i)) << chord(face, i) * scale,
                root * (basis_[before(face, i)] - basis_[i]);
        }
        for (Eigen::Index j = 0; j < s.cols(); ++j) {
            for (Eigen::Index i = 0; i <= j; ++i) {
                s(i, j) = s(j, i) = rows_.col(i).head<3>().dot(rows_.col(j).head<3>()) -
                                    rows_.col(i).tail<2>().dot(rows_.col(j).tail<2>());
            }
        }
        for (std::size_t i = 0; i < size; ++i) {
            at(s, i, i) += 2 * lambda_;
            at(s, i, next(face, i)) -= lambda_;
            at(s, next(face, i), i) -= lambda_;
        }
    }

    /// The two columns, n×2.
    static void orthonormalise(std::vector<Eigen::Vector2d>& q) {
        Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>> rows(
            q.front().data(), static_cast<Eigen::Index>(q.size()), 2);
        // The longer column first: the other one cannot vanish against it unless the area does.
        if (rows.col(0).squaredNorm() < rows.col(1).squaredNorm()) rows.col(0).swap(rows.col(1));
        rows.col(0).normalize();
        for (int round = 0; round < 2; ++round) {  // once leaves rounding errors of the size of what is removed
            rows.col(1) -= rows.col(0) * rows.col(0).dot(rows.col(1));
        }
        rows.col(1).normalize();
    }

    double lambda_;
    std::vector<Eigen::Vector2d> points_, basis_;
    Eigen::Matrix<double, 5, Eigen::Dynamic> rows_;  ///< δᵀB/√|a| | √λ R, transposed.
};

constexpr Parameter lambda_parameter(const char* hint) {
    return {.id = "lambda",
            .label = "λ",
            .kind = Parameter::Kind::real,
            .min = 0,
            .max = 1e6,
            .slider_max = 2,
            .step = 0.01,
            .initial = 1,
            .hint = hint};
}

}  // namespace polylap

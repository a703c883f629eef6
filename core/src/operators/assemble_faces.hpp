#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/square.hpp"
#include "face/projection.hpp"
#include "mesh/face_pairs.hpp"
#include "operators/sparse_pattern.hpp"
#include "polylap/operators/operator.hpp"

namespace polylap {

/// A face of n corners, known to the compiler or std::dynamic_extent.
template <std::size_t n>
struct Face {
    std::span<const Index, n> vertices;
    std::span<const Vector3, n> x;
    Vector3 vector_area;
    double area = 0;  ///< |vector_area|, not zero as has_zero_area has it.
};

template <std::size_t n>
inline constexpr int rows_of = n == std::dynamic_extent ? Eigen::Dynamic : static_cast<int>(n);

/// n×n, column-major, all zero when a face begins.
template <std::size_t n>
using LocalMatrix =
    std::conditional_t<n == std::dynamic_extent, Eigen::Map<Matrix>, Eigen::Matrix<double, rows_of<n>, rows_of<n>>>;

/// n numbers of one face: an array, or what is kept of a vector.
template <class T, std::size_t n>
class PerCorner {
public:
    explicit PerCorner(std::vector<T>&) {}
    void resize(std::size_t) {}
    std::array<T, n>& operator*() { return values_; }

private:
    std::array<T, n> values_;
};
template <class T>
class PerCorner<T, std::dynamic_extent> {
public:
    explicit PerCorner(std::vector<T>& kept) : values_(kept) {}
    void resize(std::size_t size) { values_.resize(size); }
    std::vector<T>& operator*() { return values_; }

private:
    std::vector<T>& values_;
};

/// Adds the matrices of faces to that of a mesh, one face after the other, each into the places that the pattern has
/// for it.
///
/// A kernel is called as Status kernel(const Face<n>&, LocalMatrix<n>&, std::span<double, n> masses), for n = 3, n = 4
/// and std::dynamic_extent. It fills the matrix, and may change what its corners add to the diagonal of the mass, which
/// begins as the share of the lumped mass. Its error need not name the face.
template <class Kernel>
class FaceSum {
public:
    /// @param out has the pattern, and a diagonal mass
    FaceSum(const PolygonMesh& mesh, const FacePairs& pairs, Kernel& kernel, OperatorMatrices& out)
        : mesh_(mesh),
          pairs_(pairs),
          place_(pairs.places.data()),
          kernel_(kernel),
          values_(out.stiffness.valuePtr()),
          masses_(out.mass.valuePtr()) {}

    Status add(std::span<const Index> vertices) {
        switch (vertices.size()) {
            case 3:
                return add_whole<3>(vertices.first<3>());
            case 4:
                return add_whole<4>(vertices.first<4>());
            default:
                return add_whole<std::dynamic_extent>(vertices);
        }
    }

    /// Of a face that the pattern has as `parts` triangles, each given by the numbers of its corners: the kernel is
    /// called as kernel.begin(face, masses) and, for each part, kernel.part(face, part, masses), which returns its
    /// matrix.
    Status add_in_parts(std::span<const Index> vertices, std::span<const std::array<Index, 3>> parts) {
        return with_face(vertices, [&](const auto& face, std::span<double> shares) -> Status {
            kernel_.begin(face, shares);
            for (const auto& part : parts) {
                const auto vertex = [&](std::size_t k) { return vertices[static_cast<std::size_t>(part[k])]; };
                const std::array<Index, 3> own{vertex(0), vertex(1), vertex(2)};
                const LocalMatrix<3> s = kernel_.part(face, part, shares);
                if (Status status = scatter<3>(own, s); !status) return status;
            }
            return Done{};
        });
    }

private:
    template <std::size_t n>
    inline Status add_whole(std::span<const Index, n> vertices) {
        return with_face(vertices, [&](const Face<n>& face, std::span<double, n> shares) -> Status {
            if constexpr (n == std::dynamic_extent) {
                local_.assign(square(vertices.size()), 0.0);
                const auto size = static_cast<Eigen::Index>(vertices.size());
                LocalMatrix<n> s(local_.data(), size, size);
                if (Status status = kernel_(face, s, shares); !status) return status;
                return scatter(vertices, s);
            } else {
                LocalMatrix<n> s = LocalMatrix<n>::Zero();
                if (Status status = kernel_(face, s, shares); !status) return status;
                return scatter(vertices, s);
            }
        });
    }

    /// Calls `visit` with the face and its corners' shares of the mass, and adds these.
    template <std::size_t n, class Visit>
    inline Status with_face(std::span<const Index, n> vertices, Visit&& visit) {
        PerCorner<Vector3, n> corners(corners_);
        PerCorner<double, n> shares(shares_);
        corners.resize(vertices.size());
        shares.resize(vertices.size());
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            (*corners)[k] = mesh_.position(vertices[k]);
        }
        const std::span<const Vector3, n> x(*corners);
        Face<n> face{vertices, x, vector_area_of(x), 0};
        face.area = safe_norm(face.vector_area);
        if (is_zero_area(x, face.area)) return Error{ErrorCode::degenerate_face, "its vector area is zero"};
        for (double& share : *shares) {
            share = face.area / static_cast<double>(vertices.size());
        }
        if (Status status = visit(face, std::span<double, n>(*shares)); !status) return status;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            masses_[vertices[i]] += (*shares)[i];
        }
        return Done{};
    }

    template <std::size_t n>
    inline Status scatter(std::span<const Index, n> vertices, const LocalMatrix<n>& s) {
        if (!s.allFinite()) {
            return Error{ErrorCode::degenerate_face, "its matrix is not finite, the face is too thin or too large"};
        }
        const std::size_t size = vertices.size();
        const std::uint8_t* place = std::exchange(place_, place_ + size * size);
        PerCorner<double*, n> columns(columns_);
        columns.resize(size);
        for (std::size_t j = 0; j < size; ++j) {
            (*columns)[j] = values_ + pairs_.offsets[static_cast<std::size_t>(vertices[j])];
        }
        for (std::size_t i = 0; i < size; ++i) {
            for (std::size_t j = 0; j < size; ++j, ++place) {
                const std::size_t row = *place < FacePairs::far ? *place : pairs_.search(vertices[j], vertices[i]);
                (*columns)[j][row] += s(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            }
        }
        return Done{};
    }

    const PolygonMesh& mesh_;
    const FacePairs& pairs_;
    const std::uint8_t* place_;
    Kernel& kernel_;
    double* values_;
    double* masses_;
    std::vector<Vector3> corners_;
    std::vector<double> shares_;
    std::vector<double> local_;
    std::vector<double*> columns_;
};

/// Calls `visit`, a Status of a face's number, for all faces, with ticks; names the face in its errors.
template <class Visit>
Status for_faces(const PolygonMesh& mesh, Monitor monitor, Visit&& visit) {
    // Ticks are rare enough to cost nothing and often enough to feel at once.
    constexpr Index faces_per_tick = 4096;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        if (f % faces_per_tick == 0 && !monitor.proceed(static_cast<double>(f) / mesh.face_count())) {
            return Error{ErrorCode::cancelled, "cancelled"};
        }
        if (Status status = visit(f); !status) {
            return Error{status.error().code, "face " + std::to_string(f) + ": " + status.error().message, f};
        }
    }
    return Done{};
}

/// Sums the matrices of all faces, and the mass: the one gather/scatter loop behind every operator that is a sum over
/// faces. The pattern depends on the connectivity alone: all pairs of corners of a face have an entry, be it 0.
/// @param out memory that is there is used again
/// @error what the kernel says, with the face; degenerate_face where a face has no vector area, or its matrix is not
/// finite; cancelled, out_of_memory
template <class Kernel>
Status assemble_faces(const PolygonMesh& mesh, Kernel&& kernel, OperatorMatrices& out, Monitor monitor) {
    return guard_memory([&]() -> Status {
        Stretch pairing{monitor, 0, 0.4};
        Stretch summing{monitor, 0.4, 1};
        const auto pairs = face_pairs(*mesh.connectivity(), pairing.monitor());
        if (!pairs) return pairs.error();
        set_pattern(**pairs, out.stiffness);
        set_diagonal(mesh.vertex_count(), out.mass);
        FaceSum<std::remove_reference_t<Kernel>> sum(mesh, **pairs, kernel, out);
        return for_faces(mesh, summing.monitor(), [&](Index f) { return sum.add(mesh.face(f)); });
    });
}

/// The stiffness alone of what `build`, a Status of OperatorMatrices&, makes.
template <class Build>
Result<SparseMatrix> stiffness_of(Build&& build) {
    return guard_memory([&]() -> Result<SparseMatrix> {
        OperatorMatrices matrices;
        if (Status status = build(matrices); !status) return status.error();
        return matrices.stiffness;
    });
}

}  // namespace polylap

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/square.hpp"
#include "polylap/base/monitor.hpp"
#include "polylap/face/vector_area.hpp"
#include "polylap/mesh/polygon_mesh.hpp"

namespace polylap {

/// n×n, column-major, all zero when a face begins.
using LocalMatrix = Eigen::Map<Matrix>;

/// Sums the local matrices of all faces: the one gather/scatter loop behind every operator that is a sum over faces.
/// @param local Status(std::span<const Index> vertices, Corners, LocalMatrix&): fills the matrix of one face; its error
///              need not name the face
/// @error what `local` says, with the face; degenerate_face where a local matrix is not finite; cancelled,
/// out_of_memory
template <class Local>
Result<SparseMatrix> assemble_faces(const PolygonMesh& mesh, Monitor monitor, Local&& local) {
    return guard_memory([&]() -> Result<SparseMatrix> {
        // Ticks are rare enough to cost nothing and often enough to feel at once.
        constexpr Index faces_per_tick = 4096;
        const auto fail = [](Index f, ErrorCode code, const std::string& why) {
            return Error{code, "face " + std::to_string(f) + ": " + why, f};
        };
        std::vector<Eigen::Triplet<double, Index>> entries;
        std::vector<Vector3> corners;
        std::vector<double> buffer;
        for (Index f = 0; f < mesh.face_count(); ++f) {
            if (f % faces_per_tick == 0 && !monitor.proceed(static_cast<double>(f) / mesh.face_count())) {
                return Error{ErrorCode::cancelled, "cancelled"};
            }
            const auto face = mesh.face(f);
            const auto n = static_cast<Index>(face.size());
            gather_corners(mesh, f, corners);
            buffer.assign(square(face.size()), 0.0);
            LocalMatrix matrix(buffer.data(), n, n);
            if (Status status = local(face, Corners(corners), matrix); !status) {
                return fail(f, status.error().code, status.error().message);
            }
            if (!matrix.allFinite()) {
                return fail(f, ErrorCode::degenerate_face,
                            "its matrix is not finite, the face is too thin or too large");
            }
            for (Index j = 0; j < n; ++j) {
                for (Index i = 0; i < n; ++i) {
                    if (i != j && matrix(i, j) == 0) continue;  // corners that the operator does not join
                    entries.emplace_back(face[static_cast<std::size_t>(i)], face[static_cast<std::size_t>(j)],
                                         matrix(i, j));
                }
            }
        }
        SparseMatrix sum(mesh.vertex_count(), mesh.vertex_count());
        sum.setFromTriplets(entries.begin(), entries.end());
        return sum;
    });
}

}  // namespace polylap

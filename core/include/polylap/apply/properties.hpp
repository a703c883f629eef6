#pragma once

#include <string>
#include <vector>

#include "polylap/apply/diagnostics.hpp"

namespace polylap {

/// One property, measured on one mesh.
struct Measurement {
    enum class Verdict : std::uint8_t { holds, fails, not_measured };
    const PropertyInfo* property = nullptr;
    Verdict verdict = Verdict::not_measured;
    double value = 0;             ///< The violation: 0 where it holds exactly; what it counts, the text says.
    std::string text;             ///< For people, e.g. "2048 of 4096 ordered pairs, worst -0.52 between 3 and 17".
    std::vector<Index> vertices;  ///< The offending place: one vertex, or the pair of the worst entry; empty: none.
};

/// What check_properties finds.
struct PropertyReport {
    std::vector<Measurement> measurements;  ///< In the order of the property table; convergence is not measured here.
    Index negative_ordered = 0;             ///< Negative weights over ordered pairs.
    Index negative_pairs = 0;               ///< … and over unordered ones.
    double smallest_eigenvalue = 0;         ///< Of (S + Sᵀ)/2.
    double largest_eigenvalue = 0;
    Index components = 0;         ///< Connected parts of the mesh: the kernel of a Laplacian of their constants.
    Index kernel_dimension = 0;   ///< Eigenvalues within kernel_tolerance of 0, relative to the largest.
    bool kernel_complete = true;  ///< False: there may be more than the kernel_limit that were looked for.
    Matrix kernel_modes;          ///< V×k, orthonormal, rows of unreferenced vertices 0.
    /// Largest over smallest nonzero |eigenvalue| (singular value, if S is not symmetric); infinite if none is known.
    double condition = 0;
    double smallest_mass = 0;  ///< Least diagonal entry of M over the referenced vertices, length².
    Index smallest_mass_vertex = -1;
};

inline constexpr double kernel_tolerance = 1e-9;
inline constexpr Index kernel_limit = 64;
/// (S x)ᵢ at most this multiple of the sum of its terms' lengths is rounding.
inline constexpr double linear_tolerance = 1e-9;
/// Values beyond the range of the fixed ones by at most this multiple of its width are rounding.
inline constexpr double range_tolerance = 1e-9;

/// Measures the properties of an operator on a mesh (Wardetzky et al. 2007).
/// - Sym, Loc, Pos and S 1 = 0 beyond weight_tolerance of the largest diagonal entry.
/// - Psd: the smallest eigenvalue of (S + Sᵀ)/2 beyond kernel_tolerance of the largest.
/// - Lin: the largest |Σ S_ij (x_j - x_i)| over flat inner vertices, relative to Σ |S_ij| |x_j - x_i|, beyond
///   linear_tolerance. Entries within weight_tolerance do not enter, and a vertex that S joins to others off its plane
///   does not count.
/// - Max: the harmonic functions that are 1 at one fixed vertex and 0 at the others. Fixed is the boundary; on a closed
///   component up to 16 vertices far apart. All of these functions where vertices × fixed vertices ≤ 2 million, which
///   is exact: if none leaves [0, 1] (and constants stay), no boundary data does. Otherwise 64 of them, half next to
///   the worst negative weights, half spread evenly, and the coordinates; the text says so. On a closed component any
///   vertices may be the boundary: there also those that are 1 at one neighbour j of a vertex i (S_ij ≠ 0) and 0 at
///   its others, hence -S_ij / S_ii at i.
/// - Kernel: of (S + Sᵀ)/2 if S is symmetric and has no negative eigenvalue, else of SᵀS; the constants of the
///   components come first where they belong to it.
/// @error bad_argument (sizes that do not fit), cancelled, out_of_memory; another failure of a solver leaves its
/// measurement not_measured with the reason
Result<PropertyReport> check_properties(const PolygonMesh& mesh, const Topology& topology,
                                        const OperatorMatrices& matrices, Monitor monitor = {});

/// Vertices off the boundary all of whose faces lie in one plane (relative to their size) and face the same way.
std::vector<Index> flat_inner_vertices(const PolygonMesh& mesh, const Topology& topology);

}  // namespace polylap

// Smallest and largest eigenvalue, kernel and condition.

#include <cmath>
#include <limits>

#include <Eigen/QR>
#include <Eigen/SVD>

#include "apply/measure.hpp"
#include "polylap/solve/eigenpairs.hpp"

namespace polylap {
namespace {

/// Vertices in no face have no equation: the matrices of this file leave them out.
struct Referenced {
    std::vector<Index> vertices;
    std::vector<Index> local;  ///< V; -1: in no face.

    explicit Referenced(const Topology& topology) : local(topology.component.size(), -1) {
        for (std::size_t v = 0; v < local.size(); ++v) {
            if (topology.component[v] < 0) continue;
            local[v] = static_cast<Index>(vertices.size());
            vertices.push_back(static_cast<Index>(v));
        }
    }
    Index size() const { return static_cast<Index>(vertices.size()); }

    SparseMatrix restrict_to(const SparseMatrix& a) const {
        std::vector<Eigen::Triplet<double, Index>> entries;
        entries.reserve(static_cast<std::size_t>(a.nonZeros()));
        for (const Index column : vertices) {
            for (SparseMatrix::InnerIterator it(a, column); it; ++it) {
                const Index row = local[static_cast<std::size_t>(it.index())];
                if (row >= 0) entries.emplace_back(row, local[static_cast<std::size_t>(column)], it.value());
            }
        }
        SparseMatrix restricted(size(), size());
        restricted.setFromTriplets(entries.begin(), entries.end());
        return restricted;
    }

    Points positions(const PolygonMesh& mesh) const { return mesh.positions()(vertices, Eigen::all); }

    Matrix extend(const Matrix& rows) const {
        Matrix all = Matrix::Zero(static_cast<Eigen::Index>(local.size()), rows.cols());
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            all.row(vertices[k]) = rows.row(static_cast<Eigen::Index>(k));
        }
        return all;
    }
};

/// The low end of a spectrum, as far as it takes to see where the kernel ends.
struct LowEnd {
    Eigenpairs pairs;
    double largest = 0;
    Index kernel = 0;      ///< How many of the values are 0.
    bool complete = true;  ///< The value after them is known, or there is none.
};

/// @param positions of the rows, for the factor
/// @param zeros     Index(const LowEnd&): how many of the pairs found belong to the kernel
template <class CountZeros>
Result<LowEnd> find_low_end(const SparseMatrix& a, const Points& positions, Index first_count, Monitor monitor,
                            CountZeros&& zeros) {
    const auto n = static_cast<Index>(a.rows());
    LowEnd low;
    Stretch begin{monitor, 0, 0.3};
    const auto largest = largest_eigenvalue(a, begin.monitor());
    if (!largest) return largest.error();
    low.largest = *largest;
    const Index most = std::min(n, kernel_limit + 1);
    double done = 0.3;
    for (Index count = std::min(first_count, most);; count = std::min(2 * count, most)) {
        Stretch stretch{monitor, done, done + 0.5 * (1 - done)};
        auto pairs = lowest_eigenpairs(a, count, stretch.monitor(), positions);
        if (!pairs) return pairs.error();
        done = stretch.to;
        low.pairs = *std::move(pairs);
        low.kernel = zeros(low);
        if (low.kernel < count || count == most) break;
    }
    const auto found = static_cast<Index>(low.pairs.values.size());
    low.complete = low.kernel <= kernel_limit && (low.kernel < found || found == n);
    low.kernel = std::min(low.kernel, kernel_limit);
    return low;
}

/// An orthonormal basis of the same space that begins with the constants of the components, where they belong to it,
/// so that the rest shows what does not belong; each mode's largest entry is positive.
Matrix constants_first(const Matrix& modes, const Referenced& referenced, const Topology& topology) {
    Matrix constants = Matrix::Zero(modes.rows(), topology.component_count);
    for (Index k = 0; k < referenced.size(); ++k) {
        constants(k, topology.component[static_cast<std::size_t>(referenced.vertices[static_cast<std::size_t>(k)])]) =
            1;
    }
    constants.colwise().normalize();
    constexpr double within = 1e-6;  // what eigenvectors may be off by
    const Matrix strayed = constants - modes * (modes.transpose() * constants);
    if (constants.cols() > modes.cols() || (constants.cols() > 0 && strayed.colwise().norm().maxCoeff() > within)) {
        constants.resize(modes.rows(), 0);
    }
    Matrix basis(modes.rows(), modes.cols());
    basis.leftCols(constants.cols()) = constants;
    const auto rest = modes.cols() - constants.cols();
    if (rest > 0) {
        const Matrix others = modes - constants * (constants.transpose() * modes);
        const Eigen::ColPivHouseholderQR<Matrix> qr(others);
        basis.rightCols(rest) = qr.householderQ() * Matrix::Identity(modes.rows(), rest);
    }
    for (Eigen::Index k = 0; k < basis.cols(); ++k) {
        Eigen::Index largest = 0;
        basis.col(k).cwiseAbs().maxCoeff(&largest);
        if (basis(largest, k) < 0) basis.col(k) *= -1;
    }
    return basis;
}

Measurement unsolved(const Error& error, PropertyReport& report) {
    report.smallest_eigenvalue = report.largest_eigenvalue = std::numeric_limits<double>::quiet_NaN();
    report.condition = std::numeric_limits<double>::infinity();
    report.kernel_complete = false;
    return not_measured(error.message);
}

}  // namespace

Result<Measurement> measure_spectrum(const Subject& subject, bool symmetric, PropertyReport& report, Monitor monitor) {
    const Referenced referenced(subject.topology);
    const Index n = referenced.size();
    report.kernel_modes.resize(subject.mesh.vertex_count(), 0);
    report.condition = std::numeric_limits<double>::infinity();
    const SparseMatrix s = referenced.restrict_to(subject.stiffness());
    if (n == 0) return not_measured("there are no vertices");
    const SparseMatrix even = 0.5 * (s + SparseMatrix(s.transpose()));
    const Index first_count = std::min(kernel_limit, subject.topology.component_count) + 6;

    const Points positions = referenced.positions(subject.mesh);
    Stretch first{monitor, 0, 0.5};
    const auto low = find_low_end(even, positions, first_count, first.monitor(), [](const LowEnd& end) {
        return static_cast<Index>((end.pairs.values.array() <= kernel_tolerance * end.largest).count());
    });
    if (!low) {
        if (ends_check(low.error())) return low.error();
        return unsolved(low.error(), report);
    }
    report.smallest_eigenvalue = low->pairs.values[0];
    report.largest_eigenvalue = low->largest;
    const bool semidefinite = report.smallest_eigenvalue >= -kernel_tolerance * std::abs(low->largest);

    Matrix modes;
    double extreme = low->largest;
    double smallest = 0;
    if (symmetric && semidefinite) {
        report.kernel_dimension = low->kernel;
        report.kernel_complete = low->complete;
        modes = low->pairs.vectors.leftCols(low->kernel);
        if (low->kernel < static_cast<Index>(low->pairs.values.size())) smallest = low->pairs.values[low->kernel];
    } else {
        // Squares cannot tell values below the root of rounding apart: S itself, on the space they single out, does.
        Vector singular;
        Matrix turned;
        const SparseMatrix product = SparseMatrix(s.transpose()) * s;
        const SparseMatrix squared = 0.5 * (product + SparseMatrix(product.transpose()));
        Stretch second{monitor, 0.5, 1};
        const auto ends = find_low_end(squared, positions, first_count, second.monitor(), [&](const LowEnd& end) {
            const Matrix image = s * end.pairs.vectors;
            const Eigen::JacobiSVD<Matrix, Eigen::HouseholderQRPreconditioner> svd(
                image, Eigen::ComputeThinU | Eigen::ComputeThinV);
            singular = svd.singularValues().reverse();
            turned = end.pairs.vectors * svd.matrixV().rowwise().reverse();
            return static_cast<Index>((singular.array() <= kernel_tolerance * std::sqrt(end.largest)).count());
        });
        if (!ends) {
            if (ends_check(ends.error())) return ends.error();
            return unsolved(ends.error(), report);
        }
        extreme = std::sqrt(ends->largest);
        report.kernel_dimension = ends->kernel;
        report.kernel_complete = ends->complete;
        modes = turned.leftCols(ends->kernel);
        if (ends->kernel < static_cast<Index>(singular.size())) smallest = singular[ends->kernel];
    }
    if (modes.cols() > 0) {
        report.kernel_modes = referenced.extend(constants_first(modes, referenced, subject.topology));
    }
    if (report.kernel_complete && smallest > 0) report.condition = extreme / smallest;

    const double ratio = report.smallest_eigenvalue / std::max(std::abs(low->largest), std::abs(low->pairs.values[0]));
    std::string text = "the smallest eigenvalue is " + figure(report.smallest_eigenvalue) + ", the largest " +
                       figure(report.largest_eigenvalue);
    if (semidefinite) return measured(true, std::max(0.0, -ratio), std::move(text), {});
    Eigen::Index row = 0;
    low->pairs.vectors.col(0).cwiseAbs().maxCoeff(&row);
    const Index v = referenced.vertices[static_cast<std::size_t>(row)];
    return measured(false, -ratio, text + "; its eigenfunction is largest at " + vertex_name(v), {v});
}

}  // namespace polylap

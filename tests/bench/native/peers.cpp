#include "peers.hpp"

// MetisSupport uses std::cerr without saying so.
#include <iostream>

#include <cholmod.h>
#include <Eigen/MetisSupport>
#include <Eigen/SparseCholesky>

#include "polylap/solve/spd_factor.hpp"
#include "solve/dense/kernels.hpp"
#include "solve/supernodal/numeric.hpp"
#include "solve/supernodal/symbolic.hpp"

extern "C" char* openblas_get_config(void);

namespace polylap::bench {
namespace {

/// Solves for one and for all right-hand sides.
template <class Solve>
void measure_solve(const System& system, Record& record, Solve&& solve) {
    const Matrix first = system.rhs.leftCols(1);
    const Matrix one = record.time("solve 1", [&] { return solve(first); });
    const Matrix all = record.time("solve 3", [&] { return solve(system.rhs); });
    require_solves(system.a, one, first);
    require_solves(system.a, all, system.rhs);
}

template <class Order>
void run_eigen(const System& system, Record& record) {
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Order> ldlt;
    record.time("analyse", [&] { return ldlt.analyzePattern(system.a), true; });
    record.time("numeric", [&] { return ldlt.factorize(system.a), true; });
    require(ldlt.info() == Eigen::Success, "Eigen could not factor");
    const auto entries = ldlt.matrixL().nestedExpression().nonZeros() + system.a.rows();
    record.add("nnz(L)", "", static_cast<double>(entries));
    measure_solve(system, record, [&](const Matrix& b) { return Matrix(ldlt.solve(b)); });
}

/// CHOLMOD's views of Eigen's matrices.
cholmod_sparse view_of(const SparseMatrix& a) {
    cholmod_sparse view{};
    view.nrow = static_cast<std::size_t>(a.rows());
    view.ncol = static_cast<std::size_t>(a.cols());
    view.nzmax = static_cast<std::size_t>(a.nonZeros());
    view.p = const_cast<Index*>(a.outerIndexPtr());
    view.i = const_cast<Index*>(a.innerIndexPtr());
    view.x = const_cast<double*>(a.valuePtr());
    view.stype = -1;  // the lower triangle
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
}

cholmod_dense view_of(const Matrix& b) {
    cholmod_dense view{};
    view.nrow = static_cast<std::size_t>(b.rows());
    view.ncol = static_cast<std::size_t>(b.cols());
    view.nzmax = static_cast<std::size_t>(b.size());
    view.d = static_cast<std::size_t>(b.rows());
    view.x = const_cast<double*>(b.data());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    return view;
}

}  // namespace

void run_polylap(const System& system, Record& record) {
    SpdFactor factor;
    opened(record.time("analyse", [&] { return factor.analyse(system.a, system.positions); }));
    opened(record.time("numeric", [&] { return factor.factor(system.a); }));
    record.add("nnz(L)", "", static_cast<double>(factor.analysis()->factor_entries()));
    record.add("flops", "", factor.analysis()->factor_flops());
    measure_solve(system, record, [&](const Matrix& b) { return opened(factor.solve(b)); });
}

void run_polylap_baseline(const System& system, Record& record) {
    const Symbolic symbolic =
        opened(record.time("analyse", [&] { return analyse_pattern(system.a, system.positions, {}); }));
    Numeric numeric(*dense::kernels().back());
    opened(record.time("numeric", [&] { return numeric.factor(symbolic, system.a, {}); }));
    record.add("nnz(L)", "", static_cast<double>(symbolic.entries));
    measure_solve(system, record, [&](const Matrix& b) { return numeric.solve(symbolic, b); });
}

std::string kernels_name() {
    return dense::kernels().front()->name;
}

void run_eigen_ldlt(const System& system, Ordering ordering, Record& record) {
    if (ordering == Ordering::amd) {
        run_eigen<Eigen::AMDOrdering<Index>>(system, record);
    } else {
        run_eigen<Eigen::MetisOrdering<Index>>(system, record);
    }
}

void run_cholmod(const System& system, Ordering ordering, bool supernodal, Record& record) {
    cholmod_common common;
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = supernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
    common.nmethods = 1;
    common.method[0].ordering = ordering == Ordering::amd ? CHOLMOD_AMD : CHOLMOD_METIS;
    common.postorder = 1;
    cholmod_sparse a = view_of(system.a);
    cholmod_factor* factor = record.time("analyse", [&] { return cholmod_analyze(&a, &common); });
    require(factor != nullptr, "CHOLMOD could not analyse");
    record.add("nnz(L)", "", common.lnz);
    record.time("numeric", [&] { return cholmod_factorize(&a, factor, &common); });
    require(common.status == CHOLMOD_OK, "CHOLMOD could not factor");
    measure_solve(system, record, [&](const Matrix& b) {
        cholmod_dense view = view_of(b);
        cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor, &view, &common);
        require(x != nullptr, "CHOLMOD could not solve");
        Matrix solution = Eigen::Map<const Matrix>(static_cast<const double*>(x->x), b.rows(), b.cols());
        cholmod_free_dense(&x, &common);
        return solution;
    });
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
}

std::vector<std::string> peer_versions() {
    const auto version = [](int major, int minor, int patch) {
        return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
    };
    return {"Eigen " + version(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION),
            "CHOLMOD " + version(CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION),
            "METIS " + version(METIS_VER_MAJOR, METIS_VER_MINOR, METIS_VER_SUBMINOR), openblas_get_config()};
}

}  // namespace polylap::bench

#pragma once

#include <string>
#include <vector>

#include "harness.hpp"

// The Cholesky factorisations that polylap is measured against. All of them, and polylap, record: analyse (ordering and
// symbolic analysis), numeric, solve 1, solve 3 (right-hand sides) and nnz(L) with the diagonal, and have to solve the
// system.
namespace polylap::bench {

struct System {
    SparseMatrix a;  ///< n×n, symmetric positive definite, stored in full.
    Points positions;
    Matrix rhs;  ///< n×3
};

enum class Ordering : std::uint8_t { amd, metis };

void run_polylap(const System& system, Record& record);
/// With the kernels that any processor of this kind can run, whatever its extensions.
void run_polylap_baseline(const System& system, Record& record);
void run_eigen_ldlt(const System& system, Ordering ordering, Record& record);
void run_cholmod(const System& system, Ordering ordering, bool supernodal, Record& record);

/// The instruction set that polylap's kernels use here.
std::string kernels_name();
/// E.g. "CHOLMOD 3.0.14".
std::vector<std::string> peer_versions();

}  // namespace polylap::bench

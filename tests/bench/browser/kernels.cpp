// The core's work in one piece, timed: the same source natively (prints JSON) and in WebAssembly (returns it), so that
// their ratio compares compilers and engines, not programs.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <string>

#include <Eigen/SparseCholesky>

#include "polylap/apply/noise.hpp"
#include "polylap/mesh/shapes.hpp"
#include "polylap/operators/operator.hpp"
#include "polylap/solve/spd_factor.hpp"
#include "solve/supernodal/numeric.hpp"

#ifdef __EMSCRIPTEN__
#include <emscripten/emscripten.h>
#endif

namespace {

using namespace polylap;

/// Milliseconds: of the processor where it can be had, so that other programs do not count.
double now() {
#ifdef __EMSCRIPTEN__
    return emscripten_get_now();
#else
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
#endif
}

/// The first time and the shortest of the later ones.
struct Times {
    double first = 0;
    double again = std::numeric_limits<double>::infinity();
};

template <class Work>
Times timed(int repeats, Work&& work) {
    Times times;
    for (int k = 0; k <= repeats; ++k) {
        const double start = now();
        work();
        const double took = now() - start;
        if (k == 0)
            times.first = took;
        else
            times.again = std::min(times.again, took);
    }
    return times;
}

class Report {
public:
    explicit Report(Index n) : n_(n) {}

    void add(const std::string& name, const char* unit, double value) {
        char line[256];
        std::snprintf(line, sizeof line, R"(%s{"name":"%s","n":%d,"unit":"%s","value":%.6g})", text_.empty() ? "" : ",",
                      name.c_str(), n_, unit, value);
        text_ += line;
    }
    void add(const std::string& name, const Times& times) {
        add(name + ", first", "ms", times.first);
        if (std::isfinite(times.again)) add(name, "ms", times.again);
    }
    std::string json() const { return "[" + text_ + "]"; }

private:
    Index n_;
    std::string text_;
};

/// Assembly, factor and solution of one smoothing step on a noisy torus of nu × nv quads.
/// @param peer also what peers use: Eigen's simplicial factor, ordered by AMD
std::string measure(int nu, int nv, int repeats, bool peer) {
    const auto torus = make_torus(nu, nv);
    if (!torus) return "[]";
    const auto mesh = add_normal_noise(*torus, 0.1, 1);
    if (!mesh) return "[]";
    const auto spec = make_spec("alexa-wardetzky", {});
    if (!spec) return "[]";
    Report report(mesh->vertex_count());

    auto built = build_operator(*mesh, *spec);
    const auto moved = mesh->with_positions(1.5 * mesh->positions());
    report.add("assembly", timed(repeats, [&] { built = build_operator(*moved, *spec); }));
    if (!built) return "[]";

    const double time = 10.0 / mesh->vertex_count();
    SparseMatrix system = built->mass + time * built->stiffness;
    system.makeCompressed();
    const Matrix rhs = built->mass * mesh->positions();

    SpdFactor factor;
    bool good = true;
    report.add("analysis",
               timed(std::min(repeats, 1), [&] { good = good && factor.analyse(system, mesh->positions()); }));
    report.add("factor", timed(repeats, [&] { good = good && factor.factor(system); }));
    Result<Matrix> solution = Matrix();
    report.add("solve", timed(repeats, [&] { solution = factor.solve(rhs); }));
    if (!good || !solution) return "[]";
    report.add("residual", "", (system * *solution - rhs).norm() / rhs.norm());

#ifndef __EMSCRIPTEN__
    // The page's vectors have two lanes and no fused multiply-add; here a machine may have more.
    const auto analysed = analyse_pattern(system, mesh->positions(), {});
    if (!analysed) return "[]";
    Numeric narrow(*dense::kernels().back());
    report.add("factor, two lanes", timed(repeats, [&] { good = good && narrow.factor(*analysed, system, {}); }));
    report.add("solve, two lanes", timed(repeats, [&] { solution = narrow.solve(*analysed, rhs); }));
    if (!good) return "[]";
#endif

    if (peer) {
        Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>> ldlt;
        report.add("Eigen analysis", timed(std::min(repeats, 1), [&] { ldlt.analyzePattern(system); }));
        report.add("Eigen factor", timed(repeats, [&] { ldlt.factorize(system); }));
        Matrix theirs;
        report.add("Eigen solve", timed(repeats, [&] { theirs = ldlt.solve(rhs); }));
        report.add("difference", "", (theirs - *solution).norm() / theirs.norm());
    }
    return report.json();
}

}  // namespace

#ifdef __EMSCRIPTEN__
extern "C" EMSCRIPTEN_KEEPALIVE const char* measure_torus(int nu, int nv, int repeats, int peer) {
    static std::string last;
    last = measure(nu, nv, repeats, peer != 0);
    return last.c_str();
}
#else
int main(int argc, char** argv) {
    if (argc != 5) return 2;
    std::puts(measure(std::atoi(argv[1]), std::atoi(argv[2]), std::atoi(argv[3]), std::atoi(argv[4]) != 0).c_str());
}
#endif

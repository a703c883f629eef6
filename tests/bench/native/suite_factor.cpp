#include "meshes.hpp"
#include "suites.hpp"
#include "systems.hpp"

namespace polylap::bench {

void run_factor(Bench& bench) {
    if (!bench.wants("factor")) return;
    for (const Shape& shape : factor_shapes) {
        // All peers on the first shape; on the others those that stand for their kind, and for as long as they are
        // quick.
        const bool first = &shape == factor_shapes;
        for (const Index n : bench.sizes({1000, 10'000, 100'000, 250'000, 1'000'000})) {
            if (n == 250'000 && !first) continue;
            const System system = smoothing_system(shape.make(n));
            const bool large = n > 500'000;
            const bool small = n <= 10'000;
            const int rounds = small ? 9 : large ? 2 : 3;
            const int slow_rounds = large ? 1 : rounds;
            std::vector<Contender> contenders{
                {"polylap", [&](Record& record) { run_polylap(system, record); }, rounds, small}};
            const auto add_eigen = [&](const char* item, Ordering ordering) {
                contenders.push_back({item,
                                      [&system, ordering](Record& record) { run_eigen_ldlt(system, ordering, record); },
                                      slow_rounds, small});
            };
            const auto add_cholmod = [&](const char* item, Ordering ordering, bool supernodal) {
                contenders.push_back({item,
                                      [&system, ordering, supernodal](Record& record) {
                                          run_cholmod(system, ordering, supernodal, record);
                                      },
                                      supernodal ? rounds : slow_rounds, small});
            };
            if (first || !large) add_eigen("Eigen LDLT, AMD", Ordering::amd);
            add_cholmod("CHOLMOD supernodal, AMD", Ordering::amd, true);
            if (first) {
                contenders.push_back({"polylap, baseline kernels",
                                      [&](Record& record) { run_polylap_baseline(system, record); }, rounds, small});
                add_eigen("Eigen LDLT, METIS", Ordering::metis);
                add_cholmod("CHOLMOD simplicial, AMD", Ordering::amd, false);
                add_cholmod("CHOLMOD supernodal, METIS", Ordering::metis, true);
            }
            bench.measure("factor", shape.name, static_cast<Index>(system.a.rows()), contenders);
        }
    }
}

}  // namespace polylap::bench

// polylap_bench [--smallest] [--largest VERTICES] [--only GROUP] [--json FILE]: measures polylap and its peers, one
// thread, CPU time.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string_view>

#include "machine.hpp"
#include "suites.hpp"

extern "C" void openblas_set_num_threads(int count);

int main(int count, char** arguments) {
    using namespace polylap::bench;
    openblas_set_num_threads(1);
    Options options;
    std::string json;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--smallest") {
            options.smallest = true;
        } else if (argument == "--largest" && i + 1 < count) {
            options.largest = std::atoi(arguments[++i]);
        } else if (argument == "--only" && i + 1 < count) {
            options.only = arguments[++i];
        } else if (argument == "--json" && i + 1 < count) {
            json = arguments[++i];
        } else {
            std::cerr << "usage: polylap_bench [--smallest] [--largest VERTICES] [--only GROUP] [--json FILE]\n";
            return 2;
        }
    }
    Bench bench(options, std::cout);
    run_assembly(bench);
    run_loading(bench);
    run_steps(bench);
    run_iterative(bench);
    run_pins(bench);
    run_factor(bench);
    if (json.empty()) return 0;
    std::ofstream file(json);
    write_json(bench.rows(), file);
    file.flush();
    require(file.good(), "cannot write " + json);
    return 0;
}

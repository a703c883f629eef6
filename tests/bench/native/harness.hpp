#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "polylap/base/result.hpp"
#include "polylap/base/types.hpp"

namespace polylap::bench {

/// One measured number.
struct Row {
    std::string group, shape;
    Index n = 0;  ///< Vertices or unknowns.
    std::string item, metric, unit;
    double value = 0;
};

/// What one contender measures of itself in one round, in a process of its own.
class Record {
public:
    /// Runs `work` and adds the CPU time of this process, in ms, to what `metric` has so far.
    template <class Work>
    auto time(const char* metric, Work&& work) {
        const double start = cpu_ms();
        auto outcome = std::forward<Work>(work)();
        add(metric, "ms", cpu_ms() - start);
        return outcome;
    }
    /// Runs `work` on each; the quickest counts.
    template <class Range, class Work>
    void quickest(const char* metric, const Range& range, Work&& work) {
        double best = std::numeric_limits<double>::infinity();
        for (const auto& each : range) {
            const double start = cpu_ms();
            work(each);
            best = std::min(best, cpu_ms() - start);
        }
        add(metric, "ms", best);
    }
    void add(const char* metric, const char* unit, double value);

    static double cpu_ms();

    struct Entry {
        std::string metric, unit;
        double value;
    };
    const std::vector<Entry>& entries() const { return entries_; }

private:
    std::vector<Entry> entries_;
};

struct Contender {
    std::string item;
    std::function<void(Record&)> work;
    int rounds = 3;
    bool warm = false;  ///< Once before it counts, in the same process: for what is over before caches are filled.
};

struct Options {
    bool smallest = false;  ///< Only to see that all of it runs: the smallest sizes, one round.
    Index largest = std::numeric_limits<Index>::max();  ///< Vertices, at most: for machines with little time or memory.
    std::string only;                                   ///< Groups whose names contain this.
};

/// Runs contenders against each other, one after the other and round after round, so that noise meets all of them
/// alike. The least of the rounds counts, for times and memory alike. What cannot be measured ends the program.
class Bench {
public:
    Bench(Options options, std::ostream& log) : options_(std::move(options)), log_(log) {}

    bool wants(const std::string& group) const { return group.find(options_.only) != std::string::npos; }
    bool smallest() const { return options_.smallest; }
    /// Which sizes of a rising series are wanted; the first one always.
    std::vector<Index> sizes(std::vector<Index> all) const {
        while (all.size() > 1 && (options_.smallest || all.back() > options_.largest))
            all.pop_back();
        return all;
    }

    /// Each row gets `peak memory` too: by how much the contender's process grew, in MB.
    void measure(const std::string& group, const std::string& shape, Index n, const std::vector<Contender>& contenders);

    const std::vector<Row>& rows() const { return rows_; }

private:
    Options options_;
    std::ostream& log_;
    std::vector<Row> rows_;
};

/// Ends the program with a message where a benchmark would otherwise measure nonsense.
void require(bool good, const std::string& what);

template <class T>
T opened(Result<T> result) {
    require(result.ok(), result.ok() ? "" : result.error().message);
    return std::move(result).value();
}

/// |a x - b| / |b| of the largest column: what every contender has to reach before its time counts.
void require_solves(const SparseMatrix& a, const Matrix& x, const Matrix& b, double tolerance = 1e-9);

}  // namespace polylap::bench

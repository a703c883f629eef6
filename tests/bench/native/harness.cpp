#include "harness.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace polylap::bench {
namespace {

double resident_mb() {
    std::ifstream file("/proc/self/statm");
    double total = 0;
    double resident = 0;
    file >> total >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// A forked child starts with the pages of its parent and counts its own peak from there.
double peak_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
}

std::string read_all(int descriptor) {
    std::string text;
    char buffer[4096];
    for (ssize_t count = 0; (count = read(descriptor, buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<std::size_t>(count));
    return text;
}

std::vector<Record::Entry> run_in_child(const Contender& contender) {
#if defined(__GLIBC__)
    malloc_trim(0);  // else the child would live on what its parent has freed, and seem to need less
#endif
    int ends[2];
    require(pipe(ends) == 0, "no pipe");
    const pid_t child = fork();
    require(child >= 0, "no process");
    if (child == 0) {
        close(ends[0]);
        const double before = resident_mb();
        if (contender.warm) {
            Record ignored;
            contender.work(ignored);
        }
        Record record;
        contender.work(record);
        record.add("peak memory", "MB", std::max(0.0, peak_mb() - before));
        std::ostringstream text;
        text.precision(17);
        for (const auto& [metric, unit, value] : record.entries())
            text << metric << '\t' << unit << '\t' << value << '\n';
        const std::string bytes = text.str();
        const bool written = write(ends[1], bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
        _exit(written ? 0 : 1);
    }
    close(ends[1]);
    const std::string text = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    require(WIFEXITED(status) && WEXITSTATUS(status) == 0, contender.item + " did not end well");
    std::vector<Record::Entry> entries;
    std::istringstream lines(text);
    std::string metric;
    std::string unit;
    std::string value;
    while (std::getline(lines, metric, '\t') && std::getline(lines, unit, '\t') && std::getline(lines, value)) {
        entries.push_back({metric, unit, std::stod(value)});
    }
    return entries;
}

}  // namespace

double Record::cpu_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

void Record::add(const char* metric, const char* unit, double value) {
    const auto known =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.metric == metric; });
    if (known == entries_.end()) {
        entries_.push_back({metric, unit, value});
    } else {
        known->value += value;
    }
}

void Bench::measure(const std::string& group, const std::string& shape, Index n,
                    const std::vector<Contender>& contenders) {
    std::vector<std::vector<Row>> best(contenders.size());
    int rounds = 0;
    for (const Contender& contender : contenders)
        rounds = std::max(rounds, contender.rounds);
    for (int round = 0; round < (options_.smallest ? 1 : rounds); ++round) {
        for (std::size_t c = 0; c < contenders.size(); ++c) {
            if (round >= contenders[c].rounds) continue;
            const auto entries = run_in_child(contenders[c]);
            for (std::size_t e = 0; e < entries.size(); ++e) {
                const auto& [metric, unit, value] = entries[e];
                if (round == 0) {
                    best[c].push_back({group, shape, n, contenders[c].item, metric, unit, value});
                } else {
                    best[c].at(e).value = std::min(best[c].at(e).value, value);
                }
            }
        }
    }
    for (auto& rows : best) {
        for (Row& row : rows) {
            log_ << row.group << " | " << row.shape << ' ' << row.n << " | " << row.item << " | " << row.metric << ": "
                 << row.value << ' ' << row.unit << std::endl;
            rows_.push_back(std::move(row));
        }
    }
}

void require(bool good, const std::string& what) {
    if (good) return;
    std::fprintf(stderr, "polylap_bench: %s\n", what.c_str());
    std::_Exit(1);
}

void require_solves(const SparseMatrix& a, const Matrix& x, const Matrix& b, double tolerance) {
    const Matrix residual = a * x - b;
    for (Eigen::Index k = 0; k < b.cols(); ++k) {
        const double relative = residual.col(k).norm() / b.col(k).norm();
        require(relative <= tolerance, "a solution has a relative residual of " + std::to_string(relative));
    }
}

}  // namespace polylap::bench

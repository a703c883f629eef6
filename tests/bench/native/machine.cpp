#include "machine.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>

#include "peers.hpp"

namespace polylap::bench {
namespace {

/// The first value of a key in a file of `key : value` lines.
std::string look_up(const char* path, const std::string& key) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (line.rfind(key, 0) != 0) continue;
        const auto first = line.find_first_not_of(" \t", line.find(':') + 1);
        if (first != std::string::npos) return line.substr(first);
    }
    return "unknown";
}

std::string quoted(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        if (c >= ' ') quoted += c;
    }
    return quoted + '"';
}

double memory_gb() {
    double kilobytes = 0;
    std::istringstream(look_up("/proc/meminfo", "MemTotal")) >> kilobytes;
    return kilobytes * 1024 / 1e9;
}

std::string compiler() {
#if defined(__clang__)
    return "Clang " __clang_version__;
#elif defined(__GNUC__)
    return "GCC " __VERSION__;
#else
    return "unknown";
#endif
}

}  // namespace

void write_json(const std::vector<Row>& rows, std::ostream& out) {
    std::string libraries;
    for (const std::string& version : peer_versions())
        libraries += (libraries.empty() ? "" : ", ") + quoted(version);
    out << "{\n  \"machine\": {\n    \"processor\": " << quoted(look_up("/proc/cpuinfo", "model name"))
        << ",\n    \"cores\": " << std::thread::hardware_concurrency()
        << ",\n    \"memory\": " << std::lround(memory_gb()) << ",\n    \"compiler\": " << quoted(compiler())
        << ",\n    \"flags\": " << quoted(POLYLAP_BENCH_FLAGS) << ",\n    \"kernels\": " << quoted(kernels_name())
        << ",\n    \"libraries\": [" << libraries << "]\n  },\n  \"rows\": [";
    out.precision(6);
    const char* separator = "\n";
    for (const Row& row : rows) {
        out << separator << "    {\"group\": " << quoted(row.group) << ", \"shape\": " << quoted(row.shape)
            << ", \"n\": " << row.n << ", \"item\": " << quoted(row.item) << ", \"metric\": " << quoted(row.metric)
            << ", \"unit\": " << quoted(row.unit) << ", \"value\": " << row.value << '}';
        separator = ",\n";
    }
    out << "\n  ]\n}\n";
}

}  // namespace polylap::bench

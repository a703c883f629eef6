#include "files.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <random>
#include <system_error>

namespace polylap::tool {
namespace {

namespace fs = std::filesystem;

Error failure(const std::string& what, const std::string& path, int code) {
    return {ErrorCode::bad_argument,
            what + " " + path + (code != 0 ? ": " + std::generic_category().message(code) : ""), -1, -1};
}

/// The file that writing to `path` creates or replaces: absolute, with every link followed.
fs::path target_of(const std::string& path, std::error_code& error) {
    fs::path target = fs::absolute(path, error);
    if (!error) target = fs::weakly_canonical(target, error);
    // A link to what does not exist yet is left over; the limit is that of Linux.
    std::error_code missing;
    for (int links = 0; !error && fs::is_symlink(fs::symlink_status(target, missing)); ++links) {
        if (links == 40) error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
        const fs::path next = error ? fs::path() : fs::read_symlink(target, error);
        if (!error) target = fs::weakly_canonical(target.parent_path() / next, error);
    }
    return target;
}

/// A name beside `target` that nobody else uses.
fs::path temporary_beside(const fs::path& target) {
    std::random_device random;
    std::array<char, 32> suffix{};
    std::snprintf(suffix.data(), suffix.size(), ".%08x%08x.tmp", random(), random());
    fs::path beside = target;
    return beside.replace_filename('.' + target.filename().string() + suffix.data());
}

Status write_stream(std::ostream& stream, const std::string& text, const std::string& path) {
    errno = 0;
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.flush();
    if (!stream) return failure("cannot write", path == "-" ? "standard output" : path, errno);
    return Done{};
}

/// One output on its way: written beside its target, moved there by commit(), gone if that never happens.
class Pending {
public:
    explicit Pending(const Output& output) : output_(output) {}
    Pending(const Pending&) = delete;
    Pending& operator=(const Pending&) = delete;
    ~Pending() {
        std::error_code ignored;
        if (!temporary_.empty()) fs::remove(temporary_, ignored);
    }

    Status prepare() {
        if (output_.path == "-") return Done{};
        std::error_code error;
        const auto status = fs::status(output_.path, error);
        if (fs::is_directory(status)) return failure("cannot write", output_.path, EISDIR);
        if (fs::exists(status) && !fs::is_regular_file(status)) return Done{};
        target_ = target_of(output_.path, error);
        if (error) return failure("cannot write", output_.path, error.value());
        temporary_ = temporary_beside(target_);
        errno = 0;
        std::ofstream stream(temporary_, std::ios::binary);
        if (!stream) {
            const int code = errno;
            temporary_.clear();
            return failure("cannot write", output_.path, code);
        }
        if (fs::exists(status)) fs::permissions(temporary_, status.permissions(), error);
        return write_stream(stream, output_.text, output_.path);
    }

    Status commit() {
        if (output_.path == "-") return write_stream(std::cout, output_.text, "-");
        if (temporary_.empty()) {
            errno = 0;
            std::ofstream stream(output_.path, std::ios::binary);
            return write_stream(stream, output_.text, output_.path);
        }
        std::error_code error;
        fs::rename(temporary_, target_, error);
        if (error) return failure("cannot write", output_.path, error.value());
        temporary_.clear();
        return Done{};
    }

private:
    const Output& output_;
    fs::path target_, temporary_;
};

}  // namespace

Result<std::string> read_file(const std::string& path) {
    std::ifstream file;
    if (path != "-") {
        std::error_code error;
        if (fs::is_directory(path, error)) return failure("cannot read", path, EISDIR);
        errno = 0;
        file.open(path, std::ios::binary);
        if (!file) return failure("cannot read", path, errno);
    }
    std::istream& stream = path == "-" ? std::cin : file;
    std::string text;
    constexpr std::size_t block = 1 << 20;
    do {
        const std::size_t size = text.size();
        text.resize(size + block);
        errno = 0;
        stream.read(text.data() + size, block);
        text.resize(size + static_cast<std::size_t>(stream.gcount()));
    } while (stream);
    if (stream.bad()) return failure("cannot read", path == "-" ? "standard input" : path, errno);
    return text;
}

Status write_outputs(std::span<const Output> outputs) {
    std::vector<std::unique_ptr<Pending>> pending;
    for (const Output& output : outputs) {
        pending.push_back(std::make_unique<Pending>(output));
        if (auto status = pending.back()->prepare(); !status) return status;
    }
    for (const auto& output : pending)
        if (auto status = output->commit(); !status) return status;
    return Done{};
}

bool same_output(const std::string& a, const std::string& b) {
    if (a == "-" || b == "-") return a == b;
    std::error_code a_error, b_error, missing;
    const fs::path a_target = target_of(a, a_error), b_target = target_of(b, b_error);
    return !a_error && !b_error && (a_target == b_target || fs::equivalent(a_target, b_target, missing));
}

}  // namespace polylap::tool

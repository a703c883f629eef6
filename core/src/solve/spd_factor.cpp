#include "polylap/solve/spd_factor.hpp"

#include <bit>
#include <cstdint>
#include <string>
#include <utility>

#include "solve/supernodal/numeric.hpp"
#include "solve/supernodal/symbolic.hpp"

namespace polylap {
namespace {

/// Of where a matrix's entries are: two hashes of 64 bits, which no two patterns share by chance. Keeping the pattern
/// itself would take as much memory as all else that an analysis knows.
struct Fingerprint {
    std::uint64_t first = 0x9e3779b97f4a7c15;
    std::uint64_t second = 0xc2b2ae3d27d4eb4f;

    explicit Fingerprint(const SparseMatrix& a) {
        add(a.outerIndexPtr(), a.outerSize() + 1);
        add(a.innerIndexPtr(), a.nonZeros());
    }
    bool operator==(const Fingerprint&) const = default;

private:
    void add(const Index* indices, Eigen::Index count) {
        const auto word = [&](Eigen::Index k) {
            return static_cast<std::uint64_t>(static_cast<std::uint32_t>(indices[k]));
        };
        Eigen::Index k = 0;
        for (; k + 1 < count; k += 2)
            mix(word(k) << 32 | word(k + 1));
        if (k < count) mix(word(k));
    }
    /// Each step can be undone, so that patterns that differ in one place never meet again by it.
    void mix(std::uint64_t word) {
        first = std::rotl((first ^ word) * 0xff51afd7ed558ccd, 29);
        second = std::rotl((second + word) * 0xd6e8feb86659fd93, 37);
    }
};

}  // namespace

struct SpdAnalysis::Impl {
    Symbolic symbolic;
    Index entries = 0;  ///< Stored in the analysed matrix.
    Fingerprint pattern;
};

SpdAnalysis::SpdAnalysis(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {}
SpdAnalysis::~SpdAnalysis() = default;

Result<std::shared_ptr<const SpdAnalysis>> SpdAnalysis::create(const SparseMatrix& a, const Points& positions,
                                                               Monitor monitor) {
    if (a.rows() != a.cols()) {
        return Error{ErrorCode::bad_argument, "a matrix of " + std::to_string(a.rows()) + "×" +
                                                  std::to_string(a.cols()) + " has no Cholesky factor"};
    }
    if (!a.isCompressed()) return Error{ErrorCode::bad_argument, "the matrix must be compressed"};
    if (positions.rows() != 0 && positions.rows() != a.rows()) {
        return Error{ErrorCode::bad_argument, "the matrix has " + std::to_string(a.rows()) + " rows, but " +
                                                  std::to_string(positions.rows()) + " positions were given"};
    }
    return guard_memory([&]() -> Result<std::shared_ptr<const SpdAnalysis>> {
        auto symbolic = analyse_pattern(a, positions, monitor);
        if (!symbolic) return symbolic.error();
        std::unique_ptr<const Impl> impl(
            new Impl{*std::move(symbolic), static_cast<Index>(a.nonZeros()), Fingerprint(a)});
        return std::shared_ptr<const SpdAnalysis>(new SpdAnalysis(std::move(impl)));
    });
}

bool SpdAnalysis::fits(const SparseMatrix& a) const {
    return a.isCompressed() && a.rows() == size() && a.cols() == size() && a.nonZeros() == impl_->entries &&
           Fingerprint(a) == impl_->pattern;
}

Index SpdAnalysis::size() const noexcept {
    return impl_->symbolic.size;
}
std::int64_t SpdAnalysis::factor_entries() const noexcept {
    return impl_->symbolic.entries;
}
double SpdAnalysis::factor_flops() const noexcept {
    return impl_->symbolic.flops;
}

struct SpdFactor::Impl {
    std::shared_ptr<const SpdAnalysis> analysis;
    Numeric numeric;
    bool factored = false;
};

SpdFactor::SpdFactor() : impl_(std::make_unique<Impl>()) {}
SpdFactor::SpdFactor(SpdFactor&&) noexcept = default;
SpdFactor& SpdFactor::operator=(SpdFactor&&) noexcept = default;
SpdFactor::~SpdFactor() = default;

Status SpdFactor::analyse(const SparseMatrix& a, const Points& positions, Monitor monitor) {
    impl_->factored = false;
    auto analysis = SpdAnalysis::create(a, positions, monitor);
    if (!analysis) return analysis.error();
    use(*std::move(analysis));
    return Done{};
}

void SpdFactor::use(std::shared_ptr<const SpdAnalysis> analysis) {
    impl_->factored = false;
    impl_->analysis = std::move(analysis);
}

const std::shared_ptr<const SpdAnalysis>& SpdFactor::analysis() const noexcept {
    return impl_->analysis;
}

Status SpdFactor::factor(const SparseMatrix& a, Monitor monitor) {
    impl_->factored = false;
    Stretch factoring{monitor, 0, 1};
    if (impl_->analysis == nullptr || !impl_->analysis->fits(a)) {
        factoring.from = 0.2;
        Stretch analysing{monitor, 0, factoring.from};
        if (Status status = analyse(a, {}, analysing.monitor()); !status) return status;
    }
    return guard_memory([&]() -> Status {
        Status status = impl_->numeric.factor(impl_->analysis->impl_->symbolic, a, factoring.monitor());
        impl_->factored = status.ok();
        return status;
    });
}

Result<Matrix> SpdFactor::solve(const Eigen::Ref<const Matrix>& rhs) const {
    return guard_memory([&]() -> Result<Matrix> {
        if (!impl_->factored) return Error{ErrorCode::bad_argument, "no matrix has been factored"};
        if (rhs.rows() != size()) {
            return Error{ErrorCode::bad_argument, "the factor has " + std::to_string(size()) +
                                                      " rows, but the right-hand side has " +
                                                      std::to_string(rhs.rows())};
        }
        return impl_->numeric.solve(impl_->analysis->impl_->symbolic, rhs);
    });
}

Index SpdFactor::size() const noexcept {
    return impl_->analysis == nullptr ? 0 : impl_->analysis->size();
}
std::int64_t SpdFactor::bytes() const noexcept {
    return impl_->numeric.bytes();
}

}  // namespace polylap

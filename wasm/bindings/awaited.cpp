// Stands in for declared parts of the core until they have landed; each definition is weak and gives way. To be
// removed.
#include "polylap/session.hpp"

#define AWAITED __attribute__((weak))

namespace polylap {
namespace {
const Error awaited{ErrorCode::bad_argument, "this part of the core has not been built yet"};
}  // namespace
AWAITED Result<OrthogonalDual> Session::dual(Side side, DualOptions options, Monitor monitor) {
    return orthogonal_dual(surface(side), options, monitor);
}
AWAITED Result<const PropertyReport*> Session::check(Side, Monitor) {
    return awaited;
}
AWAITED Result<Session> Session::open(std::span<const std::byte> bytes, std::string_view name, const OpenOptions&,
                                      Monitor monitor) {
    return open(bytes, name, monitor);
}
AWAITED const std::vector<std::string>& Session::notes() const noexcept {
    static const std::vector<std::string> none;
    return none;
}
AWAITED const Session::Repairs& Session::repairs() const noexcept {
    static const Repairs none;
    return none;
}
}  // namespace polylap

// What is only asked for by those who look closer, and takes factors and eigensolvers of its own.
#include <emscripten/bind.h>

#include "results.hpp"

namespace polylap::js {
namespace {

using Side = Session::Side;

val check(Session& session, Side side, val callback) {
    return guarded([&]() -> Result<val> {
        Tick tick(std::move(callback));
        const auto report = session.check(side, tick.monitor());
        if (!report) return report.error();
        return told(**report);
    });
}

val dual(Session& session, Side side, double mu, val callback) {
    return guarded([&]() -> Result<val> {
        Tick tick(std::move(callback));
        const auto dual = session.dual(side, {.mu = mu}, tick.monitor());
        if (!dual) return dual.error();
        return told(*dual, session.origin());
    });
}

val spectrum(Session& session, Side side, Index count, val callback) {
    return guarded([&]() -> Result<val> {
        Tick tick(std::move(callback));
        const auto pairs = session.spectrum(side, count, tick.monitor());
        if (!pairs) return pairs.error();
        return array(pairs->values.data(), static_cast<std::size_t>(pairs->values.size()));
    });
}

val convergence(const std::string& id, const val& settings, const val& vertex_weights, val callback) {
    return guarded([&]() -> Result<val> {
        const auto spec = spec_of(id, settings, vertex_weights);
        if (!spec) return spec.error();
        Tick tick(std::move(callback));
        const auto studies = study_convergence(*spec, tick.monitor());
        if (!studies) return studies.error();
        return list(*studies, [](const ConvergenceStudy& study) { return told(study); });
    });
}

}  // namespace
}  // namespace polylap::js

EMSCRIPTEN_BINDINGS(polylap_studies) {
    using emscripten::function;
    using namespace polylap::js;

    function("check", &check);
    function("dual", &dual);
    function("spectrum", &spectrum);
    function("convergence", &convergence);
}

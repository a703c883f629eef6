// Meshes from files, as files, and made into others.
#include <emscripten/bind.h>

#include "polylap/apply/conversions.hpp"
#include "polylap/mesh/mesh_io.hpp"
#include "results.hpp"

namespace polylap::js {
namespace {

using Side = Session::Side;

val open(const val& bytes, const std::string& name, bool repair, double merge_distance, val callback) {
    return guarded([&] {
        const auto data = emscripten::convertJSArrayToNumberVector<std::uint8_t>(bytes);
        Tick tick(std::move(callback));
        const Session::OpenOptions options{.repair = repair, .repair_options = {.merge_distance = merge_distance}};
        return owned(Session::open(std::as_bytes(std::span(data)), name, options, tick.monitor()));
    });
}

val convert_surface(const Session& session, Side side, const std::string& id, const val& settings) {
    return guarded([&]() -> Result<val> {
        auto mesh = convert(session.surface(side), id, settings_of(settings));
        if (!mesh) return mesh.error();
        return owned(Session::from_mesh(*std::move(mesh)));
    });
}

/// As bytes: not all formats are text.
val file(const Session& session, Side side, const std::string& ending) {
    return guarded([&]() -> Result<val> {
        const auto format = format_of("mesh." + ending);
        if (!format) return format.error();
        const auto contents = write_mesh(session.surface(side), *format);
        if (!contents) return contents.error();
        return array(reinterpret_cast<const std::uint8_t*>(contents->data()), contents->size());
    });
}

}  // namespace
}  // namespace polylap::js

EMSCRIPTEN_BINDINGS(polylap_files) {
    using emscripten::function;
    using namespace polylap::js;

    function("open", &open);
    function("file", &file);
    function("convert", &convert_surface);
}

#pragma once

#include <nlohmann/json.hpp>

namespace polylap::tool {

using nlohmann::ordered_json;

/// Text that is no UTF-8 (file names) is replaced, not refused; numbers that are not finite become null.
inline std::string dump(const ordered_json& document) {
    return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace polylap::tool

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace polylap::io {

enum class ByteOrder : std::uint8_t { little, big };

/// The number at a byte; the caller knows that all its bytes are there.
template <class T>
T load(std::string_view bytes, std::size_t at, ByteOrder order) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), bytes.data() + at, sizeof(T));
    if ((order == ByteOrder::big) != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
    T value;  // Not std::bit_cast, which Emscripten's library lacks.
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
}

}  // namespace polylap::io

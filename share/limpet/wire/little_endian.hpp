// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace limpet {

/// Writes the bytes of `value`, least significant first, and returns the place after them.
template <class T>
requires std::is_trivially_copyable_v<T> std::byte* Put(std::byte* out, T value) {
  if constexpr (std::endian::native == std::endian::little || sizeof(T) == 1) {
    std::memcpy(out, &value, sizeof(T));
  } else {
    const auto bytes = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      out[i] = bytes[sizeof(T) - 1 - i];
    }
  }
  return out + sizeof(T);
}

/// The value whose bytes, least significant first, lie at `in`; `in` need not be aligned.
template <class T>
requires std::is_trivially_copyable_v<T>
[[nodiscard]] T Get(const std::byte* in) {
  std::array<std::byte, sizeof(T)> bytes;
  if constexpr (std::endian::native == std::endian::little || sizeof(T) == 1) {
    std::memcpy(bytes.data(), in, sizeof(T));
  } else {
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      bytes[sizeof(T) - 1 - i] = in[i];
    }
  }
  return std::bit_cast<T>(bytes);
}

}  // namespace limpet

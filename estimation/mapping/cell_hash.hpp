// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "limpet/core/split_mix.hpp"

namespace limpet {

/// Hash of a cell by its indices north and east. Neighbours spread over a prime count of buckets,
/// as std::unordered_map of GCC has them; the lowest bits alone tell fewer apart. Equal on all
/// 64-bit machines.
[[nodiscard]] constexpr std::size_t CellHash(std::int32_t north, std::int32_t east) {
  const std::uint64_t both =
      std::uint64_t{static_cast<std::uint32_t>(north)} << 32U | static_cast<std::uint32_t>(east);
  return static_cast<std::size_t>((both * kGoldenStep) ^ (both * kGoldenStep >> 31U));
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace limpet {

/// 2^64 over the golden ratio, odd: SplitMix64's state goes on by it with each draw, and a product
/// with it spreads the low bits of an index over the high ones.
inline constexpr std::uint64_t kGoldenStep = 0x9e3779b97f4a7c15ULL;

/// SplitMix64's finalizer: each state has a value of its own, in which every bit of the state
/// changes half of the bits.
[[nodiscard]] constexpr std::uint64_t SplitMixed(std::uint64_t state) {
  state = (state ^ (state >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  state = (state ^ (state >> 27U)) * 0x94d049bb133111ebULL;
  return state ^ (state >> 31U);
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
// What memories of motions find them by.
#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>

#include "limpet/planning/pose2.hpp"

namespace limpet {

[[nodiscard]] inline bool IsSame(const Pose2& a, const Pose2& b) {
  return a.north == b.north && a.east == b.east && a.yaw == b.yaw;
}
[[nodiscard]] inline bool IsSame(const PathSegment& a, const PathSegment& b) {
  return a.curvature == b.curvature && a.length == b.length;
}

/// Of the numbers' bits: 0.0 and -0.0 differ.
[[nodiscard]] inline std::uint64_t HashOf(std::initializer_list<double> numbers) {
  constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15ULL;
  std::uint64_t hash = 0;
  for (const double number : numbers) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * kOdd;
    hash ^= hash >> 32U;
  }
  return hash;
}

}  // namespace limpet

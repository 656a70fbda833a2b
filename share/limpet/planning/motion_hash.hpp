// SPDX-License-Identifier: MIT
// What memories of motions find them by.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string_view>

#include "limpet/planning/pose2.hpp"

namespace limpet {

[[nodiscard]] inline bool IsSame(const Pose2& a, const Pose2& b) {
  return a.north == b.north && a.east == b.east && a.yaw == b.yaw;
}
[[nodiscard]] inline bool IsSame(const PathSegment& a, const PathSegment& b) {
  return a.curvature == b.curvature && a.length == b.length;
}

/// Of the numbers' bits: 0.0 and -0.0 differ.
[[nodiscard]] inline std::size_t HashOf(std::initializer_list<double> numbers) {
  const auto* bytes = reinterpret_cast<const char*>(std::data(numbers));
  return std::hash<std::string_view>{}({bytes, numbers.size() * sizeof(double)});
}

}  // namespace limpet

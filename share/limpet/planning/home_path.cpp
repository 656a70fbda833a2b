// SPDX-License-Identifier: MIT
#include "limpet/planning/home_path.hpp"

#include <numbers>
#include <optional>
#include <utility>

namespace limpet {
namespace {

constexpr int kHomeHeadings = 72;

}  // namespace

Option HomePath(const Pose2& start, double north, double east, const Region& region,
                Meters turn_radius) {
  std::optional<DubinsPath> best;
  bool is_best_inside = false;
  for (int i = 0; i < kHomeHeadings; ++i) {
    const Pose2 end{north, east, 2.0 * std::numbers::pi * i / kHomeHeadings};
    DubinsPath path = region.ShortestInside(start, end, turn_radius);
    const bool is_inside = region.Contains(path);
    if (!best || (is_inside && !is_best_inside) ||
        (is_inside == is_best_inside && path.length() < best->length())) {
      best = std::move(path);
      is_best_inside = is_inside;
    }
  }
  return {.source = kHomeSource, .path = *best, .estimate = -best->length()};
}

}  // namespace limpet

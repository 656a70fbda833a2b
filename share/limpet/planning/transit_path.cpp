// SPDX-License-Identifier: MIT
#include "limpet/planning/transit_path.hpp"

#include <numbers>
#include <utility>

#include "limpet/core/interval.hpp"
#include "limpet/planning/home_path.hpp"

namespace limpet {
namespace {

constexpr int kEntryHeadings = 72;

}  // namespace

std::optional<Option> TransitPath(const Pose2& start, const Region& region, Meters turn_radius) {
  // A full turn of this radius fits around the entry, so that some heading is recoverable there.
  const double inset = turn_radius.value();
  const Interval north{region.north_min(), region.north_max()};
  const Interval east{region.east_min(), region.east_max()};
  Pose2 entry{north.DrawnIn(inset).Nearest(start.north), east.DrawnIn(inset).Nearest(start.east),
              0.0};
  std::optional<DubinsPath> best;
  for (int i = 0; i < kEntryHeadings; ++i) {
    entry.yaw = 2.0 * std::numbers::pi * i / kEntryHeadings;
    if (!region.IsRecoverable(entry, turn_radius)) {
      continue;
    }
    DubinsPath path = ShortestDubins(start, entry, turn_radius);
    if (!best || path.length() < best->length()) {
      best = std::move(path);
    }
  }
  if (!best) {
    return std::nullopt;
  }
  const double length = best->length();
  return Option{.source = "transit", .path = *std::move(best), .estimate = -length};
}

bool LeadsInto(const Region& region, const Option& option) {
  return !MayEndAnywhere(option) && region.Outside(option.path.end()) <= 0.0;
}

}  // namespace limpet

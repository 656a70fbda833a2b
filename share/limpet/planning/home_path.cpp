// SPDX-License-Identifier: MIT
#include "limpet/planning/home_path.hpp"

#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "limpet/planning/leg_path.hpp"
#include "limpet/planning/region_legs.hpp"
#include "limpet/planning/room.hpp"

namespace limpet {
namespace {

constexpr int kHomeHeadings = 72;

/// The shortest way there of all headings at its end, one inside before all others.
DubinsPath DirectPath(const Pose2& start, const PlanePoint& home, const Region& region,
                      Meters turn_radius) {
  std::optional<DubinsPath> best;
  bool is_best_inside = false;
  for (int i = 0; i < kHomeHeadings; ++i) {
    const Pose2 end{home.x(), home.y(), 2.0 * std::numbers::pi * i / kHomeHeadings};
    DubinsPath path = region.ShortestInside(start, end, turn_radius);
    const bool is_inside = region.Contains(path);
    if (!best || (is_inside && !is_best_inside) ||
        (is_inside == is_best_inside && path.length() < best->length())) {
      best = std::move(path);
      is_best_inside = is_inside;
    }
  }
  return *std::move(best);
}

/// At the way's first place, the gate, or near it and nearer to the second than the gate is: it
/// would be turned back for, at each decision anew.
bool IsPastGate(const std::vector<PlanePoint>& way, const PlanePoint& here, Meters turn_radius) {
  constexpr double kNear = 3.0;  // turning radii
  if (way.size() < 2) return false;
  const double to_gate = (here - way[0]).norm() / turn_radius.value();
  const bool is_nearer = (here - way[1]).norm() <= (way[0] - way[1]).norm();
  return to_gate <= 1.0 || (to_gate <= kNear && is_nearer);
}

/// Through the region, out of it where that is nearest to home or to the way that the mission
/// gives, and on by that.
std::optional<DubinsPath> PathAround(const Pose2& start, const PlanePoint& home,
                                     const Region& region, Meters turn_radius) {
  const FreeSpace& space = *region.free_space();
  const PlanePoint here(start.north, start.east);
  const std::vector<PlanePoint>& transit = region.transit();
  std::vector<PlanePoint> outside;
  if (!space.Contains(home)) {
    const auto gate =
        NearestRoom(space, transit.empty() ? home : transit.back(), turn_radius.value());
    if (!gate) return std::nullopt;
    outside.push_back(*gate);
    outside.insert(outside.end(), transit.rbegin(), transit.rend());
  }
  outside.push_back(home);
  std::vector<LegEnd> legs;
  if (!space.Contains(here)) {
    outside = RestOfWay(outside, here, turn_radius);
  } else if (IsPastGate(outside, here, turn_radius)) {
    outside.erase(outside.begin());
  } else {
    auto inside = LegsInside(region, here, outside.front());
    if (!inside) return std::nullopt;
    legs = *std::move(inside);
    outside.erase(outside.begin());
  }
  for (const PlanePoint& at : outside) {
    legs.push_back({at, [&region](const DubinsPath& path) { return !region.EntersZone(path); }});
  }
  return PathAlong(start, legs, turn_radius);
}

}  // namespace

Option HomePath(const Pose2& start, const PlanePoint& home_W, const Region& region,
                Meters turn_radius) {
  DubinsPath path = DirectPath(start, home_W, region, turn_radius);
  if (region.free_space() != nullptr && !region.Contains(path)) {
    if (auto around = PathAround(start, home_W, region, turn_radius)) path = *std::move(around);
  }
  const double length = path.length();
  return {.source = kHomeSource, .path = std::move(path), .estimate = -length};
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/planning/transit_path.hpp"

#include <numbers>
#include <utility>
#include <vector>

#include "limpet/core/interval.hpp"
#include "limpet/planning/home_path.hpp"
#include "limpet/planning/leg_path.hpp"
#include "limpet/planning/room.hpp"

namespace limpet {
namespace {

constexpr int kEntryHeadings = 72;
/// Farther outside than this a vehicle has not drifted, but is on its way in [m].
constexpr double kDrift = 3.0;

std::optional<DubinsPath> IntoRectangle(const Pose2& start, const Region& region,
                                        Meters turn_radius) {
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
  return best;
}

/// What is left of the transit for one who is `here`; the entry last. Where the way begins matters:
/// one that turns back comes near its end long before it is there.
std::vector<PlanePoint> RestOfTransit(const PlanePoint& begin, const std::vector<PlanePoint>& way,
                                      const PlanePoint& here, Meters turn_radius) {
  std::vector<PlanePoint> whole{begin};
  whole.insert(whole.end(), way.begin(), way.end());
  std::vector<PlanePoint> rest = RestOfWay(whole, here, turn_radius);
  if (rest.size() == whole.size()) rest.erase(rest.begin());  // it has begun
  return rest;
}

std::optional<DubinsPath> IntoShape(const Pose2& start, const PlanePoint& begin,
                                    const Region& region, Meters turn_radius) {
  const PlanePoint here(start.north, start.east);
  std::vector<PlanePoint> way =
      IsInTransit(region, start) ? region.transit() : std::vector<PlanePoint>{};
  const auto entry =
      NearestRoom(*region.free_space(), way.empty() ? here : way.back(), turn_radius.value());
  if (!entry) return std::nullopt;
  way.push_back(*entry);
  std::vector<LegEnd> legs;
  for (const PlanePoint& at : RestOfTransit(begin, way, here, turn_radius)) {
    legs.push_back({at, [&region](const DubinsPath& path) { return !region.EntersZone(path); }});
  }
  return PathAlong(start, legs, turn_radius, [&region, turn_radius](const Pose2& end) {
    return region.IsRecoverable(end, turn_radius);
  });
}

}  // namespace

std::vector<PlanePoint> TransitPlaces(const PlanePoint& begin, const Region& region,
                                      Meters turn_radius) {
  std::vector<PlanePoint> places = region.transit();
  if (places.empty()) return {};
  const auto entry = NearestRoom(*region.free_space(), places.back(), turn_radius.value());
  if (!entry) return {};
  places.insert(places.begin(), begin);
  places.push_back(*entry);
  return places;
}

bool IsInTransit(const Region& region, const Pose2& pose) {
  return !region.transit().empty() && region.Outside(pose) > kDrift;
}

std::optional<Option> TransitPath(const Pose2& start, const PlanePoint& begin, const Region& region,
                                  Meters turn_radius) {
  std::optional<DubinsPath> best = region.free_space() != nullptr
                                       ? IntoShape(start, begin, region, turn_radius)
                                       : IntoRectangle(start, region, turn_radius);
  if (!best) {
    return std::nullopt;
  }
  const double length = best->length();
  return Option{.source = kTransitSource, .path = *std::move(best), .estimate = -length};
}

bool LeadsInto(const Region& region, const Option& option) {
  return !MayEndAnywhere(option) && region.Outside(option.path.end()) <= 0.0;
}

}  // namespace limpet

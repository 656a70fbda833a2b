// SPDX-License-Identifier: MIT
#include "limpet/planning/tour_path.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "limpet/planning/leg_path.hpp"
#include "limpet/planning/region_legs.hpp"

namespace limpet {
namespace {

/// A way by legs, for places between which no word stays inside.
std::optional<DubinsPath> WayAround(const Pose2& from, const Pose2& to, const Region& region,
                                    Meters turn_radius) {
  auto legs = LegsInside(region, {from.north, from.east}, {to.north, to.east});
  if (!legs) return std::nullopt;
  legs->back().heading = to.yaw;
  auto path = PathAlong(from, *legs, turn_radius);
  return path && region.Contains(*path) ? std::move(path) : std::nullopt;
}

std::optional<DubinsPath> WayInside(const Pose2& from, const Pose2& to, const Region& region,
                                    Meters turn_radius) {
  if (const auto word = region.ShortestWordInside(from, to, turn_radius)) {
    return DubinsPath(from, {word->segments.begin(), word->segments.end()});
  }
  return WayAround(from, to, region, turn_radius);
}

FlownTour PassesAlong(const DubinsPath& way) {
  FlownTour flown{.path = way, .passes = {}, .spans = {}};
  Pose2 at = way.start();
  double begin = 0.0;
  const std::vector<PathSegment>& segments = way.segments();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Pose2 end = Advance(at, segments[i]);
    const double done = begin + segments[i].length;
    const bool is_straight = segments[i].curvature == 0.0;
    const bool leads_to_straight = i + 1 < segments.size() && segments[i + 1].curvature == 0.0;
    if (is_straight) {
      flown.passes.push_back({.in = at, .length = segments[i].length});
      flown.spans.push_back({begin, done});
    } else if (!leads_to_straight) {
      flown.passes.push_back({.in = end, .length = 0.0});
      flown.spans.push_back({done, done});
    }
    at = end;
    begin = done;
  }
  return flown;
}

/// A vehicle that is here can go on.
bool HasRoom(const Pose2& pose, const Region& region, Meters turn_radius) {
  return region.Contains(pose) && region.IsRecoverable(pose, turn_radius);
}

FlownTour FlyOn(FlownTour flown, const SurveyTour& tour, const Region& region, Meters turn_radius) {
  for (const Pass& pass : tour) {
    const auto there = WayInside(flown.path.end(), pass.in, region, turn_radius);
    if (!there || !IsInside(pass, region)) {
      flown.is_complete = false;
      continue;
    }
    flown.path.Append(*there);
    const double begin = flown.path.length();
    flown.path.Append({.curvature = 0.0, .length = pass.length});
    flown.passes.push_back(pass);
    flown.spans.push_back({begin, flown.path.length()});
  }
  return flown;
}

}  // namespace

FlownTour Fly(const DubinsPath& way, const SurveyTour& tour, const Region& region,
              Meters turn_radius) {
  return FlyOn({.path = way, .passes = {}, .spans = {}}, tour, region, turn_radius);
}

FlownTour FlyAsPasses(const DubinsPath& way, const SurveyTour& tour, const Region& region,
                      Meters turn_radius) {
  return FlyOn(PassesAlong(way), tour, region, turn_radius);
}

SurveyTour FittedInside(const SurveyTour& tour, const Region& region, Meters turn_radius) {
  SurveyTour fitted;
  for (Pass pass : tour) {
    while (pass.length > kPassCut && !HasRoom(pass.Reversed().out(), region, turn_radius)) {
      pass = {.in = Advance(pass.in, {.curvature = 0.0, .length = kPassCut}),
              .length = pass.length - kPassCut};
    }
    while (pass.length > kPassCut && !HasRoom(pass.out(), region, turn_radius))
      pass.length -= kPassCut;
    if (HasRoom(pass.out(), region, turn_radius) && IsInside(pass, region)) fitted.push_back(pass);
  }
  return fitted;
}

SurveyTour RestAfter(const FlownTour& tour, double flown) {
  SurveyTour rest;
  for (std::size_t i = 0; i < tour.passes.size(); ++i) {
    if (tour.spans[i].high <= flown) continue;
    const double done = std::max(0.0, flown - tour.spans[i].low);
    const Pass& pass = tour.passes[i];
    rest.push_back(
        {.in = Advance(pass.in, {.curvature = 0.0, .length = done}), .length = pass.length - done});
  }
  return rest;
}

}  // namespace limpet

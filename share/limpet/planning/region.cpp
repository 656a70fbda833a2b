// SPDX-License-Identifier: MIT
#include "limpet/planning/region.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "limpet/core/require.hpp"
#include "limpet/planning/region_fences.hpp"

namespace limpet {
namespace {

/// A border touched exactly, or by a rounding error, is still inside.
constexpr double kTouch = 1e-9;

/// A turn from a heading by an angle [rad, signed].
struct SignedTurn {
  double from, by;
};
bool Passes(const SignedTurn& turn, double heading) {
  const double full = 2.0 * std::numbers::pi;
  double ahead = std::fmod(turn.by >= 0.0 ? heading - turn.from : turn.from - heading, full);
  ahead = ahead < 0.0 ? ahead + full : ahead;
  return ahead <= std::abs(turn.by);
}

/// Centres of the circles of radius `r` that a vehicle may turn on from its pose, to port and to
/// starboard.
std::array<PlanePoint, 2> CentersOfTurns(const Pose2& pose, double r) {
  const PlanePoint at(pose.north, pose.east);
  const PlanePoint starboard(-r * std::sin(pose.yaw), r * std::cos(pose.yaw));
  return {at - starboard, at + starboard};
}

std::size_t MarkOf(const std::vector<Fence>& obstacles) {
  constexpr std::size_t kPrime = 1'000'003;
  std::size_t mark = 0;
  for (const Fence& fence : obstacles) {
    for (const PlanePoint& corner : fence.polygon.corners()) {
      for (const double part : {corner.x(), corner.y(), fence.distance}) {
        mark = mark * kPrime + std::hash<double>{}(part) + 1;
      }
    }
  }
  return mark;
}

}  // namespace

Region::Region(const SurveyArea& area, Meters allowance, std::vector<Fence> obstacles)
    : Region(area, KeptOff{.border = allowance, .zones = allowance}, std::move(obstacles)) {}

Region::Region(const SurveyArea& area, const KeptOff& kept_off, std::vector<Fence> obstacles)
    : obstacle_mark_(MarkOf(obstacles)) {
  const double margin = std::max(0.0, area.margin - kept_off.border.value());
  north_min_ = area.north_min - margin;
  north_max_ = area.north_max + margin;
  east_min_ = area.east_min - margin;
  east_max_ = area.east_max + margin;
  const Expected<SurveyShape> shape = SurveyShape::Of(area);
  LIMPET_REQUIRE(shape.has_value(), "a region is made of an area that has been looked at");
  if (shape->is_plain() && obstacles.empty()) return;
  transit_ = shape->transit();
  std::vector<Fence> fences = ZoneFences(*shape, kept_off.zones);
  std::ranges::move(obstacles, std::back_inserter(fences));
  if (!fences.empty()) zones_ = std::make_shared<const FreeSpace>(fences);
  fences.insert(fences.begin(), HoldingFence(*shape, Meters(margin), kept_off.border));
  free_ = std::make_shared<const FreeSpace>(std::move(fences));
  north_min_ = free_->low().x();
  north_max_ = free_->high().x();
  east_min_ = free_->low().y();
  east_max_ = free_->high().y();
}

bool Region::Contains(const PlanePoint& at) const {
  if (free_) return free_->Contains(at);
  return at.x() >= north_min_ - kTouch && at.x() <= north_max_ + kTouch &&
         at.y() >= east_min_ - kTouch && at.y() <= east_max_ + kTouch;
}

bool Region::Contains(const Pose2& from, const PathSegment& segment) const {
  return free_ ? free_->Contains(from, segment) : IsInRectangle(from, segment);
}

bool Region::IsInRectangle(const Pose2& from, const PathSegment& segment) const {
  if (!Contains(from) || !Contains(Advance(from, segment))) {
    return false;
  }
  // An arc can leave and come back only over its northern-, eastern-, ... most point: where its
  // heading is along a border.
  const double turned = segment.curvature * segment.length;
  if (turned == 0.0) {
    return true;
  }
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double heading = quarter * 0.5 * std::numbers::pi;
    if (Passes({from.yaw, turned}, heading)) {
      const double radius = 1.0 / segment.curvature;
      const double north = from.north + radius * (std::sin(heading) - std::sin(from.yaw));
      const double east = from.east + radius * (std::cos(from.yaw) - std::cos(heading));
      if (!Contains(PlanePoint(north, east))) {
        return false;
      }
    }
  }
  return true;
}

bool Region::Contains(const DubinsPath& path) const {
  Pose2 pose = path.start();
  if (!Contains(pose)) {
    return false;
  }
  for (const PathSegment& segment : path.segments()) {
    if (!Contains(pose, segment)) {
      return false;
    }
    pose = Advance(pose, segment);
  }
  return true;
}

double Region::Deficit(const Pose2& pose, Meters radius) const {
  const double r = radius.value();
  double least = std::numeric_limits<double>::infinity();
  for (const PlanePoint& center : CentersOfTurns(pose, r)) {
    const double north = center.x(), east = center.y();
    if (free_) {
      least = std::min(least, std::max(0.0, r - free_->ClearanceUpTo({north, east}, r)));
      continue;
    }
    least = std::min(least, std::max({0.0, north_min_ - north + r, north + r - north_max_,
                                      east_min_ - east + r, east + r - east_max_}));
  }
  return least;
}

bool Region::IsRecoverable(const Pose2& pose, Meters radius) const {
  if (!free_) return Deficit(pose, radius) <= kTouch;
  const double r = radius.value();
  return std::ranges::any_of(CentersOfTurns(pose, r), [&](const PlanePoint& center) {
    return free_->HasClearance(center, r - kTouch);
  });
}

bool Region::Allows(const Pose2& from, const PathSegment& segment, Meters radius) const {
  const Pose2 end = Advance(from, segment);
  if (IsRecoverable(from, radius) && Contains(from)) {
    return IsRecoverable(end, radius) && Contains(from, segment);
  }
  return Deficit(end, radius) <= Deficit(from, radius) + kTouch;
}

double Region::Clearance(const PlanePoint& at) const {
  if (free_) return free_->Clearance(at);
  const double inside =
      std::min({at.x() - north_min_, north_max_ - at.x(), at.y() - east_min_, east_max_ - at.y()});
  return inside >= 0.0 ? inside : -Outside({.north = at.x(), .east = at.y(), .yaw = 0.0});
}

double Region::ZoneClearance(const PlanePoint& at) const {
  return zones_ ? zones_->Clearance(at) : std::numeric_limits<double>::infinity();
}

double Region::Outside(const Pose2& pose) const {
  if (free_) {
    const double clearance = free_->ClearanceUpTo({pose.north, pose.east}, 0.0);
    return clearance < -FreeSpace::kTouch ? -clearance : 0.0;
  }
  const double north = std::max({0.0, north_min_ - pose.north, pose.north - north_max_});
  const double east = std::max({0.0, east_min_ - pose.east, pose.east - east_max_});
  return std::hypot(north, east);
}

bool Region::EntersZone(const DubinsPath& path) const {
  if (!zones_) return false;
  Pose2 pose = path.start();
  for (const PathSegment& segment : path.segments()) {
    if (!zones_->Contains(pose, segment)) return true;
    pose = Advance(pose, segment);
  }
  return false;
}

bool Region::IsInZone(const PlanePoint& at) const { return zones_ && !zones_->Contains(at); }

bool Region::Contains(const Pose2& from, const DubinsWord& word) const {
  if (!Contains(from)) return false;
  Pose2 pose = from;
  for (const PathSegment& segment : word.segments) {
    if (segment.length > 0.0 && !Contains(pose, segment)) return false;
    pose = Advance(pose, segment);
  }
  return true;
}

std::optional<DubinsWord> Region::ShortestWordInside(const Pose2& from, const Pose2& to,
                                                     Meters radius) const {
  const DubinsWords words(from, to, radius);
  const DubinsWord* best = nullptr;
  for (const DubinsWord& word : words.all()) {
    if ((best == nullptr || word.length < best->length) && Contains(from, word)) {
      best = &word;
    }
  }
  return best != nullptr ? std::optional(*best) : std::nullopt;
}

DubinsPath Region::ShortestInside(const Pose2& from, const Pose2& to, Meters radius) const {
  const std::optional<DubinsWord> inside = ShortestWordInside(from, to, radius);
  if (!inside) return ShortestDubins(from, to, radius);
  return DubinsPath(from, {inside->segments.begin(), inside->segments.end()});
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/planning/region.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace limpet {
namespace {

/// A border touched exactly, or by a rounding error, is still inside.
constexpr double kTouch = 1e-9;

/// Whether going from `from` by `turned` [rad, signed] passes `angle`.
bool Passes(double from, double turned, double angle) {
  const double full = 2.0 * std::numbers::pi;
  double ahead = std::fmod(turned >= 0.0 ? angle - from : from - angle, full);
  ahead = ahead < 0.0 ? ahead + full : ahead;
  return ahead <= std::abs(turned);
}

}  // namespace

Region::Region(const SurveyArea& area) : Region(area, area.margin) {}

Region::Region(const SurveyArea& area, double margin)
    : north_min_(area.north_min - margin),
      north_max_(area.north_max + margin),
      east_min_(area.east_min - margin),
      east_max_(area.east_max + margin) {}

bool Region::Contains(double north, double east) const {
  return north >= north_min_ - kTouch && north <= north_max_ + kTouch &&
         east >= east_min_ - kTouch && east <= east_max_ + kTouch;
}

bool Region::Contains(const Pose2& from, const PathSegment& segment) const {
  if (!Contains(from) || !Contains(Advance(from, segment.curvature, segment.length))) {
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
    if (Passes(from.yaw, turned, heading)) {
      const double radius = 1.0 / segment.curvature;
      const double north = from.north + radius * (std::sin(heading) - std::sin(from.yaw));
      const double east = from.east + radius * (std::cos(from.yaw) - std::cos(heading));
      if (!Contains(north, east)) {
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
    pose = Advance(pose, segment.curvature, segment.length);
  }
  return true;
}

double Region::Deficit(const Pose2& pose, Meters radius) const {
  const double r = radius.value();
  double least = std::numeric_limits<double>::infinity();
  for (const double side : {-1.0, 1.0}) {
    const double north = pose.north - side * r * std::sin(pose.yaw);
    const double east = pose.east + side * r * std::cos(pose.yaw);
    least = std::min(least, std::max({0.0, north_min_ - north + r, north + r - north_max_,
                                      east_min_ - east + r, east + r - east_max_}));
  }
  return least;
}

bool Region::IsRecoverable(const Pose2& pose, Meters radius) const {
  return Deficit(pose, radius) <= kTouch;
}

bool Region::Allows(const Pose2& from, const PathSegment& segment, Meters radius) const {
  const Pose2 end = Advance(from, segment.curvature, segment.length);
  const double before = Deficit(from, radius);
  if (before <= kTouch && Contains(from)) {
    return IsRecoverable(end, radius) && Contains(from, segment);
  }
  return Deficit(end, radius) <= before + kTouch;
}

double Region::Outside(const Pose2& pose) const {
  const double north = std::max({0.0, north_min_ - pose.north, pose.north - north_max_});
  const double east = std::max({0.0, east_min_ - pose.east, pose.east - east_max_});
  return std::hypot(north, east);
}

DubinsPath Region::ShortestInside(const Pose2& from, const Pose2& to, Meters radius) const {
  DubinsPath shortest = ShortestDubins(from, to, radius);
  if (Contains(shortest)) {
    return shortest;
  }
  const DubinsPath* best = nullptr;
  const std::vector<DubinsPath> paths = AllDubins(from, to, radius);
  for (const DubinsPath& path : paths) {
    if (Contains(path) && (best == nullptr || path.length() < best->length())) {
      best = &path;
    }
  }
  return best != nullptr ? *best : shortest;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/waypoints/waypoint_progress.hpp"

#include <algorithm>

#include "limpet/core/require.hpp"
#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {

void WaypointProgress::SetPoints(std::vector<MapPoint> points) {
  points_ = std::move(points);
  index_ = 0;
  cycles_ = 0;
  previous_.reset();
  previous_index_.reset();
  nearest_.reset();
}

void WaypointProgress::MovePoints(std::vector<MapPoint> points) {
  LIMPET_REQUIRE(points.size() == points_.size(), "as many points as before");
  points_ = std::move(points);
  nearest_.reset();
}

void WaypointProgress::CountOn(const WaypointProgress& former) {
  captures_ = former.captures_;
  slips_ = former.slips_;
  repeated_ = former.repeated_;
}

void WaypointProgress::Reverse() {
  std::ranges::reverse(points_);
  index_ = 0;
}

void WaypointProgress::SetIndex(std::size_t index) {
  if (index < points_.size()) {
    index_ = index;
    nearest_.reset();
  }
}

void WaypointProgress::Restart() {
  repeated_ = 0;
  index_ = 0;
  nearest_.reset();
}

bool WaypointProgress::IsReached(const MapPoint& at, const CaptureRule& rule) {
  const double distance = DistanceBetween(at, next());
  nearest_ = std::min(nearest_.value_or(distance), distance);
  if (distance < rule.capture_radius) {
    ++captures_;
    return true;
  }
  if (rule.slip_radius > rule.capture_radius && distance > *nearest_ &&
      *nearest_ <= rule.slip_radius) {
    ++slips_;
    return true;
  }
  const MapLeg leg{.from = *previous_, .to = next()};
  return rule.captures_at_line && leg.length() > 0.0 && leg.Along(at) >= leg.length();
}

WaypointProgress::Step WaypointProgress::Advance(const MapPoint& at, const CaptureRule& rule) {
  LIMPET_REQUIRE(!points_.empty(), "there is somewhere to go");
  previous_ = previous_.value_or(at);
  if (!IsReached(at, rule)) {
    return Step::kUnderway;
  }
  previous_ = next();
  previous_index_ = index_;
  nearest_.reset();
  if (++index_ < points_.size()) {
    nearest_ = DistanceBetween(at, next());
    return Step::kAdvanced;
  }
  index_ = 0;
  ++cycles_;
  ++repeated_;
  return repeats_ && repeated_ > *repeats_ ? Step::kCompleted : Step::kCycled;
}

std::optional<int> WaypointProgress::repeats_left() const {
  return repeats_ ? std::optional(std::max(0, *repeats_ - repeated_)) : std::nullopt;
}

double WaypointProgress::ToEndOfCycle(const MapPoint& at) const {
  double distance = DistanceBetween(at, next());
  for (std::size_t i = index_ + 1; i < points_.size(); ++i) {
    distance += DistanceBetween(points_[i - 1], points_[i]);
  }
  return distance;
}

std::optional<double> WaypointProgress::ToEnd(const MapPoint& at) const {
  const std::optional<int> rounds = repeats_left();
  if (!rounds) {
    return std::nullopt;
  }
  double round = DistanceBetween(points_.back(), points_.front());
  for (std::size_t i = 1; i < points_.size(); ++i) {
    round += DistanceBetween(points_[i - 1], points_[i]);
  }
  return ToEndOfCycle(at) + *rounds * round;
}

}  // namespace limpet

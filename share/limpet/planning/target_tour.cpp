// SPDX-License-Identifier: MIT
#include "limpet/planning/target_tour.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "limpet/planning/pass_tour.hpp"

namespace limpet {
namespace {

constexpr std::size_t kMostStops = 8;
constexpr int kArrivalHeadings = 8;
/// Passing to one side is enough when that is within this share of the target's radius.
constexpr double kOffsetShare = 0.7;

Stop PassesOf(const Target& target, const Region& region, Meters turn_radius) {
  Stop stop;
  for (int heading = 0; heading < kArrivalHeadings; ++heading) {
    const double yaw = 2.0 * std::numbers::pi * heading / kArrivalHeadings;
    for (const double side : {0.0, -kOffsetShare, kOffsetShare}) {
      const Pose2 pose{target.north - side * target.radius * std::sin(yaw),
                       target.east + side * target.radius * std::cos(yaw), yaw};
      const Pose2 backwards{pose.north, pose.east, yaw + std::numbers::pi};
      if (region.IsRecoverable(pose, turn_radius) && region.IsRecoverable(backwards, turn_radius)) {
        stop.push_back({.in = pose, .length = 0.0});
      }
    }
  }
  return stop;
}

}  // namespace

std::optional<Option> TargetTour(const Pose2& start, const Region& region,
                                 const Objective& objective, Meters turn_radius) {
  std::vector<Target> nearest = objective.targets;
  std::stable_sort(nearest.begin(), nearest.end(), [&start](const Target& a, const Target& b) {
    return std::hypot(a.north - start.north, a.east - start.east) <
           std::hypot(b.north - start.north, b.east - start.east);
  });
  nearest.resize(std::min(nearest.size(), kMostStops));
  std::vector<Stop> stops;
  for (const Target& target : nearest) {
    Stop stop = PassesOf(target, region, turn_radius);
    if (!stop.empty()) {
      stops.push_back(std::move(stop));
    }
  }
  if (stops.empty()) {
    return std::nullopt;
  }
  PassTour tour = PlanPassTour(start, stops, region, turn_radius);
  for (std::size_t i = tour.reached.size(); i-- > 0 && !region.Contains(tour.path);) {
    tour.path = tour.path.Prefix(i > 0 ? tour.reached[i - 1] : 0.0);
  }
  if (tour.path.length() == 0.0) {
    return std::nullopt;
  }
  return Option{.source = "tour",
                .path = tour.path,
                .estimate = TargetValueOf(tour.path, objective) - tour.path.length()};
}

}  // namespace limpet

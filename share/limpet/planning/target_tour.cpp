// SPDX-License-Identifier: MIT
#include "limpet/planning/target_tour.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

#include "limpet/planning/pass_tour.hpp"

namespace limpet {
namespace {

struct TargetStop {
  double north, east;
  Stop passes;
};

/// Stops ordered together: the work grows with the square of them.
constexpr std::size_t kStopsAtOnce = 8;
constexpr int kArrivalHeadings = 8;
/// Passing to one side is enough when that is within this share of the window's half width.
constexpr double kOffsetShare = 0.7;
/// As far to one side as still shows it: for places that can only be seen from the border.
constexpr double kFarOffsetShare = 0.95;

Stop PassesAt(const Target& target, const Region& region, Meters turn_radius,
              std::initializer_list<double> sides) {
  Stop stop;
  for (int heading = 0; heading < kArrivalHeadings; ++heading) {
    const double yaw = 2.0 * std::numbers::pi * heading / kArrivalHeadings;
    for (const double side : sides) {
      const double aside = side * target.window.half_across;
      const Pose2 pose{target.north - aside * std::sin(yaw), target.east + aside * std::cos(yaw),
                       yaw};
      const Pose2 backwards{pose.north, pose.east, yaw + std::numbers::pi};
      if (region.IsRecoverable(pose, turn_radius) && region.IsRecoverable(backwards, turn_radius)) {
        stop.push_back({.in = pose, .length = 0.0});
      }
    }
  }
  return stop;
}

Stop PassesBy(const Target& target, const Region& region, Meters turn_radius) {
  Stop stop = PassesAt(target, region, turn_radius, {0.0, -kOffsetShare, kOffsetShare});
  return stop.empty() ? PassesAt(target, region, turn_radius, {-kFarOffsetShare, kFarOffsetShare})
                      : stop;
}

/// Moves the stops nearest to `from` out of `stops`.
std::vector<Stop> TakeNearest(const Pose2& from, std::vector<TargetStop>& stops) {
  std::stable_sort(stops.begin(), stops.end(), [&from](const TargetStop& a, const TargetStop& b) {
    return std::hypot(a.north - from.north, a.east - from.east) <
           std::hypot(b.north - from.north, b.east - from.east);
  });
  const auto taken = static_cast<std::ptrdiff_t>(std::min(stops.size(), kStopsAtOnce));
  std::vector<Stop> nearest;
  for (auto stop = stops.begin(); stop != stops.begin() + taken; ++stop) {
    nearest.push_back(std::move(stop->passes));
  }
  stops.erase(stops.begin(), stops.begin() + taken);
  return nearest;
}

/// A way over targets.
struct LookTour {
  DubinsPath path;
  std::vector<Pass> passes;
};

/// A tour of `stops` that stays inside: cut before the first motion that does not.
LookTour TourInside(const Pose2& start, const std::vector<Stop>& stops, const Region& region,
                    Meters turn_radius) {
  PassTour tour = PlanPassTour(start, stops, region, turn_radius);
  std::size_t count = tour.reached.size();
  for (; count > 0 && !region.Contains(tour.path); --count) {
    tour.path = tour.path.Prefix(count > 1 ? tour.reached[count - 2] : 0.0);
  }
  LookTour inside{.path = std::move(tour.path), .passes = {}};
  for (std::size_t i = 0; i < count; ++i) {
    inside.passes.push_back(stops[tour.order[i]][tour.passes[i]]);
  }
  return inside;
}

std::vector<TargetStop> StopsOf(const std::vector<Target>& targets, const Region& region,
                                Meters turn_radius) {
  std::vector<TargetStop> stops;
  for (const Target& target : targets) {
    Stop passes = PassesBy(target, region, turn_radius);
    if (!passes.empty()) {
      stops.push_back({target.north, target.east, std::move(passes)});
    }
  }
  return stops;
}

/// Longer and longer tours, each with what the one before it looks at first.
std::vector<LookTour> LookTours(const Pose2& start, const Region& region,
                                const Objective& objective, Meters turn_radius) {
  std::vector<TargetStop> stops = StopsOf(objective.targets, region, turn_radius);
  std::vector<LookTour> tours;
  LookTour tour{.path = DubinsPath(start), .passes = {}};
  while (!stops.empty() && tour.path.length() < objective.target_decay_m) {
    const std::vector<Stop> next = TakeNearest(tour.path.end(), stops);
    const LookTour more = TourInside(tour.path.end(), next, region, turn_radius);
    if (more.path.length() == 0.0) {
      break;
    }
    tour.path.Append(more.path);
    std::ranges::copy(more.passes, std::back_inserter(tour.passes));
    tours.push_back(tour);
  }
  return tours;
}

Option TourOption(const DubinsPath& path, const Objective& objective) {
  return {
      .source = "tour", .path = path, .estimate = TargetValueOf(path, objective) - path.length()};
}

}  // namespace

bool CanBeLookedAt(const Target& target, const Region& region, Meters turn_radius) {
  return !PassesBy(target, region, turn_radius).empty();
}

std::vector<Option> TargetTours(const Pose2& start, const Region& region,
                                const Objective& objective, Meters turn_radius) {
  std::vector<Option> options;
  for (const LookTour& tour : LookTours(start, region, objective, turn_radius)) {
    options.push_back(TourOption(tour.path, objective));
  }
  return options;
}

std::vector<Pass> TargetPasses(const Pose2& start, const Region& region, const Objective& objective,
                               Meters turn_radius) {
  std::vector<LookTour> tours = LookTours(start, region, objective, turn_radius);
  return tours.empty() ? std::vector<Pass>() : std::move(tours.back().passes);
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/planning/gap_paths.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "limpet/planning/pass_tour.hpp"
#include "limpet/planning/unseen_patches.hpp"

namespace limpet {
namespace {

constexpr int kGapHeadings = 8;
/// Longer than needed, for the corners of the image [m].
constexpr double kRunSlack = 0.5;

/// It can be reached and left without leaving the region.
bool IsPassFlyable(const Pass& pass, const Region& region, Meters turn_radius) {
  const Pose2 backwards{pass.in.north, pass.in.east, pass.in.yaw + std::numbers::pi};
  return region.IsRecoverable(pass.out(), turn_radius) &&
         region.IsRecoverable(backwards, turn_radius);
}

/// Passes over a patch along its axes and between them, both ways, that keep it inside the image at
/// the top of the band; those that would be trapped at the border are left out.
Stop PassesOver(const Patch& patch, const Footprint& footprint, const Region& region,
                Meters turn_radius) {
  const int top = Footprint::kTop;
  Stop stop;
  for (int i = 0; i < kGapHeadings; ++i) {
    const double off_axis = 2.0 * std::numbers::pi * i / kGapHeadings;
    const double c = std::abs(std::cos(off_axis)), s = std::abs(std::sin(off_axis));
    const double along = patch.length * c + patch.width * s;
    const double across = patch.length * s + patch.width * c;
    const bool is_lengthwise = i % (kGapHeadings / 2) == 0;
    if (!is_lengthwise && across > 2.0 * footprint.half_across(top)) {
      continue;
    }
    const double run = std::max(0.0, along - 2.0 * footprint.half_along(top) + kRunSlack);
    const Pose2 centre{patch.north, patch.east, patch.axis_yaw + off_axis};
    // At the border a shorter pass may be flyable where the whole one is not.
    for (const double share : {1.0, 0.5, 0.0}) {
      const Pass pass{.in = Advance(centre, {.curvature = 0.0, .length = -0.5 * share * run}),
                      .length = share * run};
      if (IsPassFlyable(pass, region, turn_radius)) {
        stop.push_back(pass);
        break;
      }
    }
  }
  return stop;
}

/// The largest patches that the finish needs; of these the nearest and largest.
std::vector<Patch> WorthVisiting(const Pose2& start, const Ground& ground,
                                 const GapParams& params) {
  const GridFrame& frame = ground.frame();
  std::vector<Patch> patches = UnseenPatches(ground, params.tile.value());
  std::erase_if(patches,
                [&](const Patch& patch) { return patch.missing_m2 < params.min_patch_m2; });
  double may_stay =
      (1.0 - params.finish_share) * frame.rows * frame.columns * frame.cell_m * frame.cell_m;
  while (!patches.empty() && patches.back().unseen_m2 <= may_stay) {
    may_stay -= patches.back().unseen_m2;
    patches.pop_back();
  }
  const auto score = [&start](const Patch& patch) {
    return patch.missing_m2 /
           (10.0 + std::hypot(patch.north - start.north, patch.east - start.east));
  };
  std::stable_sort(patches.begin(), patches.end(),
                   [&score](const Patch& a, const Patch& b) { return score(a) > score(b); });
  patches.resize(std::min<std::size_t>(patches.size(), static_cast<std::size_t>(params.patches)));
  return patches;
}

PassTour TourOf(const Pose2& start, const Ground& ground, const Region& region,
                const GapParams& params) {
  std::vector<Stop> stops;
  for (const Patch& patch : WorthVisiting(start, ground, params)) {
    Stop stop = PassesOver(patch, ground.footprint(), region, params.turn_radius);
    if (!stop.empty()) {
      stops.push_back(std::move(stop));
    }
  }
  return PlanPassTour(start, stops, region, params.turn_radius);
}

}  // namespace

std::vector<Option> GapPaths(const Pose2& start, const Ground& ground, const Region& region,
                             const Objective& objective, const GapParams& params) {
  const PassTour tour = TourOf(start, ground, region, params);
  SeenAlong seen(ground);
  std::vector<Option> options;
  for (const double end : tour.reached) {
    DubinsPath path = tour.path.Prefix(end);
    if (!region.Contains(path)) {
      break;
    }
    const double value = ValueOf(path, objective, ground, seen);
    options.push_back({.source = "gap", .path = std::move(path), .estimate = value});
  }
  std::stable_sort(options.begin(), options.end(), [](const Option& a, const Option& b) {
    return a.estimate / a.path.length() > b.estimate / b.path.length();
  });
  options.resize(std::min<std::size_t>(options.size(), static_cast<std::size_t>(params.offers)));
  return options;
}

}  // namespace limpet

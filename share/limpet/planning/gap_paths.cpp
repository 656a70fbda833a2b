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

/// Passes along both axes of a patch, both ways, that keep it inside the image at the top of the
/// band; those that would be trapped at the border are left out.
Stop PassesOf(const Patch& patch, const Footprint& footprint, const Region& region,
              Meters turn_radius) {
  const int top = Footprint::kLayers - 1;
  Stop stop;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double yaw = patch.axis_yaw + quarter * 0.5 * std::numbers::pi;
    const bool is_lengthwise = quarter % 2 == 0;
    const double along = is_lengthwise ? patch.length : patch.width;
    const double across = is_lengthwise ? patch.width : patch.length;
    if (!is_lengthwise && across > 2.0 * footprint.half_across(top)) {
      continue;
    }
    const double run = std::max(0.0, along - 2.0 * footprint.half_along(top) + 0.5);
    const Pose2 centre{patch.north, patch.east, yaw};
    const Pass pass{.in = Advance(centre, 0.0, -0.5 * run), .length = run};
    if (region.IsRecoverable(pass.out(), turn_radius)) {
      stop.push_back(pass);
    }
  }
  return stop;
}

/// Near and large first.
std::vector<Patch> WorthVisiting(const Pose2& start, const Ground& ground,
                                 const GapParams& params) {
  std::vector<Patch> patches = UnseenPatches(ground, params.tile.value());
  std::erase_if(patches,
                [&](const Patch& patch) { return patch.missing_m2 < params.min_patch_m2; });
  const auto score = [&start](const Patch& patch) {
    return patch.missing_m2 /
           (10.0 + std::hypot(patch.north - start.north, patch.east - start.east));
  };
  std::stable_sort(patches.begin(), patches.end(),
                   [&score](const Patch& a, const Patch& b) { return score(a) > score(b); });
  patches.resize(std::min<std::size_t>(patches.size(), static_cast<std::size_t>(params.patches)));
  return patches;
}

}  // namespace

std::vector<Option> GapPaths(const Pose2& start, const Ground& ground, const Region& region,
                             const Objective& objective, const GapParams& params) {
  std::vector<Stop> stops;
  for (const Patch& patch : WorthVisiting(start, ground, params)) {
    Stop stop = PassesOf(patch, ground.footprint(), region, params.turn_radius);
    if (!stop.empty()) {
      stops.push_back(std::move(stop));
    }
  }
  if (stops.empty()) {
    return {};
  }
  const PassTour tour = PlanPassTour(start, stops, region, params.turn_radius);
  SightAlong sight(ground);
  std::vector<Option> options;
  for (const double end : tour.reached) {
    DubinsPath path = tour.path.Prefix(end);
    const double value = ValueOf(path, objective, ground, sight);
    options.push_back({.source = "gap", .path = std::move(path), .estimate = value});
  }
  std::stable_sort(options.begin(), options.end(), [](const Option& a, const Option& b) {
    return a.estimate / a.path.length() > b.estimate / b.path.length();
  });
  options.resize(std::min<std::size_t>(options.size(), static_cast<std::size_t>(params.offers)));
  return options;
}

}  // namespace limpet

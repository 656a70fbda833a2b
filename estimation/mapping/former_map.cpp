// SPDX-License-Identifier: MIT
#include "estimation/mapping/former_map.hpp"

#include <utility>

#include "estimation/change/frame_gate.hpp"
#include "limpet/core/app_keys.hpp"

namespace limpet {
namespace {

MapParams FormerParams(const SessionPrior& prior, const MapParams& own) {
  if (prior.map_parameters.empty()) {
    return own;
  }
  const SourceLine where{.file = "former session " + prior.session, .line = 0};
  ConfigBlock block{.name = "pMap", .where = where, .entries = {}};
  for (const auto& [key, value] : prior.map_parameters) {
    block.entries.push_back({.key = key, .value = value, .where = where});
  }
  return ReadParams<MapParams>(block, CommonAppKeys());
}

/// What the former session found out of its water, else what its mission expected.
VisibilityBelief FormerWater(const SessionPrior& prior, const StatusParams& params) {
  const bool has_found =
      prior.water && prior.water->visibility > Meters(0.0) && prior.water->sd >= Meters(0.0);
  return has_found ? VisibilityBelief::Of(*prior.water)
                   : VisibilityBelief(params.detection.visibility, params.visibility_spread);
}

}  // namespace

FormerViews FormerViewsOf(const SessionPrior& prior, const MapParams& own) {
  const MapParams params = FormerParams(prior, own);
  FormerViews views{.frames = {},
                    .model = {.look = params.status.LookFrom(params.camera.geometry()),
                              .obstacles = SightObstacles(prior.obstacles)},
                    .looks = params.status.looks,
                    .water = FormerWater(prior, params.status)};
  FrameGate gate(params.frame_gate());
  for (const FormerView& view : prior.views) {
    const Seconds exposure = view.frame.exposure;
    if (view.frame.altitude) gate.Hear(exposure - view.altitude_age, *view.frame.altitude);
    if (!gate.Judge(exposure, std::nullopt, "").drop) {
      views.frames.push_back(view.frame);
    }
  }
  return views;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "apps/pMap/former_map.hpp"

#include <utility>

#include "apps/pMap/map_conversions.hpp"
#include "estimation/change/sight_gate.hpp"
#include "limpet/app/registry.hpp"

namespace limpet {
namespace {

MapApp::Params FormerParams(const SessionPrior& prior, const MapApp::Params& own) {
  if (prior.map_parameters.empty()) {
    return own;
  }
  const SourceLine where{.file = "former session " + prior.session, .line = 0};
  ConfigBlock block{.name = "pMap", .where = where, .entries = {}};
  for (const auto& [key, value] : prior.map_parameters) {
    block.entries.push_back({.key = key, .value = value, .where = where});
  }
  return ReadParams<MapApp::Params>(block, CommonAppKeys());
}

}  // namespace

FormerViews FormerViewsOf(const SessionPrior& prior, const MapApp::Params& own) {
  const MapApp::Params params = FormerParams(prior, own);
  FormerViews views{.sights = {},
                    .model = {.camera = params.camera.geometry(),
                              .detection = params.status.detection,
                              .object_radius = params.status.object_radius.value()},
                    .looks = params.status.looks};
  SightGate gate(params.sight_gate());
  auto box = prior.boxes.begin();
  for (std::size_t i = 0; i < prior.views.size(); ++i) {
    const auto& [t, north, east, down, roll, pitch, yaw, altitude, altitude_age] = prior.views[i];
    SightRecord record{.time = t, .X_WB = {{north, east, down}, roll, pitch, yaw}, .boxes = {}};
    for (; box != prior.boxes.end() && box->view == static_cast<int>(i); ++box) {
      record.boxes.push_back(DetectionOf({box->box, -1}));
    }
    gate.Hear(Seconds(t - altitude_age), altitude);
    if (!gate.Judge(Seconds(t), std::nullopt, "").drop) {
      views.sights.push_back(std::move(record));
    }
  }
  return views;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/mission/shared_settings.hpp"

#include <algorithm>

namespace limpet {
namespace {

std::vector<SharedSetting::Taker> OfCameras(const char* key) {
  return {{"pHelm", key}, {"pMap", key}, {"pNav", key}, {"uSimCamera", key}};
}

}  // namespace

const std::vector<SharedSetting>& SharedSettings() {
  static const std::vector<SharedSetting> settings{
      {"survey_altitude_m",
       "the survey altitude",
       {{"pSurvey", "altitude_m"},
        {"pHelm", "survey_altitude_m"},
        {"BHV_HoldAltitude", "altitude_m"}}},
      {"object_radius_m",
       "the objects' radius",
       {{"pMap", "object_radius_m"}, {"pNav", "opi_radius_m"}}},
      {"settled_entropy",
       "when an object is settled",
       {{"BHV_RevisitOpi", "settled_entropy"}, {"BHV_ReduceObjectEntropy", "settled_entropy"}}},
      {"settled_looks",
       "when an object is settled",
       {{"BHV_RevisitOpi", "settled_looks"}, {"BHV_ReduceObjectEntropy", "settled_looks"}}},
      {"scenario",
       "the scenario",
       {{"uSimVehicle", "scenario"}, {"uSimSensors", "scenario"}, {"uSimCamera", "scenario"}}},
      {"camera_fov_across_deg", "the camera", OfCameras("camera_fov_across_deg")},
      {"camera_fov_along_deg", "the camera", OfCameras("camera_fov_along_deg")},
      {"camera_width_px", "the camera", OfCameras("camera_width_px")},
      {"camera_height_px", "the camera", OfCameras("camera_height_px")}};
  return settings;
}

std::string_view GlobalFor(std::string_view owner, std::string_view key) {
  for (const SharedSetting& setting : SharedSettings()) {
    const bool takes = std::ranges::any_of(setting.takers, [&](const SharedSetting::Taker& taker) {
      return owner == taker.owner && EqualsIgnoringCase(key, taker.key);
    });
    if (takes) return setting.global;
  }
  return "";
}

void TakeGlobals(const std::vector<ConfigEntry>& globals, std::string_view owner,
                 ConfigBlock& block) {
  for (const SharedSetting& setting : SharedSettings()) {
    const auto global = std::ranges::find_if(globals, [&setting](const ConfigEntry& entry) {
      return EqualsIgnoringCase(entry.key, setting.global);
    });
    if (global == globals.end()) continue;
    for (const SharedSetting::Taker& taker : setting.takers) {
      if (EqualsIgnoringCase(owner, taker.owner) && block.Find(taker.key) == nullptr) {
        block.entries.push_back({taker.key, global->value, global->where});
      }
    }
  }
}

void TakeGlobals(const std::vector<ConfigEntry>& globals, std::vector<ConfigBlock>& blocks) {
  for (ConfigBlock& block : blocks) {
    TakeGlobals(globals, std::string(block.name), block);
  }
}

}  // namespace limpet

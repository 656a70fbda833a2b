// SPDX-License-Identifier: MIT
#include "limpet/mission/shared_settings.hpp"

#include <algorithm>

namespace limpet {
namespace {

/// A setting that is about two sessions: pNav matches by it, pMap believes the matches by it.
SharedSetting OfTwoSessions(const char* key, const char* meaning) {
  return {.global = key, .meaning = meaning, .takers = {{"pMap", key}, {"pNav", key}}};
}

SharedSetting OfTwoFrames(const char* key) {
  return OfTwoSessions(key, "how two sessions' frames may lie");
}

}  // namespace

const std::vector<SharedSetting>& SharedSettings() {
  static const std::vector<SharedSetting> settings{
      {.global = "survey_altitude_m",
       .meaning = "the survey altitude",
       .takers = {{"pSurvey", "altitude_m"},
                  {"pHelm", "survey_altitude_m"},
                  {"BHV_HoldAltitude", "altitude_m"}}},
      {.global = "object_radius_m",
       .meaning = "the objects' radius",
       .takers = {{"pMap", "object_radius_m"}, {"pNav", "opi_radius_m"}}},
      {.global = "surface_depth_m",
       .meaning = "the depth from which on the vehicle is at the surface",
       .takers = {{"pSurvey", "surface_depth_m"}, {"BHV_SurfaceFix", "surface_depth_m"}}},
      {.global = "settled_entropy",
       .meaning = "when an object is settled",
       .takers = {{"BHV_RevisitOpi", "settled_entropy"},
                  {"BHV_ReduceObjectEntropy", "settled_entropy"}},
       .is_one_fact = false},
      {.global = "settled_looks",
       .meaning = "when an object is settled",
       .takers = {{"BHV_RevisitOpi", "settled_looks"},
                  {"BHV_ReduceObjectEntropy", "settled_looks"}},
       .is_one_fact = false},
      OfTwoFrames("session_offset_sigma_m"),
      OfTwoFrames("session_datum_sigma_m"),
      OfTwoFrames("session_datum_turn_sigma_deg"),
      OfTwoFrames("session_down_sigma_m"),
      OfTwoFrames("session_turn_sigma_deg"),
      OfTwoFrames("match_position_floor_m"),
      OfTwoSessions("moved_within_m", "how far an object may have moved")};
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

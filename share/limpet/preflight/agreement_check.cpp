// SPDX-License-Identifier: MIT
// One fact that is said in several places must be said alike.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "limpet/mission/shared_settings.hpp"
#include "limpet/preflight/checks.hpp"

namespace limpet::internal {
namespace {

bool IsSame(const Setting& a, const Setting& b) {
  constexpr double kSlack = 1e-9;
  return a.text == b.text || std::abs(a.number() - b.number()) <= kSlack * std::abs(a.number());
}

constexpr const char* kMission = "the mission";

/// A global that the command line overrides for all who take it says nothing any more.
void DropOverridden(std::vector<Setting>& settings) {
  const bool has_global = settings.size() > 1 && settings.front().owner == kMission;
  if (has_global && std::all_of(settings.begin() + 1, settings.end(), [](const Setting& setting) {
        return setting.where.file.starts_with("--set ");
      })) {
    settings.erase(settings.begin());
  }
}

/// Every setting that differs from the first one given is a problem of its line.
void Compare(const char* fact, std::vector<Setting> settings, MissionProblems& found) {
  DropOverridden(settings);
  for (const Setting& other : settings) {
    const Setting& first = settings.front();
    if (!IsSame(first, other)) {
      const std::string unit = other.unit.empty() ? "" : " " + other.unit;
      found.geometry.push_back(other.Refuse(fmt::format(
          "{} is {}{} for {} and {}{} for {}: {}; it is one fact and must be said alike", fact,
          other.text, unit, other.owner, first.text, unit, first.owner, first.Named())));
    }
  }
}

void Add(const std::optional<Setting>& setting, std::vector<Setting>& settings) {
  if (setting) settings.push_back(*setting);
}

std::vector<Setting> With(std::vector<Setting> settings, const std::vector<Setting>& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

/// What the mission says for all, if it does. It is compared with first, so that a block which says
/// something else is the one that is refused.
std::vector<Setting> GlobalSetting(const MissionReading& reading, std::string_view name) {
  for (const ConfigEntry& global : reading.mission().globals) {
    if (EqualsIgnoringCase(global.key, name)) {
      return {{.owner = kMission,
               .key = std::string(name),
               .text = global.value,
               .unit = {},
               .where = global.where}};
    }
  }
  return {};
}

/// Of all apps that have one: what they project pixels with is one camera.
void CompareCameras(const MissionReading& reading, MissionProblems& found) {
  std::map<std::string, std::vector<Setting>> settings;
  for (const char* key :
       {"camera_fov_across_deg", "camera_fov_along_deg", "camera_width_px", "camera_height_px"}) {
    settings[key] = GlobalSetting(reading, key);
  }
  for (const LaunchedApp& app : reading.apps()) {
    for (const ParamSpec& spec : app.entry->describe()) {
      if (spec.name.starts_with("camera_") && spec.is_required) {
        Add(reading.Find(app.process, spec.name), settings[spec.name]);
      }
    }
  }
  for (const auto& [key, alike] : settings) {
    Compare("the camera", alike, found);
  }
}

}  // namespace

void CheckAgreement(const MissionReading& reading, MissionProblems& found) {
  std::vector<Setting> altitudes = GlobalSetting(reading, "survey_altitude_m");
  Add(reading.Find("pSurvey", "altitude_m"), altitudes);
  Add(reading.Find("pHelm", "survey_altitude_m"), altitudes);
  Compare("the survey altitude",
          With(altitudes, reading.OfBehaviors("BHV_HoldAltitude", "altitude_m")), found);
  CompareCameras(reading, found);

  std::vector<Setting> radii = GlobalSetting(reading, "object_radius_m");
  Add(reading.Find("pMap", "object_radius_m"), radii);
  Add(reading.Find("pNav", "opi_radius_m"), radii);
  std::erase_if(radii, [](const Setting& s) { return s.number() == 0.0; });  // pNav: unknown
  Compare("the objects' radius", radii, found);

  std::vector<Setting> scenarios = GlobalSetting(reading, "scenario");
  for (const char* app : {"uSimVehicle", "uSimSensors", "uSimCamera"}) {
    Add(reading.Find(app, "scenario"), scenarios);
  }
  Compare("the scenario", scenarios, found);

  // An object that pSurvey waits for must be one that the helm still goes to.
  for (const char* key : {"settled_entropy", "settled_looks"}) {
    std::vector<Setting> settled = GlobalSetting(reading, key);
    Add(reading.Find("pSurvey", key), settled);
    settled = With(settled, reading.OfBehaviors("BHV_RevisitOpi", key));
    if (!settled.empty() && settled.front().owner == kMission) {
      settled = With(settled, reading.OfBehaviors("BHV_ReduceObjectEntropy", key));
    }
    Compare("when an object is settled", settled, found);
  }
}

}  // namespace limpet::internal

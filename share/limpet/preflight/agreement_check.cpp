// SPDX-License-Identifier: MIT
// One fact that is said in several places must be said alike.
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/same_value.hpp"
#include "limpet/mission/shared_settings.hpp"
#include "limpet/mission/vehicle_settings.hpp"
#include "limpet/preflight/checks.hpp"

namespace limpet::internal {
namespace {

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
void Compare(const std::string& fact, std::vector<Setting> settings, MissionProblems& found) {
  DropOverridden(settings);
  for (const Setting& other : settings) {
    const Setting& first = settings.front();
    if (!IsSameValue(first.text, other.text)) {
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

void Add(const std::vector<Setting>& more, std::vector<Setting>& settings) {
  settings.insert(settings.end(), more.begin(), more.end());
}

/// What the mission says for all, if it does.
std::vector<Setting> GlobalSetting(const MissionReading& reading, const char* name) {
  for (const ConfigEntry& global : reading.mission().globals) {
    if (EqualsIgnoringCase(global.key, name)) {
      return {{.owner = kMission,
               .key = name,
               .text = global.value,
               .unit = {},
               .where = global.where}};
    }
  }
  return {};
}

/// The global goes first, so that a block which says something else is the one that is refused.
void CompareShared(const MissionReading& reading, const SharedSetting& shared,
                   MissionProblems& found) {
  const std::vector<Setting> global = GlobalSetting(reading, shared.global);
  std::vector<Setting> settings = global;
  for (const SharedSetting::Taker& taker : shared.takers) {
    Add(reading.Find(taker.owner, taker.key), settings);
    Add(reading.OfBehaviors(taker.owner, taker.key), settings);
    // pNav may not know the objects' radius, and says so with 0.
    std::erase_if(settings,
                  [](const Setting& s) { return s.key == "opi_radius_m" && s.number() == 0.0; });
    if (global.empty() && !shared.is_one_fact) {
      Compare(shared.meaning, settings, found);
      settings.clear();
    }
  }
  Compare(shared.meaning, settings, found);
}

/// A block that says a fact of the vehicle must say what its file says.
void CompareWithVehicle(const MissionReading& reading, MissionProblems& found) {
  const std::vector<ConfigEntry> entries = FactEntries(VehicleFacts(), reading.vehicle_path());
  for (const FactTaker& taker : VehicleFacts().takers) {
    const auto entry = std::ranges::find(entries, taker.fact, &ConfigEntry::key);
    if (taker.is_former || entry == entries.end()) continue;
    std::vector<Setting> settings{{.owner = "the vehicle's file",
                                   .key = taker.fact,
                                   .text = entry->value,
                                   .unit = {},
                                   .where = entry->where}};
    Add(reading.Find(taker.owner, taker.key), settings);
    if (settings.size() > 1 && settings.back().where.file.starts_with("--set ")) continue;
    Compare(fmt::format("the vehicle's {}", taker.fact), settings, found);
  }
}

/// Of all apps that have one: what they project pixels with is one camera.
void CompareCameras(const MissionReading& reading, MissionProblems& found) {
  std::map<std::string, std::vector<Setting>> settings;
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

/// Boxes that pDetect keeps to itself are none that pNav could use.
void CompareConfidences(const MissionReading& reading, MissionProblems& found) {
  const auto published = reading.Find("pDetect", "min_confidence");
  const auto used = reading.Find("pNav", "min_confidence");
  if (!published || !used || published->number() <= used->number()) return;
  found.notes.push_back(published->Refuse(
      fmt::format("boxes below {} are not published, so that {} is without effect", published->text,
                  used->Named())));
}

}  // namespace

void CheckAgreement(const MissionReading& reading, MissionProblems& found) {
  for (const SharedSetting& shared : SharedSettings()) {
    CompareShared(reading, shared, found);
  }
  CompareWithVehicle(reading, found);
  CompareCameras(reading, found);
  CompareConfidences(reading, found);

  std::vector<Setting> scenarios;
  for (const char* app : {"uSimVehicle", "uSimSensors", "uSimCamera"}) {
    Add(reading.Find(app, "scenario"), scenarios);
  }
  Compare("the scenario", scenarios, found);
}

}  // namespace limpet::internal

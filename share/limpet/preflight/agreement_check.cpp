// SPDX-License-Identifier: MIT
// One fact that is said in several places must be said alike.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/preflight/checks.hpp"

namespace limpet::internal {
namespace {

bool IsSame(const Setting& a, const Setting& b) {
  constexpr double kSlack = 1e-9;
  const std::optional<double> first = ParseNumber(a.text);
  const std::optional<double> other = ParseNumber(b.text);
  if (!first || !other) return a.text == b.text;
  return std::abs(*first - *other) <= kSlack * std::abs(*first);
}

/// Every setting that differs from the first one given is a problem of its line.
void Compare(const char* fact, const std::vector<Setting>& settings, MissionProblems& found) {
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

}  // namespace

void CheckAgreement(const MissionReading& reading, MissionProblems& found) {
  std::vector<Setting> altitudes;
  Add(reading.Find("pSurvey", "altitude_m"), altitudes);
  Add(reading.Find("pHelm", "survey_altitude_m"), altitudes);
  Compare("the survey altitude",
          With(altitudes, reading.OfBehaviors("BHV_HoldAltitude", "altitude_m")), found);
  CompareCameras(reading, found);

  std::vector<Setting> radii;
  Add(reading.Find("pMap", "object_radius_m"), radii);
  Add(reading.Find("pNav", "opi_radius_m"), radii);
  std::erase_if(radii, [](const Setting& s) { return s.number() == 0.0; });  // pNav: unknown
  Compare("the objects' radius", radii, found);

  std::vector<Setting> scenarios;
  for (const char* app : {"uSimVehicle", "uSimSensors", "uSimCamera"}) {
    Add(reading.Find(app, "scenario"), scenarios);
  }
  Compare("the scenario", scenarios, found);

  // An object that pSurvey waits for must be one that the helm still goes to.
  for (const char* key : {"settled_entropy", "settled_looks"}) {
    std::vector<Setting> settled;
    Add(reading.Find("pSurvey", key), settled);
    Compare("when an object is settled", With(settled, reading.OfBehaviors("BHV_RevisitOpi", key)),
            found);
  }
}

}  // namespace limpet::internal

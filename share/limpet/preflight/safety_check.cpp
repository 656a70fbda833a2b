// SPDX-License-Identifier: MIT
// Whether the safety rules would end the very mission that they are to guard.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "limpet/preflight/checks.hpp"

namespace limpet::internal {
namespace {

constexpr const char* kSafetyApp = "pSafety";

/// The earlier of two rules about one thing must not ask for more than the later one lets happen.
void CheckOrder(const MissionReading& reading, const char* gentle, const char* stern, bool is_above,
                MissionProblems& found) {
  const Setting first = *reading.Find(kSafetyApp, gentle);
  const Setting last = *reading.Find(kSafetyApp, stern);
  const bool is_ordered =
      is_above ? first.number() <= last.number() : first.number() >= last.number();
  if (is_ordered) return;
  const Setting& said = last.is_default ? first : last;
  found.geometry.push_back(
      said.Refuse(fmt::format("{} would trip before {}; allowed: the other "
                              "way round",
                              last.Named(), first.Named())));
}

void CheckAltitudeLimit(const MissionReading& reading, const SurveyFacts& survey,
                        MissionProblems& found) {
  const Setting limit = *reading.Find(kSafetyApp, "altitude_limit_m");
  const double lowest =
      survey.altitude.number() - reading.Find("pSurvey", "altitude_tolerance_m")->number();
  if (limit.number() < lowest || IsRuleOff(reading, "altitude_low")) return;
  found.geometry.push_back(limit.Refuse(
      fmt::format("`{}`: rule altitude_low would bring the vehicle up from its survey, "
                  "flown down to {:g} m ({}); allowed: less than that",
                  limit.text, lowest, survey.altitude.Named())));
}

void CheckTimeLimit(const MissionReading& reading, MissionProblems& found) {
  const Setting limit = *reading.Find(kSafetyApp, "mission_limit_s");
  const Setting longest = *reading.Find("pSurvey", "max_time_s");
  if (limit.number() > longest.number() || IsRuleOff(reading, "mission_time")) return;
  found.geometry.push_back(limit.Refuse(
      fmt::format("`{}`: rule mission_time would bring the vehicle up before it may go "
                  "home by {}; allowed: more than that",
                  limit.text, longest.Named())));
}

void CheckHomeLimit(const MissionReading& reading, const SurveyFacts& survey,
                    MissionProblems& found) {
  if (!reading.scenario() || IsRuleOff(reading, "far_from_home")) return;
  const Scenario::Start& start = reading.scenario()->start;
  const double north = std::max(std::abs(survey.area.north_min - start.north_m),
                                std::abs(survey.area.north_max - start.north_m));
  const double east = std::max(std::abs(survey.area.east_min - start.east_m),
                               std::abs(survey.area.east_max - start.east_m));
  const Setting limit = *reading.Find(kSafetyApp, "home_limit_m");
  const double farthest = std::hypot(north, east);
  if (limit.number() > farthest) return;
  found.geometry.push_back(
      limit.Refuse(fmt::format("`{}`: rule far_from_home would end the survey: the area reaches as "
                               "far as {:.0f} m from the start; allowed: more than that",
                               limit.text, farthest)));
}

/// A helm that has no depth to keep stops all: then helm_idle answers the loss, not dvl_lost.
void CheckSeabedMemory(const MissionReading& reading, MissionProblems& found) {
  if (IsRuleOff(reading, "dvl_lost")) return;
  const Setting limit = *reading.Find(kSafetyApp, "dvl_lost_s");
  for (const Setting& memory : reading.OfBehaviors("BHV_HoldAltitude", "memory_s")) {
    if (memory.number() > limit.number()) continue;
    const Setting& said = memory.is_default ? limit : memory;
    found.notes.push_back(said.Refuse(
        fmt::format("a survey without its DVL has no depth to keep after {}, before rule dvl_lost "
                    "acts by {}: rule helm_idle may end it first; a memory longer than that leaves "
                    "it to dvl_lost",
                    memory.Named(), limit.Named())));
  }
}

}  // namespace

bool IsRuleOff(const MissionReading& reading, std::string_view rule) {
  return !reading.Launches(kSafetyApp) ||
         std::ranges::any_of(reading.FindAll(kSafetyApp, "off"),
                             [rule](const Setting& line) { return line.text == rule; });
}

void CheckDepthLimit(const MissionReading& reading, double deepest, MissionProblems& found) {
  if (IsRuleOff(reading, "depth_over_limit")) return;
  const Setting limit = *reading.Find(kSafetyApp, "depth_limit_m");
  if (limit.number() > deepest) return;
  found.geometry.push_back(limit.Refuse(
      fmt::format("`{}`: rule depth_over_limit would bring the vehicle up from its survey, which "
                  "goes as deep as {:.1f} m; allowed: more than that",
                  limit.text, deepest)));
}

void CheckSafety(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found) {
  if (!reading.Launches(kSafetyApp)) return;
  CheckOrder(reading, "battery_low_percent", "battery_critical_percent", false, found);
  CheckOrder(reading, "sigma_high_m", "sigma_limit_m", true, found);
  CheckOrder(reading, "dvl_silent_s", "dvl_lost_s", true, found);
  CheckOrder(reading, "detector_silent_s", "detector_lost_s", true, found);
  CheckOrder(reading, "disk_low_mib", "disk_full_mib", false, found);
  CheckAltitudeLimit(reading, survey, found);
  CheckTimeLimit(reading, found);
  CheckHomeLimit(reading, survey, found);
  CheckSeabedMemory(reading, found);
  for (const Setting& off : reading.FindAll(kSafetyApp, "off")) {
    if (off.is_default) continue;
    found.notes.push_back(off.Refuse(fmt::format("this mission does without rule {}", off.text)));
  }
}

}  // namespace limpet::internal

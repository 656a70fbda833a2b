// SPDX-License-Identifier: MIT
#include "limpet/safety_trials/trial_prop.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/letter_case.hpp"
#include "limpet/core/units.hpp"
#include "limpet/runs/mission_check.hpp"
#include "limpet/survey/mission_area.hpp"

namespace limpet {
namespace {

constexpr double kObstacleAhead_m = 8.0;  ///< of the start: well within a sonar's reach
constexpr double kZoneGap_m = 1.0, kZoneWidth_m = 8.0, kZoneOverhang_m = 40.0;

/// A behavior that stops the vehicle throughout the phase: one that still waits for its point.
void AddFailingBehavior(MissionFile& mission, const TrialPlaces& places, SafetyPhase phase) {
  const std::filesystem::path file = std::filesystem::absolute(places.scratch / "failing.bhv");
  std::ofstream(file) << fmt::format(
      "Behavior = BHV_AbortToPoint\n{{\n  name = failing\n  speed = 0.1\n  updates = "
      "FAILING_POINT\n"
      "  condition = SURVEY_PHASE = {}\n}}\n",
      WordOf(phase));
  AddLine(mission, "pHelm", {.key = "behaviors", .value = file.string(), .where = {}});
}

/// A strip north of the region, so that no plan minds it, and a vehicle that is swept northwards
/// crosses it.
void AddZone(MissionFile& mission, const TrialPlaces& places) {
  const Expected<SurveyArea, AreaProblem> area = AreaOf(
      ReadAppParams<SurveyParams>(mission, "pSurvey"), {.folder = places.mission_folder,
                                                        .latitude = mission.Global("LatOrigin"),
                                                        .longitude = mission.Global("LongOrigin")});
  if (!area) {
    throw ConfigError(
        {{.file = mission.file, .line = 0}, "pSurvey " + area.error().key, area.error().text});
  }
  const double south = area->north_max + area->margin + kZoneGap_m, north = south + kZoneWidth_m;
  const double west = area->east_min - kZoneOverhang_m, east = area->east_max + kZoneOverhang_m;
  AddLine(mission, "pSurvey",
          {.key = "keep_out",
           .value = fmt::format("pts={{{0:.1f},{2:.1f}:{1:.1f},{2:.1f}:{1:.1f},{3:.1f}:{0:.1f},"
                                "{3:.1f}}}",
                                west, east, south, north),
           .where = {}});
}

}  // namespace

std::string WordOf(SafetyPhase phase) { return UpperCase(NameOf(phase)); }

void AddLine(MissionFile& mission, std::string_view app, ConfigEntry line) {
  const auto block = std::ranges::find_if(mission.blocks, [app](const ConfigBlock& candidate) {
    return EqualsIgnoringCase(candidate.name, app);
  });
  if (block == mission.blocks.end()) {
    throw ConfigError(
        {{.file = mission.file, .line = 0}, std::string(app), "the mission has no such block"});
  }
  block->entries.push_back(std::move(line));
}

void AddProp(MissionFile& mission, const TrialPlaces& places, const SafetyCase& tested,
             SafetyPhase phase) {
  if (tested.prop == TrialProp::kFailingBehavior) AddFailingBehavior(mission, places, phase);
  if (tested.prop == TrialProp::kZone) AddZone(mission, places);
}

std::string PropLines(const Scenario& scenario, const SafetyCase& tested) {
  // Where a scenario has obstacles the sonar sees them, as a survey is there to be kept off them.
  if (tested.prop != TrialProp::kObstacle || !scenario.obstacles.empty()) return "";
  const Scenario::Start& start = scenario.start;
  const double heading = Radians::FromTextUnit(start.heading_deg).value();
  return fmt::format(
      "obstacles:\n  - {{name: prop, shape: column, north_m: {:.2f}, east_m: {:.2f}, radius_m: "
      "0.5, "
      "height_m: {:.1f}}}\n",
      start.north_m + kObstacleAhead_m * std::cos(heading),
      start.east_m + kObstacleAhead_m * std::sin(heading), scenario.seabed.depth_m + 1.0);
}

}  // namespace limpet

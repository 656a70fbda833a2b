// SPDX-License-Identifier: MIT
#include "limpet/safety_trials/trial_prop.hpp"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

constexpr const char* kMission =
    "LatOrigin = 43.7\nLongOrigin = 10.3\n"
    "ProcessConfig = pSurvey\n{\n  area_north_min_m = -10\n  area_north_max_m = 20\n"
    "  area_east_min_m = -5\n  area_east_max_m = 5\n  margin_m = 2\n"
    "  object_height_max_m = 2\n  altitude_m = 4\n}\n"
    "ProcessConfig = pHelm\n{\n  behaviors = mission.bhv\n}\n";

SafetyCase CaseWith(TrialProp prop) {
  SafetyCase tested;
  tested.prop = prop;
  return tested;
}

TEST(TrialProp, AZoneLiesBeyondTheRegionWhereNoPlanMindsIt) {
  MissionFile mission = ParseMission(kMission, "m.moos");
  AddProp(mission, {.mission_folder = ".", .scratch = "."}, CaseWith(TrialProp::kZone),
          SafetyPhase::kSurvey);
  EXPECT_EQ(mission.Block("pSurvey")->Find("keep_out")->value,
            "pts={-45.0,23.0:45.0,23.0:45.0,31.0:-45.0,31.0}");
}

TEST(TrialProp, AFailingBehaviorComesBesideThoseOfTheMission) {
  const TemporaryFolder scratch;
  MissionFile mission = ParseMission(kMission, "m.moos");
  AddProp(mission, {.mission_folder = ".", .scratch = scratch.path()},
          CaseWith(TrialProp::kFailingBehavior), SafetyPhase::kReturn);
  EXPECT_EQ(mission.Block("pHelm")->entries.size(), 2U);
  EXPECT_TRUE(std::filesystem::exists(mission.Block("pHelm")->entries.back().value));
}

TEST(TrialProp, AnObstacleStandsAheadOfTheStartUnlessThereAreSome) {
  Scenario scenario;
  scenario.start = {.north_m = 1.0, .east_m = 2.0, .heading_deg = 90.0};
  scenario.seabed.depth_m = 7.0;
  const std::string lines = PropLines(scenario, CaseWith(TrialProp::kObstacle));
  EXPECT_NE(lines.find("north_m: 1.00, east_m: 10.00"), std::string::npos) << lines;
  EXPECT_NE(lines.find("height_m: 8.0"), std::string::npos) << lines;
  EXPECT_EQ(PropLines(scenario, CaseWith(TrialProp::kNone)), "");
  scenario.obstacles.emplace_back();
  EXPECT_EQ(PropLines(scenario, CaseWith(TrialProp::kObstacle)), "");
}

TEST(TrialProp, ALineForABlockThatIsNotThereIsRefused) {
  MissionFile mission = ParseMission(kMission, "m.moos");
  EXPECT_THROW(AddLine(mission, "pSafety", {.key = "off", .value = "leak", .where = {}}),
               ConfigError);
}

}  // namespace
}  // namespace limpet

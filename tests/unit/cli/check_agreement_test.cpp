// SPDX-License-Identifier: MIT
// Facts that a mission says once for all, or in several blocks.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/config.hpp"
#include "limpet/mission/mission_file.hpp"
#include "limpet/preflight/preflight.hpp"
#include "limpet/runs/session_runner.hpp"
#include "tests/unit/cli/mission_copy.hpp"

namespace limpet {
namespace {

Edit BehaviorAltitude(const std::string& meters) {
  return {"mission.bhv", "#include", "#define ALTITUDE " + meters + "\n#include"};
}

class CheckAgreement : public ::testing::TestWithParam<Slip> {};

TEST_P(CheckAgreement, SaysWhatIsSaidTwice) { ExpectSaid(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Facts, CheckAgreement,
    ::testing::Values(
        Slip{"AltitudeOfTheBehaviorDiffers",
             {BehaviorAltitude("3")},
             3,
             {"plug_survey.bhv:",
              "altitude_m: the survey altitude is 3 m for altitude and 4 m for the mission: the "
              "mission survey_altitude_m = 4 (mission.moos:"}},
        Slip{"AltitudeOfTheHelmDiffers",
             {{PlugOf("pHelm"), "turning_radius_m", "survey_altitude_m = 3.5\n  turning_radius_m"}},
             3,
             {"plug_pHelm.moos:",
              "survey_altitude_m: the survey altitude is 3.5 m for pHelm and 4 m for the mission"}},
        Slip{"AltitudesInBlocksAloneDiffer",
             {{"mission.moos", "survey_altitude_m = 4", "#define ALTITUDE 4"},
              BehaviorAltitude("3")},
             3,
             {"altitude_m: the survey altitude is 3 m for altitude and 4 m for pSurvey"}},
        Slip{"BlocksAloneAreEnough",
             {{"mission.moos", "survey_altitude_m = 4", "#define ALTITUDE 4"},
              {"mission.moos", "object_radius_m   = 0.5", "#define OBJECT_RADIUS 0.5"},
              BehaviorAltitude("4")},
             0,
             {"no problems"}},
        Slip{"WhatABlockSaysAsTheMissionDoes",
             {{PlugOf("pHelm"), "turning_radius_m", "survey_altitude_m = 4.0\n  turning_radius_m"}},
             0,
             {"no problems"}},
        Slip{"ASlipInAGlobal",
             {{"mission.moos", "survey_altitude_m = 4", "survey_altitud_m = 4"}},
             2,
             {"nothing reads this global; did you mean `survey_altitude_m`?"}},
        Slip{"ScenariosDiffer",
             {{PlugOf("uSimSensors"), "scenario = scenario.yaml", "scenario = other.yaml"}},
             3,
             {"scenario: the scenario is other.yaml for uSimSensors and scenario.yaml for "
              "uSimVehicle"}},
        Slip{"WhenAnObjectIsSettledDiffers",
             {{"mission.moos", "ServerPort", "settled_looks = 3\nServerPort"},
              {"../plugs/plug_survey.bhv", "  name      = revisit",
               "  name      = revisit\n  settled_looks = 4"}},
             3,
             {"when an object is settled is 4 for revisit and 3 for the mission"}},
        Slip{"WhenAnObjectIsSettledIsSaidOnce",
             {{"mission.moos", "ServerPort", "settled_looks = 3\nServerPort"}},
             0,
             {"no problems"}},
        Slip{"CamerasDiffer",
             {{PlugOf("pMap"), "  #include plug_camera.moos",
               "  camera_fov_across_deg = 60\n  camera_fov_along_deg = 45\n"
               "  camera_width_px = 640\n  camera_height_px = 480"}},
             3,
             {"camera_fov_across_deg: the camera is", "60 deg for pMap", "80 deg",
              "camera_fov_along_deg"}},
        Slip{"RadiiDiffer",
             {{PlugOf("pNav"), "AppTick = 10", "AppTick = 10\n  opi_radius_m = 0.3"}},
             3,
             {"the objects' radius is 0.3 m for pNav and 0.5 m for the mission"}},
        Slip{"RadiusUnknownToNavigation",
             {{PlugOf("pNav"), "AppTick = 10", "AppTick = 10\n  opi_radius_m = 0"}},
             0,
             {"no problems"}}),
    [](const auto& slip) { return slip.param.name; });

/// What is wrong with table1, whose file says its altitude once, with these `--set`.
std::vector<ConfigProblem> GeometryWith(const std::vector<std::string>& settings) {
  const std::filesystem::path folder = std::filesystem::path(LIMPET_SOURCE_DIR) / "missions/table1";
  MissionFile mission = LoadMission(folder / "mission.moos");
  for (const std::string& setting : settings) {
    ApplySetting(mission, setting);
  }
  const MissionProblems found = CheckLoadedMission(mission, folder);
  EXPECT_TRUE(found.syntax.empty());
  return found.geometry;
}

TEST(CheckAgreementOfSettings, OverrideAGlobalForAllWhoTakeItOrNotAtAll) {
  const std::vector<ConfigProblem> one = GeometryWith({"pSurvey.altitude_m=3.5"});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].where.file, "--set pSurvey.altitude_m=3.5");
  EXPECT_THAT(one[0].text, ::testing::HasSubstr("3.5 m for pSurvey and 4 m for the mission"));
  EXPECT_EQ(GeometryWith({"altitude.altitude_m=3.5"}).size(), 1U);
  EXPECT_TRUE(GeometryWith({"pSurvey.altitude_m=3.5", "pHelm.survey_altitude_m=3.5",
                            "altitude.altitude_m=3.5"})
                  .empty());
}

}  // namespace
}  // namespace limpet

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
#include "tests/support/mission_copy.hpp"

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
        Slip{"DetectorKeepsWhatNavigationWouldUse",
             {{PlugOf("pDetect"), "detector =", "min_confidence = 0.6\n  detector ="}},
             0,
             {"note: min_confidence: boxes below 0.6 are not published, so that pNav "
              "min_confidence = 0.45 ("}},
        Slip{"ASlipInAGlobal",
             {{"mission.moos", "survey_altitude_m = 4", "survey_altitud_m = 4"}},
             2,
             {"nothing reads this global; did you mean `survey_altitude_m`?"}},
        Slip{"ScenariosDiffer",
             {{PlugOf("uSimSensors"), "$(SCENARIO=scenario.yaml)", "other.yaml"}},
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
        Slip{"ACameraThatIsNotTheVehicles",
             {{PlugOf("pMap"), "  #include plug_camera.moos",
               "  camera_fov_across_deg = 60\n  camera_fov_along_deg = 45"}},
             3,
             {"plug_pMap.moos:",
              "camera_fov_across_deg: the vehicle's camera.fov_across_deg is 60 "
              "deg for pMap and 80 deg for the vehicle's file: ",
              "camera.fov_across_deg = 80 (feelhippo.yaml:", "camera_fov_along_deg"}},
        Slip{"ACameraAsTheVehiclesFileSaysIt",
             {{"mission.moos", "ServerHost",
               "#define FOV_ACROSS 80.0\n#define FOV_ALONG 60\nServerHost"},
              {PlugOf("uSimCamera"), "scenario =", "rate_hz = 4\n  scenario ="}},
             0,
             {"no problems"}},
        Slip{"AnotherRateOfTheCamera",
             {{PlugOf("uSimCamera"), "scenario =", "rate_hz = 2\n  scenario ="}},
             3,
             {"rate_hz: the vehicle's camera.rate_hz is 2 hz for uSimCamera and 4 hz"}},
        Slip{"ACompassAsTheVehiclesFileSaysIt",
             {{"mission.moos", "ServerHost", "#define HEADING_SIGMA 0.5\nServerHost"},
              {PlugOf("pNav"), "AppTick = 10", "AppTick = 10\n  dvl_x_m = -0.20"}},
             0,
             {"no problems"}},
        Slip{"ACompassThatIsNotTheVehicles",
             {{"mission.moos", "ServerHost", "#define HEADING_SIGMA 1\nServerHost"}},
             2,
             {"heading_sigma_deg: `1`: the vehicle's file says it, and says 0.5 (",
              "feelhippo.yaml:", "imu.heading_sigma_deg"}},
        Slip{"ADvlThatIsNotTheVehicles",
             {{PlugOf("pNav"), "AppTick = 10", "AppTick = 10\n  dvl_z_m = 0.3"}},
             2,
             {"dvl_z_m: `0.3`: the vehicle's file says it, and says 0.18 (", "dvl.at_m"}},
        Slip{
            "ATopSpeedThatIsNotTheVehicles",
            {{PlugOf("pNav"), "AppTick = 10", "AppTick = 10\n  top_speed_mps = 2"}},
            2,
            {"top_speed_mps: `2`: the vehicle's file says it, and says 1 (", "hull.top_speed_mps"}},
        Slip{"ALengthThatIsNotTheVehicles",
             {{PlugOf("pNodeReporter"), "platform_type = uuv",
               "platform_type = uuv\n  platform_length = 1.3"}},
             3,
             {"platform_length: the vehicle's hull.length_m is 1.3 m for pNodeReporter and 0.6 m"}},
        Slip{"ALengthByItsOlderNameAsTheVehiclesFileSaysIt",
             {{PlugOf("pNodeReporter"), "platform_type = uuv",
               "platform_type = uuv\n  vessel_length = 0.60"}},
             0,
             {"no problems"}},
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

TEST(SettingOfAGlobal, AnotherVehicleReachesEveryBlock) {
  const std::filesystem::path folder = std::filesystem::path(LIMPET_SOURCE_DIR) / "missions/table1";
  MissionFile mission = LoadMission(folder / "mission.moos");
  ApplySetting(mission, "VehicleFile=bluerov2.yaml");
  for (const char* app : {"pHelm", "pMap", "pNav", "uSimCamera"}) {
    EXPECT_EQ(mission.Block(app)->Find("camera_fov_across_deg")->value, "60") << app;
  }
  EXPECT_TRUE(GeometryWith({"VehicleFile=bluerov2.yaml"}).empty());
}

TEST(SettingOfAGlobal, ReachesWhoTakesIt) {
  EXPECT_TRUE(GeometryWith({"survey_altitude_m=3.5"}).empty());
  EXPECT_FALSE(GeometryWith({"survey_altitude_m=9"}).empty());
}

TEST(SettingOfAGlobal, ThatTheMissionHasNotNamesTheNearest) {
  MissionFile mission =
      LoadMission(std::filesystem::path(LIMPET_SOURCE_DIR) / "missions/table1/mission.moos");
  try {
    ApplySetting(mission, "VehicelFile=bluerov2.yaml");
    FAIL() << "took a global that nothing reads";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("did you mean `VehicleFile`?"));
  }
}

TEST(SettingOfAFormerParameter, NamesTheVehiclesKey) {
  MissionFile mission =
      LoadMission(std::filesystem::path(LIMPET_SOURCE_DIR) / "missions/table1/mission.moos");
  ApplySetting(mission, "pNav.heading_sigma_deg=2");
  ASSERT_EQ(mission.Block("pNav")->problems.size(), 1U);
  EXPECT_THAT(mission.Block("pNav")->problems[0].Format(),
              ::testing::HasSubstr("imu.heading_sigma_deg"));
}

}  // namespace
}  // namespace limpet

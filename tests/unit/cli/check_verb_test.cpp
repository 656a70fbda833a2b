// SPDX-License-Identifier: MIT
// `limpet check` on copies of missions/table1, each with one slip.
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/cli/mission_copy.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

struct Slip {
  std::string name;
  std::vector<Edit> edits;
  int exit_code = 0;
  std::vector<std::string> says;
};

std::ostream& operator<<(std::ostream& out, const Slip& slip) { return out << slip.name; }

class CheckVerb : public ::testing::TestWithParam<Slip> {};

TEST_P(CheckVerb, SaysWhatIsWrong) {
  const MissionCopy mission;
  for (const Edit& edit : GetParam().edits) {
    mission.Apply(edit);
  }
  const Checked checked = mission.Run();
  EXPECT_EQ(checked.exit_code, GetParam().exit_code) << checked.text;
  for (const std::string& text : GetParam().says) {
    EXPECT_THAT(checked.text, HasSubstr(text));
  }
}

const std::string kMoos = "mission.moos";
const std::string kBhv = "../plugs/plug_survey.bhv";
const std::string kAntler = PlugOf("ANTLER");
const std::string kMap = PlugOf("pMap");
const std::string kSurvey = PlugOf("pSurvey");
const std::string kHelm = PlugOf("pHelm");
const std::string kTruth = "scenario.yaml";

Edit Altitude(const std::string& meters) {
  return {kMoos, "#define ALTITUDE 4", "#define ALTITUDE " + meters};
}
Edit BehaviorAltitude(const std::string& meters) {
  return {"mission.bhv", "#define ALTITUDE 4", "#define ALTITUDE " + meters};
}
Edit Without(const std::string& line, const std::string& file = kMoos) {
  return {file, line + "\n", ""};
}

INSTANTIATE_TEST_SUITE_P(
    Mission, CheckVerb,
    ::testing::Values(Slip{"AnUntouchedMission", {}, 0, {"no problems\n"}},
                      Slip{"AnUnusedBlock",
                           {{kMoos, "#include plug_survey",
                             "ProcessConfig = pShare\n{\n}\n#include plug_survey"}},
                           0,
                           {"no problems, 1 note", "is not launched"}},
                      Slip{"AForeignApp",
                           {{kAntler, "  Run = pLog ", "  Run = iGripper\n  Run = pLog "}},
                           0,
                           {"note: iGripper: is no app of Limpet's"}}),
    [](const auto& slip) { return slip.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Syntax, CheckVerb,
    ::testing::Values(
        Slip{"ABlockThatForgetsItsArea",
             {Without("  area_north_max_m    = $(AREA_NORTH_MAX)", kSurvey)},
             2,
             {"area_north_max_m: is missing in pSurvey and has no default"}},
        Slip{"ABlockThatForgetsTheCamera",
             {Without("  #include plug_camera.moos", kMap)},
             2,
             {"camera_fov_across_deg: is missing in pMap"}},
        Slip{"ABehaviorThatForgetsItsAltitude",
             {Without("  altitude_m = $(ALTITUDE)", kBhv)},
             2,
             {"plug_survey.bhv:", "altitude_m: is missing in BHV_HoldAltitude"}},
        Slip{"ABehaviorThatForgetsItsSpeed",
             {Without("  speed_mps = $(SPEED=0.5)", kBhv)},
             2,
             {"speed_mps: is missing"}},
        Slip{"AMisspeltBlock",
             {{kSurvey, "ProcessConfig = pSurvey", "ProcessConfig = pSurvy"}},
             2,
             {"ProcessConfig: `pSurvy` is the name of no process", "did you mean `pSurvey`?"}},
        Slip{"AnotherMisspeltBlock",
             {{PlugOf("pDetect"), "ProcessConfig = pDetect", "ProcessConfig = pDetct"}},
             2,
             {"did you mean `pDetect`?"}},
        Slip{"AMisspeltAntler",
             {{kAntler, "ProcessConfig = ANTLER", "ProcessConfig = ANTLR"}},
             2,
             {"did you mean `ANTLER`?", "ANTLER: is missing"}},
        Slip{"AMisspeltProgram",
             {{kAntler, "Run = pSurvey ", "Run = pSurvy "}},
             2,
             {"Run: no app `pSurvy`; nearest known: `pSurvey`"}},
        Slip{"AProgramWithTwoLettersSwapped",
             {{kAntler, "Run = pHelm ", "Run = pHlem "}},
             2,
             {"no app `pHlem`; nearest known: `pHelm`"}},
        Slip{"AMisspeltGlobal",
             {{kMoos, "LatOrigin ", "LatOrgin "}},
             2,
             {"LatOrgin: nothing reads this global; did you mean `LatOrigin`?"}},
        Slip{"AnotherMisspeltGlobal",
             {{kMoos, "ServerPort ", "ServrPort "}},
             2,
             {"did you mean `ServerPort`?"}},
        Slip{"AMissingDatum",
             {Without("LongOrigin   = 10.2830")},
             2,
             {"LongOrigin: this global is missing"}},
        Slip{"AMissingCommunity",
             {Without("Community    = limpet")},
             2,
             {"Community: this global is missing"}},
        Slip{"AMissingVehicle",
             {Without("VehicleFile = $(VEHICLE_FILE=feelhippo.yaml)", PlugOf("survey"))},
             2,
             {"VehicleFile: pPilot needs this global", "bluerov2.yaml, feelhippo.yaml"}},
        Slip{"AnUnknownVehicle",
             {{kMoos, "Community    = limpet",
               "Community    = limpet\n#define VEHICLE_FILE dolphin.yaml"}},
             2,
             {"VehicleFile: there is no `dolphin.yaml`; known: bluerov2.yaml, feelhippo.yaml"}},
        Slip{"ADatumOffTheEarth",
             {{kMoos, "43.7210", "143.7"}},
             2,
             {"LatOrigin: `143.7` is not allowed; allowed: -90 to 90"}},
        Slip{"NoNavigation",
             {Without("  Run = pNav        @ NewConsole = false", kAntler)},
             2,
             {"pNav is not launched: nobody writes", "NAV_STATE", "pHelm"}},
        Slip{"NoPilot",
             {Without("  Run = pPilot      @ NewConsole = false", kAntler)},
             2,
             {"pPilot is not launched: nobody writes THRUSTER_COMMAND, needed by uSimVehicle"}},
        Slip{"NoMissionManager",
             {Without("  Run = pSurvey     @ NewConsole = false", kAntler)},
             2,
             {"pSurvey is not launched", "SURVEY_PHASE"}},
        Slip{"NoHelm",
             {Without("  Run = pHelm       @ NewConsole = false", kAntler)},
             2,
             {"pHelm is not launched"}},
        Slip{"NoDetector",
             {Without("  Run = pDetect     @ NewConsole = false", kAntler)},
             2,
             {"pDetect is not launched: uSimCamera renders images"}},
        Slip{"NoSensors",
             {Without("  Run = uSimSensors @ NewConsole = false", kAntler)},
             2,
             {"uSimSensors is not launched"}},
        Slip{"AppTickZero",
             {{PlugOf("pNav"), "AppTick = 10", "AppTick = 0"}},
             2,
             {"AppTick: `0` is not allowed; allowed: 0.01 to 1000 Hz"}},
        Slip{"AppTickNegative",
             {{PlugOf("pNav"), "AppTick = 10", "AppTick = -4"}},
             2,
             {"AppTick: `-4` is not allowed"}},
        Slip{"AppTickNan",
             {{PlugOf("pNav"), "AppTick = 10", "AppTick = nan"}},
             2,
             {"AppTick: `nan` is not allowed"}},
        Slip{"AppTickOfAnEternity",
             {{PlugOf("pNav"), "AppTick = 10", "AppTick = 1e-9"}},
             2,
             {"AppTick: `1e-9` is not allowed"}},
        Slip{"ADomainWithoutPoints",
             {{kHelm, "depth:$(DEPTH_DOMAIN=0:20:201)", "depth:0:20:0"}},
             2,
             {"domain: `depth:0:20:0` has 0 points; allowed: a whole number, at least 2"}},
        Slip{"ADomainUpsideDown",
             {{kHelm, "depth:$(DEPTH_DOMAIN=0:20:201)", "depth:20:0:201"}},
             2,
             {"low below high"}},
        Slip{"ADomainThatIsMissing",
             {Without("  domain    = speed:0:1:21", kHelm)},
             2,
             {"domain: `speed` is missing"}},
        Slip{"ADomainMisspelt",
             {{kHelm, "speed:0:1:21", "sped:0:1:21"}},
             2,
             {"did you mean `speed`?"}},
        Slip{"ABehaviorFileThatIsNotThere",
             {{kHelm, "behaviors = mission.bhv", "behaviors = misson.bhv"}},
             2,
             {"plug_pHelm.moos:", "behaviors: `misson.bhv` cannot be read"}},
        Slip{"ABehaviorFileWithoutBehaviors",
             {{kBhv, "Behavior = BHV_CoverArea", "#ifdef NEVER\nBehavior = BHV_CoverArea"},
              {kBhv, "  depth     = 0\n}", "  depth     = 0\n}\n#endif"}},
             2,
             {"mission.bhv: has no behavior"}},
        Slip{"AScenarioThatIsNotThere",
             {{PlugOf("uSimVehicle"), "scenario = scenario.yaml", "scenario = other.yaml"}},
             2,
             {"scenario: `other.yaml` cannot be read"}}),
    [](const auto& slip) { return slip.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Agreement, CheckVerb,
    ::testing::Values(
        Slip{"AltitudeOfTheBehaviorDiffers",
             {BehaviorAltitude("3")},
             3,
             {"plug_survey.bhv:",
              "altitude_m: the survey altitude is 3 m for altitude and 4 m for pSurvey",
              "plug_pSurvey.moos:"}},
        Slip{"AltitudeOfTheHelmDiffers",
             {{kHelm, "survey_altitude_m = $(ALTITUDE)", "survey_altitude_m = 3.5"}},
             3,
             {"survey_altitude_m: the survey altitude is 3.5 m for pHelm and 4 m for pSurvey"}},
        Slip{"CamerasDiffer",
             {{kMap, "  #include plug_camera.moos",
               "  camera_fov_across_deg = 60\n  camera_fov_along_deg = 45\n"
               "  camera_width_px = 640\n  camera_height_px = 480"}},
             3,
             {"camera_fov_across_deg: the camera is", "60 deg for pMap", "80 deg",
              "camera_fov_along_deg"}},
        Slip{"RadiiDiffer",
             {{PlugOf("pNav"), "opi_radius_m = $(OBJECT_RADIUS)", "opi_radius_m = 0.3"}},
             3,
             {"the objects' radius is 0.3 m for pNav and 0.5 m for pMap"}},
        Slip{"RadiusUnknownToNavigation",
             {{PlugOf("pNav"), "opi_radius_m = $(OBJECT_RADIUS)", "opi_radius_m = 0"}},
             0,
             {"no problems"}}),
    [](const auto& slip) { return slip.param.name; });

INSTANTIATE_TEST_SUITE_P(
    View, CheckVerb,
    ::testing::Values(
        Slip{"TooHighToSee",
             {Altitude("8"), BehaviorAltitude("8"), {kTruth, "depth_m: 7.5", "depth_m: 15"}},
             3,
             {"altitude_m: from 8 m nothing is seen", "highest_view_m = 6.5 (default)",
              "up to 6.5 m"}},
        Slip{"TooHighByTheMissionsOwnWord",
             {{kMap, "  #include plug_camera.moos\n",
               "  #include plug_camera.moos\n  highest_view_m = 3.9\n"}},
             3,
             {"from 4 m nothing is seen", "highest_view_m = 3.9 ("}},
        Slip{"TooHighForTheWater",
             {{kTruth, "visibility_m: 8", "visibility_m: 2.5"}},
             3,
             {"the seabed is not seen in water of visibility_m 2.5", "scenario.yaml:3"}},
        Slip{"ObjectsAsHighAsTheVehicle",
             {{kMoos, "#define BAND 2.0", "#define BAND 3.8"}},
             3,
             {"object_height_max_m: objects may reach 4.3 m above the seabed"}},
        Slip{"TooFewPixels",
             {{"../plugs/plug_camera.moos", "= 640", "= 64"},
              {"../plugs/plug_camera.moos", "= 480", "= 64"}},
             3,
             {"the detector finds none below 9 px"}},
        Slip{"TooFewFrames",
             {{PlugOf("uSimCamera"), "rate_hz  = 4", "rate_hz  = 0.3"}},
             3,
             {"frames of a pass"}}),
    [](const auto& slip) { return slip.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Depth, CheckVerb,
    ::testing::Values(
        Slip{
            "DeeperThanTheDomain",
            {{kTruth, "depth_m: 7.5", "depth_m: 30"}},
            3,
            {"`depth:0:20:201`: the seabed is as deep as 30", "allowed: a domain to 27 m or more"}},
        Slip{"SlopesDeeperThanTheDomain",
             {{kTruth, "slope_deg: 0", "slope_deg: 30"},
              {kHelm, "depth:$(DEPTH_DOMAIN=0:20:201)", "depth:0:10:101"}},
             3,
             {"`depth:0:10:101`: the seabed is as deep as 16.3 m",
              "allowed: a domain to 13 m or more"}},
        Slip{"ADomainWithoutTheSurface",
             {{kHelm, "depth:$(DEPTH_DOMAIN=0:20:201)", "depth:1:20:201"}},
             3,
             {"has no 0 m: the vehicle could not come up", "depth: `0` is outside of the helm's"}},
        Slip{"BeyondTheReachOfTheDvl",
             {{kTruth, "depth_m: 7.5", "depth_m: 60"},
              {kHelm, "depth:$(DEPTH_DOMAIN=0:20:201)", "depth:0:100:201"}},
             3,
             {"the DVL reaches 50 m"}},
        Slip{"SeabedAboveTheSurface",
             {{kTruth, "slope_deg: 0", "slope_deg: 30"}},
             3,
             {"scenario.yaml:2: seabed: rises", "above the surface at north -15"}},
        Slip{"TooShallowForTheAltitude",
             {{kTruth, "depth_m: 7.5", "depth_m: 4.4"},
              {kTruth, "5.5],    change: [4, 1, 5.5]", "3.5],    change: [4, 1, 3.5]"},
              {kTruth, "[2, 10, 7]", "[2, 10, 4]"},
              {kTruth, "[6, -3, 5.5]", "[6, -3, 3.5]"},
              {kTruth, "[-6, -5, 6.5],  change: [-6, -5, 6.5]",
               "[-6, -5, 3.5],  change: [-6, -5, 3.5]"},
              {kTruth, "[-3, 11, 6]", "[-3, 11, 4]"}},
             3,
             {"needs more than 4.5 m of water"}},
        Slip{"FasterThanTheDomain",
             {{kBhv, "speed_mps = $(SPEED=0.5)", "speed_mps = 1.5"}},
             3,
             {"speed_mps: `1.5` is outside of the helm's", "allowed: 0 to 1 mps"}},
        Slip{"ASpeedDomainWithoutZero",
             {{kHelm, "speed:0:1:21", "speed:0.2:1:21"}},
             3,
             {"has no 0 m/s"}}),
    [](const auto& slip) { return slip.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Area, CheckVerb,
    ::testing::Values(
        Slip{"AThousandKilometres",
             {{kMoos, "#define AREA_NORTH_MAX 15", "#define AREA_NORTH_MAX 1000000"},
              {kMoos, "#define AREA_EAST_MAX 18", "#define AREA_EAST_MAX 1000000"}},
             3,
             {"area_north_max_m: an area of 1000015 x 1000018 m", "allowed: 4e+06 cells"}},
        Slip{"AnAreaInsideOut",
             {{kMoos, "#define AREA_NORTH_MAX 15", "#define AREA_NORTH_MAX -20"}},
             3,
             {"area_north_max_m: `-20` leaves no area; allowed: above pSurvey area_north_min_m = "
              "-15"}},
        Slip{"NoRoomToTurn",
             {{kMoos, "#define ALTITUDE", "#define TURNING_RADIUS 20\n#define ALTITUDE"}},
             3,
             {"turning_radius_m: area and margin leave 33.2 m", "allowed: up to 16.60 m"}},
        Slip{"TurnsTooTight",
             {{PlugOf("pPilot"), "ProcessConfig = pPilot\n{\n",
               "ProcessConfig = pPilot\n{\n  max_turn_rate_degps = 4\n"}},
             3,
             {"too fast for turns of pHelm turning_radius_m = 3"}},
        Slip{"AnObjectOutside",
             {{kTruth, "[2, 10, 7]", "[2, 40, 7]"}},
             3,
             {"OPI 2: discovery [2, 40] is outside the area"}},
        Slip{"AnObjectThatFloatsTooHigh",
             {{kTruth, "[2, 10, 7]", "[2, 10, 4.6]"}},
             3,
             {"OPI 2: discovery floats 2.8", "object_height_max_m = 2.0"}},
        Slip{"AnObjectInTheWay",
             {{kTruth, "[2, 10, 7]", "[2, 10, 3.5]"}},
             3,
             {"where the vehicle flies: pSurvey altitude_m = 4 ("}},
        Slip{"CellsThatTheHelmDoesNotKnow",
             {{kMap, "  #include plug_camera.moos\n",
               "  #include plug_camera.moos\n  cell_m = 1\n"}},
             3,
             {"cell_m: pHelm mirrors the map with cells of 0.25 m"}},
        Slip{"VoxelsLargerThanObjects",
             {{kMap, "  #include plug_camera.moos\n",
               "  #include plug_camera.moos\n  voxel_m = 1.5\n"}},
             3,
             {"voxel_m: a voxel of 1.5 m is larger than an object"}}),
    [](const auto& slip) { return slip.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Endurance, CheckVerb,
    ::testing::Values(
        Slip{"LongerThanItsTime",
             {{kSurvey, "  coverage_kind", "  max_time_s = 900\n  coverage_kind"}},
             3,
             {"max_time_s: the survey takes about", "m of lanes", "or more"}},
        Slip{"LargerThanItsTime",
             {{kMoos, "#define AREA_NORTH_MAX 15", "#define AREA_NORTH_MAX 300"}},
             3,
             {"max_time_s = 5400 (default) ends it"}},
        Slip{"LongerThanItsRange",
             {{kBhv, "range_m   = $(RANGE=5000)", "range_m   = 300"}},
             3,
             {"plug_survey.bhv:", "range_m: home_in_time range_m = 300", "allowed: "}},
        Slip{"TightTime",
             {{kSurvey, "  coverage_kind", "  max_time_s = 1300\n  coverage_kind"}},
             0,
             {"note: max_time_s: is tight"}},
        Slip{"AStartFarAway",
             {{kTruth, "north_m: -12.5", "north_m: -3000"}},
             3,
             {"give_up_s: the way home from the far corner", "max_time_s"}},
        Slip{"AStartNearBy",
             {{kTruth, "north_m: -12.5", "north_m: -60"}},
             0,
             {"note: start: is 45 m outside the area"}},
        Slip{"ACurrentThatCarriesItAway",
             {{kTruth, "current_north_mps: 0", "current_north_mps: 2"}},
             3,
             {"scenario.yaml:3: water: a current of 2.00 m/s carries the vehicle away"}},
        Slip{"ACurrentAsFastAsTheVehicle",
             {{kTruth, "current_east_mps: 0", "current_east_mps: -0.5"}},
             3,
             {"a current of 0.50 m/s"}},
        Slip{"ACurrentThatItCanTake",
             {{kTruth, "current_east_mps: 0", "current_east_mps: 0.15"}},
             0,
             {"no problems\n"}}),
    [](const auto& slip) { return slip.param.name; });

}  // namespace
}  // namespace limpet

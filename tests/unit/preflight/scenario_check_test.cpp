// SPDX-License-Identifier: MIT
// A scenario that says what no run of its mission would show.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/mission_copy.hpp"

namespace limpet {
namespace {

/// Lines before what the scenario has.
Edit Truth(const std::string& lines) { return {kTruth, "seabed:", lines + "\nseabed:"}; }

Edit OtherVehicle() {
  return {kMoos, "ServerHost", "#define VEHICLE_FILE bluerov2.yaml\nServerHost"};
}

Edit Boxes() { return {kTruth, "camera:  rendered", "camera:  boxes"}; }

Edit InWater(const std::string& keys) {
  return {kTruth, "visibility_m: 8,", "visibility_m: 8, " + keys};
}

class ScenarioCheck : public ::testing::TestWithParam<Slip> {};

TEST_P(ScenarioCheck, NotesWhatNoRunWouldShow) { ExpectSaid(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Idle, ScenarioCheck,
    ::testing::Values(
        Slip{"ATideWithoutAPeriod",
             {InWater("tide_swing_deg: 40,"),
              {kTruth, "current_north_mps: 0", "current_north_mps: 0.1"}},
             0,
             {"water.tide_swing_deg: `40` is without effect: tide_period_s is 0"}},
        Slip{"ATideOfStillWater",
             {InWater("tide_period_s: 900, tide_share: 0.5,")},
             0,
             {"water.tide_share: `0.5` is without effect: the mean current is 0"}},
        Slip{"AGyroThatTheVehicleLacks",
             {Truth("errors: {fog: {scale_error: 0.01}}"), OtherVehicle()},
             0,
             {"errors.fog.scale_error: `0.01` is without effect: the vehicle has no fibre-optic"}},
        Slip{"AFaultOfAGyroThatTheVehicleLacks",
             {Truth("faults: [{what: fog_silent}]"), OtherVehicle()},
             0,
             {"faults: `fog_silent` is without effect: the vehicle has no fibre-optic gyro"}},
        Slip{"LateByHowMuchAndNeverLate",
             {Truth("errors: {gps: {late_s: 2}}")},
             0,
             {"errors.gps.late_s: `2` is without effect: late_share is 0"}},
        Slip{
            "JumpsThatNeverCome",
            {Truth("errors:\n  dvl: {late_share: 0.1}\n  gps: {jump_m: 30}")},
            0,
            {"scenario.yaml:4: note: errors.gps.jump_m: `30` is without effect: jumps_per_h is 0"}},
        Slip{"TheWatersTideAndNotThePictures",
             {Truth("image: {look: real, water: {dissolved: 1}}"), InWater("tide_share: 0.5,")},
             0,
             {"scenario.yaml:4: note: water.tide_share: `0.5` is without effect"}},
        Slip{"PlainPicturesOfGravel",
             {Truth("image: {seabed: {kind: gravel}}")},
             0,
             {"image.seabed.kind: `gravel` is without effect: it shows only with"}},
        Slip{"PicturesThatNobodyTakes",
             {Truth("image: {look: real}"), Boxes()},
             0,
             {"image.look: `real` is without effect: a camera of boxes renders no pictures"}},
        Slip{"TheTiltOfABall",
             {{kTruth, "radius_m: 0.5,", "radius_m: 0.5, tilt_deg: 20,"}},
             0,
             {"opis[0].tilt_deg: `20` is without effect: shape is sphere"}}),
    [](const auto& slip) { return slip.param.name; });

TEST(ScenarioCheckTest, SaysNothingOfWhatShows) {
  const MissionCopy mission;
  mission.Apply(
      Truth("errors: {fog: {drift_deg_per_h: 3, drift_time_s: 600}, gps: {late_share: "
            "0.1, late_s: 2}}\nimage: {look: real, seabed: {kind: gravel}}"));
  mission.Apply({kTruth, "current_north_mps: 0", "current_north_mps: 0.1"});
  mission.Apply(InWater("tide_period_s: 900, tide_swing_deg: 40,"));
  EXPECT_THAT(mission.Run().text, ::testing::Not(::testing::HasSubstr("without effect")));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/mission/vehicle_settings.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/camera_params.hpp"
#include "limpet/mission/mission_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class VehicleSettings : public ::testing::Test {
 protected:
  void Say(const std::string& file, const std::string& text) {
    std::ofstream(folder_.path() / file) << text;
  }
  MissionFile Read(const std::string& text) {
    return ReadMission("VehicleFile = v.yaml\n" + text, (folder_.path() / "m.moos").string(), {});
  }
  static std::string ValueIn(const MissionFile& mission, const char* block, const char* key) {
    const ConfigEntry* entry = mission.Block(block)->Find(key);
    return entry != nullptr ? entry->value : "";
  }
  TemporaryFolder folder_;
};

TEST_F(VehicleSettings, ReachEveryBlockThatTakesThem) {
  Say("v.yaml", "camera:\n  fov_across_deg: 70\n  at_m: [0.1, 0, 0.2]\n  rate_hz: 5\n");
  const MissionFile mission =
      Read("ProcessConfig = pMap\n{\n}\nProcessConfig = uSimCamera\n{\n}\n");
  EXPECT_EQ(ValueIn(mission, "pMap", "camera_fov_across_deg"), "70");
  EXPECT_EQ(ValueIn(mission, "pMap", "camera_at_m"), "[0.1, 0, 0.2]");
  EXPECT_EQ(ValueIn(mission, "pMap", "rate_hz"), "");
  EXPECT_EQ(ValueIn(mission, "uSimCamera", "rate_hz"), "5");
  EXPECT_EQ(mission.Block("pMap")->Find("camera_at_m")->where.line, 3);
  EXPECT_THAT(mission.Block("pMap")->Find("camera_at_m")->where.file, HasSubstr("v.yaml"));
}

TEST_F(VehicleSettings, LeaveABlockItsOwnWord) {
  Say("v.yaml", "camera: {fov_across_deg: 70}\n");
  const MissionFile mission = Read("ProcessConfig = pMap\n{\n  camera_fov_across_deg = 60\n}\n");
  EXPECT_EQ(ValueIn(mission, "pMap", "camera_fov_across_deg"), "60") << "the check refuses it";
}

TEST_F(VehicleSettings, OfTheFileThatThisOneIsBasedOnCountWhereItSaysNothing) {
  Say("base.yaml", "camera: {fov_across_deg: 70, width_px: 800}\n");
  Say("v.yaml", "based_on: base.yaml\ncamera: {width_px: 320}\n");
  const MissionFile mission = Read("ProcessConfig = pMap\n{\n}\n");
  EXPECT_EQ(ValueIn(mission, "pMap", "camera_fov_across_deg"), "70");
  EXPECT_EQ(ValueIn(mission, "pMap", "camera_width_px"), "320");
  EXPECT_EQ(mission.fact_files.size(), 2U);
}

TEST_F(VehicleSettings, AReportedLengthIsTheHulls) {
  Say("v.yaml", "hull: {length_m: 0.457, top_speed_mps: 1.5}\n");
  const MissionFile mission = Read("ProcessConfig = pNodeReporter\n{\n  platform_beam = 0.3\n}\n");
  EXPECT_EQ(ValueIn(mission, "pNodeReporter", "platform_length"), "0.457");
  EXPECT_EQ(ValueIn(mission, "pNodeReporter", "platform_beam"), "0.3");
}

TEST_F(VehicleSettings, AFormerParameterThatSaysTheSameIsDropped) {
  Say("v.yaml", "imu: {heading_sigma_deg: 1}\ndvl: {at_m: [-0.3, 0, 0.2]}\n");
  const MissionFile mission =
      Read("ProcessConfig = pNav\n{\n  heading_sigma_deg = 1.0\n  dvl_x_m = -0.3\n}\n");
  EXPECT_THAT(mission.Block("pNav")->entries, IsEmpty());
  EXPECT_THAT(mission.Block("pNav")->problems, IsEmpty());
}

TEST_F(VehicleSettings, AFormerParameterThatSaysSomethingElseIsAProblemThatNamesTheKey) {
  Say("v.yaml", "dvl: {at_m: [-0.3, 0, 0.2]}\n");
  const MissionFile mission =
      Read("ProcessConfig = pNav\n{\n  heading_sigma_deg = 1.0\n  dvl_z_m = 0.25\n}\n");
  const std::vector<ConfigProblem>& problems = mission.Block("pNav")->problems;
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_THAT(problems[0].Format(), HasSubstr("m.moos:4: heading_sigma_deg: `1.0`: the vehicle's "
                                              "file says it, by its key imu.heading_sigma_deg"));
  EXPECT_THAT(problems[1].Format(), HasSubstr("dvl_z_m: `0.25`: the vehicle's file says it, and "
                                              "says 0.2 ("));
  EXPECT_THAT(problems[1].Format(), HasSubstr("v.yaml:1: dvl.at_m)"));
}

TEST_F(VehicleSettings, OfAnotherVehicleTakeThePlaceOfTheFormers) {
  Say("v.yaml", "camera: {fov_across_deg: 70, tilt_deg: 5}\n");
  Say("w.yaml", "camera: {fov_across_deg: 60}\n");
  MissionFile mission = Read("ProcessConfig = pMap\n{\n}\n");
  mission.globals.front().value = "w.yaml";
  TakeFacts(mission);
  EXPECT_EQ(ValueIn(mission, "pMap", "camera_fov_across_deg"), "60");
  EXPECT_EQ(ValueIn(mission, "pMap", "camera_tilt_deg"), "");
}

TEST_F(VehicleSettings, OfAFileThatIsNoYamlAreNone) {
  Say("v.yaml", "camera: {fov_across_deg: 70\n");
  EXPECT_THAT(Read("ProcessConfig = pMap\n{\n}\n").Block("pMap")->entries, IsEmpty());
}

TEST(VehicleFacts, HoldEveryKeyOfTheCamera) {
  CameraParams camera;
  for (const ParamSpec& spec : DescribeParams(camera)) {
    for (const char* owner : {"pHelm", "pMap", "pNav", "uSimCamera"}) {
      EXPECT_EQ(FactFor(owner, spec.name).fact, "camera." + spec.name.substr(7));
    }
  }
  CameraTiming timing;
  for (const ParamSpec& spec : DescribeParams(timing)) {
    EXPECT_EQ(FactFor("uSimCamera", spec.name).fact, "camera." + spec.name);
  }
}

}  // namespace
}  // namespace limpet

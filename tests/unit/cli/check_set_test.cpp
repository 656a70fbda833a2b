// SPDX-License-Identifier: MIT
// `limpet check --set`: a mission as it would be flown with a setting.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "tests/support/mission_copy.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

const fs::path kAllMissions = fs::path(LIMPET_SOURCE_DIR) / "missions";
const std::string kTable1 = (kAllMissions / "table1").string();

TEST(CheckWithSettings, LooksAtTheMissionAsTheyWouldHaveItFlown) {
  EXPECT_EQ(Check({kTable1, "--set", "VehicleFile=bluerov2.yaml"}).exit_code, kOk);
  const Checked high = Check({kTable1, "--set", "pSurvey.align_s=100000"});
  EXPECT_NE(high.exit_code, kOk) << high.text;
  EXPECT_THAT(high.text, HasSubstr("--set pSurvey.align_s=100000: align_s:"));
}

TEST(CheckWithSettings, TakesSeveralAndSettingsOfBehaviors) {
  const Checked both =
      Check({kTable1, "--set", "VehicleFile=bluerov2.yaml", "--set", "cover.weight=-3"});
  EXPECT_EQ(both.exit_code, kUsage);
  EXPECT_THAT(both.text, HasSubstr("weight"));
  EXPECT_THAT(both.text, HasSubstr("1 problem\n"));
}

TEST(CheckWithSettings, RefusesWhatNoAppBehaviorOrGlobalTakes) {
  EXPECT_THAT(Check({kTable1, "--set", "pSurvy.align_s=3"}).text,
              HasSubstr("--set pSurvy.align_s=3: pSurvy: no app or behavior of this name"));
  EXPECT_THAT(Check({kTable1, "--set", "VehicelFile=x"}).text,
              HasSubstr("did you mean `VehicleFile`?"));
  EXPECT_EQ(Check({kTable1, "--set", "VehicelFile=x"}).exit_code, kUsage);
}

TEST(CheckWithSettings, SaysOfAVehicleThatIsNotThereThatAlone) {
  const Checked checked = Check({kTable1, "--set", "VehicleFile=nope.yaml"});
  EXPECT_THAT(checked.text, HasSubstr("there is no `nope.yaml`"));
  EXPECT_THAT(checked.text, HasSubstr("\n1 problem\n")) << "its camera is not missing beside it";
}

TEST(CheckWithSettings, DrawsTheAreaThatTheySay) {
  const Checked wider = Check({kTable1, "--draw", "--set", "pSurvey.area_north_max_m=40"});
  EXPECT_EQ(wider.exit_code, kOk) << wider.text;
  EXPECT_THAT(wider.text, HasSubstr(" m2 to be seen"));
  EXPECT_NE(wider.text, Check({kTable1, "--draw"}).text);
}

TEST(CheckWithSettings, AreOfOneMissionAndNotOfABehaviorFile) {
  const std::vector<std::string> of_behaviors{kTable1 + "/mission.bhv", "--set", "VehicleFile=x"};
  EXPECT_THROW(RunCheck(of_behaviors), UsageError);
  EXPECT_EQ(
      Check({(kAllMissions / "two_communities").string(), "--set", "VehicleFile=bluerov2.yaml"})
          .exit_code,
      kOk)
      << "the one that simulates a vehicle";
}

TEST(CheckVehicleFile, ThatIsBadIsTheOnlyProblem) {
  MissionCopy mission;
  for (const Edit& edit : Vehicle("camera:\n  width_px: -5")) {
    if (edit.from.empty()) std::ofstream(mission.path() / edit.file) << edit.to;
    if (!edit.from.empty()) mission.Apply(edit);
  }
  const Checked checked = mission.Run();
  EXPECT_THAT(checked.text, HasSubstr("vehicle.yaml"));
  EXPECT_THAT(checked.text, Not(HasSubstr("is missing in")));
}

}  // namespace
}  // namespace limpet

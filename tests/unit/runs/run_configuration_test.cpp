// SPDX-License-Identifier: MIT
#include "limpet/runs/run_configuration.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

/// A mission that includes a fragment from a `plugs` folder beside its own.
class RunConfigurationTest : public testing::Test {
 protected:
  RunConfigurationTest() {
    Put("m/mission.moos", "ServerHost = localhost\n#include plug_a.moos\n");
    Put("m/mission.bhv", "// bids\n");
    Put("plugs/plug_a.moos", "ServerPort = 9000\n");
  }
  void Put(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_.path() / name).parent_path());
    std::ofstream(folder_.path() / name) << text;
  }
  [[nodiscard]] RunConfiguration Now(const std::string& option = "--set=a.b=1") const {
    return RunConfiguration::Of(folder_.path() / "m", {option});
  }
  TemporaryFolder folder_;
};

TEST_F(RunConfigurationTest, NamesWhatHasChanged) {
  const RunConfiguration before = Now();
  EXPECT_THAT(DifferencesBetween(before, Now()), IsEmpty());
  Put("m/mission.bhv", "// other bids\n");
  Put("m/vehicle.yaml", "mass: 1\n");
  EXPECT_THAT(DifferencesBetween(before, Now()),
              ElementsAre("mission.bhv has changed", "vehicle.yaml is new"));
  EXPECT_THAT(DifferencesBetween(Now(), Now("--set=a.b=2")),
              ElementsAre("the options were `--set=a.b=1`"));
}

TEST_F(RunConfigurationTest, KnowsThePlugsOfTheMission) {
  const RunConfiguration before = Now();
  Put("plugs/plug_a.moos", "ServerPort = 9001\n");
  EXPECT_THAT(
      DifferencesBetween(before, Now()),
      ElementsAre("mission.moos with its plugs and macros has changed", "plug_a.moos has changed"));
}

TEST_F(RunConfigurationTest, KnowsTheVehicleAndTheOneItIsBasedOn) {
  Put("m/mission.moos", "VehicleFile = own.yaml\n");
  Put("share/vehicles/own.yaml", "based_on: base.yaml\n");
  Put("share/vehicles/base.yaml", "name: a\n");
  const RunConfiguration before = Now();
  Put("share/vehicles/base.yaml", "name: b\n");
  EXPECT_THAT(DifferencesBetween(before, Now()), ElementsAre("base.yaml has changed"));
}

TEST_F(RunConfigurationTest, KnowsTheVehicleThatAnOptionNames) {
  Put("share/vehicles/other.yaml", "name: a\n");
  const RunConfiguration before = Now("--set=VehicleFile=other.yaml");
  Put("share/vehicles/other.yaml", "name: b\n");
  EXPECT_THAT(DifferencesBetween(before, Now("--set=VehicleFile=other.yaml")),
              ElementsAre("other.yaml has changed"));
}

TEST_F(RunConfigurationTest, LeavesOutWhatNoRunReads) {
  const RunConfiguration before = Now();
  Put("m/README.md", "a mission");
  Put("m/expect.yaml", "each: {missed: {max: 0}}\n");
  Put("m/.mission.moos.swp", "an editor's");
  Put("m/runs/.written.json", "{}");
  Put("m/runs/run.json", "{}");
  EXPECT_THAT(DifferencesBetween(before, Now()), IsEmpty());
}

TEST_F(RunConfigurationTest, ComesBackFromItsText) {
  const auto again = RunConfiguration::FromText(Now().Text());
  ASSERT_TRUE(again);
  EXPECT_EQ(again->parts, Now().parts);
  EXPECT_FALSE(RunConfiguration::FromText("table1 --gain=full\n"));
}

}  // namespace
}  // namespace limpet

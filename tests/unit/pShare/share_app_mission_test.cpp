// SPDX-License-Identifier: MIT
// missions/two_communities as it is written, and pShare's command line.
#include <array>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pShare/share_app.hpp"
#include "limpet/app/app_command.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// One side of the mission.
struct Side {
  std::vector<ShareOutput> outputs;
  std::vector<ShareInput> inputs;
};

Side Read(const std::string& file) {
  const MissionFile mission =
      LoadMission(std::filesystem::path(LIMPET_SOURCE_DIR) / "missions/two_communities" / file);
  const ConfigBlock& block = *mission.Block("pShare");
  EXPECT_THAT(CheckShareBlock(block), IsEmpty());
  const auto params = limpet::ReadParams<ShareParams>(block, CommonAppKeys());
  EXPECT_FALSE(params.allows_plain_routes);
  Side side;
  for (const std::string& line : params.outputs) {
    std::ranges::copy(*ParseShareOutputs(line, {}), std::back_inserter(side.outputs));
  }
  for (const std::string& line : params.inputs) {
    side.inputs.push_back(*ParseShareInput(line, {}));
  }
  return side;
}

TEST(TwoCommunitiesMission, EachSideSendsToWhereTheOtherListens) {
  const Side shore = Read("shore.moos"), vehicle = Read("vehicle.moos");
  for (const ShareOutput& output : shore.outputs) {
    EXPECT_EQ(output.address, vehicle.inputs.at(0).addresses.at(0)) << output.source;
  }
  for (const ShareOutput& output : vehicle.outputs) {
    EXPECT_EQ(output.address, shore.inputs.at(0).addresses.at(0)) << output.source;
  }
}

TEST(TwoCommunitiesMission, TheVehicleRunsAllThatItsBasinNeeds) {
  const auto folder = std::filesystem::path(LIMPET_SOURCE_DIR) / "missions";
  std::vector<std::string> runs;
  for (const LaunchEntry& entry : LoadMission(folder / "two_communities/vehicle.moos").launches) {
    runs.push_back(entry.binary);
  }
  for (const LaunchEntry& entry : LoadMission(folder / "basin/mission.moos").launches) {
    EXPECT_THAT(runs, Contains(entry.binary));
  }
}

TEST(TwoCommunitiesMission, TheVehicleLetsInWhatTheShoreSaysAndNothingElse) {
  const Side shore = Read("shore.moos"), vehicle = Read("vehicle.moos");
  const std::vector<std::string>& listed = vehicle.inputs.at(0).white_list;
  EXPECT_THAT(listed, SizeIs(shore.outputs.size()));
  for (const ShareOutput& output : shore.outputs) {
    EXPECT_THAT(listed, Contains(output.dest));
  }
}

TEST(ShareCommandLine, AddsLinesToTheBlock) {
  const std::array<const char*, 2> args{"-o=X->Y:localhost:9021", "-i=localhost:9030"};
  const AppCommand command = ReadAppCommand("pShare", args);
  ASSERT_THAT(command.additions, SizeIs(2));
  EXPECT_EQ(command.additions[0].key, "output");
  EXPECT_EQ(command.additions[0].value, "X->Y:localhost:9021");
  EXPECT_EQ(command.additions[1].key, "input");
}

TEST(ShareCommandLine, IsThatAppsAlone) {
  const std::array<const char*, 1> args{"-o=X->Y:localhost:9021"};
  EXPECT_THROW(static_cast<void>(ReadAppCommand("pOther", args)), ConfigError);
}

}  // namespace
}  // namespace limpet

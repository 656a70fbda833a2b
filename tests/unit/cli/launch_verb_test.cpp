// SPDX-License-Identifier: MIT
// `limpet launch` refuses what `limpet check` refuses, before anything is started.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/launch.hpp"
#include "limpet/launch/launch_check.hpp"
#include "limpet/mission/mission_file.hpp"
#include "tests/support/mission_copy.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Programs of a mission that only leave a file behind, in front of PATH.
void MakeStandIns(const MissionCopy& mission) {
  const fs::path bin = mission.folder() / "bin";
  fs::create_directories(bin);
  for (const LaunchEntry& launch : LoadMission(mission.path() / "mission.moos").launches) {
    const fs::path program = bin / launch.binary;
    std::ofstream(program) << "#!/bin/sh\ntouch " << (mission.folder() / "started").string()
                           << "\n";
    fs::permissions(program, fs::perms::owner_all);
  }
  const char* path = std::getenv("PATH");
  ::setenv("PATH", (bin.string() + ":" + (path != nullptr ? path : "")).c_str(), 1);
}

struct RefusedLaunch {
  int exit_code = 0;
  std::string text;
};

RefusedLaunch Launch(const MissionCopy& mission) {
  ::testing::internal::CaptureStderr();
  const std::vector<std::string> args{(mission.path() / "mission.moos").string(),
                                      "--run_folder=" + (mission.folder() / "run").string()};
  const int exit_code = RunLaunchVerb(args);
  return {exit_code, ::testing::internal::GetCapturedStderr()};
}

TEST(LaunchVerb, StartsNothingOfAMissionThatCannotWork) {
  const MissionCopy mission;
  mission.Apply({"mission.bhv", "#include", "#define ALTITUDE 3\n#include"});
  MakeStandIns(mission);
  const RefusedLaunch refusal = Launch(mission);
  EXPECT_EQ(refusal.exit_code, kRefused);
  EXPECT_THAT(refusal.text, HasSubstr("altitude_m: the survey altitude is 3 m"));
  EXPECT_FALSE(fs::exists(mission.folder() / "started"));
  EXPECT_FALSE(fs::exists(mission.folder() / "run"));
}

TEST(LaunchVerb, StartsNothingOfAMissionThatCannotBeRead) {
  const MissionCopy mission;
  mission.Apply({PlugOf("pSurvey"), "ProcessConfig = pSurvey", "ProcessConfig = pSurvy"});
  MakeStandIns(mission);
  const RefusedLaunch refusal = Launch(mission);
  EXPECT_EQ(refusal.exit_code, kUsage);
  EXPECT_THAT(refusal.text, HasSubstr("did you mean `pSurvey`?"));
  EXPECT_FALSE(fs::exists(mission.folder() / "started"));
}

TEST(LaunchVerb, TakesOurMissionsAndOtherPeoples) {
  const MissionCopy mission;
  EXPECT_EQ(RefuseToLaunch(mission.path() / "mission.moos"), 0);
  const fs::path stock = mission.folder() / "alpha.moos";
  std::ofstream(stock) << "ServerHost = localhost\nServerPort = 9000\nCommunity = alpha\n"
                          "LatOrigin = 43.8\nLongOrigin = -70.3\nProcessConfig = ANTLER\n{\n"
                          "  Run = MOOSDB\n  Run = pLogger\n  Run = pHelmIvP\n"
                          "  Run = pNodeReporter\n  Run = pMarineViewer\n}\n"
                          "ProcessConfig = pHelmIvP\n{\n  behaviors = alpha.bhv\n}\n"
                          "ProcessConfig = pNodeReporter\n{\n  AppTick = 2\n}\n";
  EXPECT_EQ(RefuseToLaunch(stock), 0);
}

}  // namespace
}  // namespace limpet

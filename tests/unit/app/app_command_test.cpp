// SPDX-License-Identifier: MIT
// What a process accepts from its command line and from the mission that it names.
#include "limpet/app/app_command.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

class AppCommandTest : public testing::Test {
 protected:
  AppCommand Command(const std::string& process, const std::string& mission,
                     const std::vector<const char*>& more = {}) const {
    const std::string file = (folder_.path() / "m.moos").string();
    std::ofstream(file) << mission;
    std::vector<const char*> args{file.c_str()};
    args.insert(args.end(), more.begin(), more.end());
    return ReadAppCommand(process, args);
  }
  std::string Refusal(const std::string& process, const std::string& mission,
                      const std::vector<const char*>& more = {}) const {
    try {
      static_cast<void>(Command(process, mission, more));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
};

TEST_F(AppCommandTest, ALoggerStartedByHandLogsInsideUnlessThatIsAllowed) {
  const std::string mission = "ProcessConfig = pLog\n{\n  File = ../../x\n}\n";
  EXPECT_THAT(Refusal("pLog", mission), testing::HasSubstr("m.moos:3: File: `../../x` is a path"));
  EXPECT_TRUE(Command("pLog", mission, {"--allow_outside"}).allows_outside);
  EXPECT_THAT(Refusal("pLog", "GlobalLogPath = /etc\n"), testing::HasSubstr("`/etc` lies outside"));
  EXPECT_EQ(Refusal("pNav", mission), "");
}

TEST_F(AppCommandTest, EveryProcessHelpsWhoHasNoMission) {
  for (const char* process : {"pLog", "pNav", "LimpetDB"}) {
    EXPECT_TRUE(ReadAppCommand(process, std::vector<const char*>{"--help"}).wants_help) << process;
    EXPECT_TRUE(ReadAppCommand(process, std::vector<const char*>{"--example"}).wants_example);
    EXPECT_TRUE(ReadAppCommand(process, {}).mission_file.empty());
  }
}

TEST_F(AppCommandTest, AnAliasIsNoPath) {
  EXPECT_THAT(Refusal("pNav", "", {"--alias=../x"}),
              testing::HasSubstr("is no name for a process"));
  EXPECT_THAT(Refusal("pNav", "", {"a/b"}), testing::HasSubstr("is no name for a process"));
  EXPECT_EQ(Command("pNav", "", {"pNav_2"}).name, "pNav_2");
}

}  // namespace
}  // namespace limpet

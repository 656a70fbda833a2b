// SPDX-License-Identifier: MIT
// What a mission from elsewhere may write and what its processes may be called.
#include "limpet/mission/outside.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class OutsideTest : public ::testing::Test {
 protected:
  OutsideTest() {
    fs::create_directories(inside_ / "logs");
    fs::create_directories(outside_);
    fs::create_symlink(outside_, inside_ / "way_out");
    fs::create_symlink(inside_ / "logs", inside_ / "way_in");
  }
  [[nodiscard]] bool Lies(const std::string& path) const {
    return LiesInside(path, inside_, {inside_});
  }
  TemporaryFolder temporary_;
  const fs::path inside_ = temporary_.path() / "mission";
  const fs::path outside_ = temporary_.path() / "elsewhere";
};

TEST_F(OutsideTest, WhatIsBelowTheFolderLiesInside) {
  for (const char* path : {".", "logs", "logs/run", "new/and/deeper", "logs/../logs", "way_in/x"})
    EXPECT_TRUE(Lies(path)) << path;
  EXPECT_TRUE(Lies((inside_ / "logs").string()));
}

TEST_F(OutsideTest, DotsLinksHomesAndAbsolutePathsLeadOut) {
  for (const char* path : {"..", "../elsewhere", "logs/../../elsewhere", "way_out", "way_out/x",
                           "way_out/../x", "~", "~/logs", "/", "/tmp"})
    EXPECT_FALSE(Lies(path)) << path;
}

TEST_F(OutsideTest, AFolderWhoseNameOnlyBeginsAlikeIsAnother) {
  fs::create_directories(temporary_.path() / "mission2");
  EXPECT_FALSE(Lies("../mission2"));
  EXPECT_FALSE(Lies("../mission2/logs"));
}

TEST_F(OutsideTest, AnyOfSeveralFoldersWillDo) {
  EXPECT_TRUE(LiesInside("../elsewhere/x", inside_, {inside_, outside_}));
  EXPECT_TRUE(LiesInside(outside_ / "x", inside_, {inside_, outside_.string() + "/"}));
  EXPECT_FALSE(LiesInside("..", inside_, {inside_, outside_}));
  EXPECT_FALSE(LiesInside(".", inside_, {}));
}

MissionFile MissionThatLogs(const std::string& text) { return ParseMission(text, "a.moos"); }

TEST_F(OutsideTest, ALoggersPathsAreComplainedAboutWithTheirLines) {
  const MissionFile mission = MissionThatLogs(
      "GlobalLogPath = /var/log\n"
      "ProcessConfig = pLogger\n{\n  Path = /root\n  File = ../x\n"
      "  LoggingDirectorySummaryFile = ~/all.txt\n  AsyncLog = true\n}\n"
      "ProcessConfig = pNav\n{\n  Path = /root\n}\n");
  const auto problems = OutsideProblems(mission, {inside_});
  ASSERT_THAT(problems, SizeIs(4));
  EXPECT_EQ(problems[0].key, "GlobalLogPath");
  EXPECT_EQ(problems[0].where.line, 1);
  EXPECT_EQ(problems[1].where.line, 4);
  EXPECT_THAT(problems[1].text, HasSubstr("`/root` lies outside"));
  EXPECT_THAT(problems[2].text, HasSubstr("a name without `/`"));
  EXPECT_THAT(problems[3].text, HasSubstr("~/all.txt"));
}

TEST_F(OutsideTest, ALoggerUnderAnotherNameIsALogger) {
  const MissionFile mission = MissionThatLogs(
      "ProcessConfig = ANTLER\n{\n  Run = pLogger @ NewConsole = false ~ Diary\n}\n"
      "ProcessConfig = Diary\n{\n  Path = /root\n}\n");
  EXPECT_THAT(OutsideProblems(mission, {inside_}), SizeIs(1));
}

TEST_F(OutsideTest, WhatStaysInsideIsNoProblem) {
  const MissionFile mission =
      MissionThatLogs("GlobalLogPath = " + (inside_ / "logs").string() +
                      "\nProcessConfig = pLog\n{\n  File = run_of_day\n}\n");
  EXPECT_THAT(OutsideProblems(mission, {inside_}), IsEmpty());
}

TEST(ProcessName, MayHoldLettersDigitsAndMarks) {
  for (const char* name : {"pNav", "uXMS_2", "p-Nav", "pNav.2", "a+b", "pNav@alpha", "x#1"})
    EXPECT_FALSE(ProcessNameProblem(name)) << name;
  EXPECT_FALSE(ProcessNameProblem(std::string(64, 'a')));
}

TEST(ProcessName, MayNotLeadElsewhereOrLookLikeAnOption) {
  for (const char* name : {"", ".", "..", ".hidden", "-rf", "a/b", "a b", "a\nb", "a;b", "a$b",
                           "a\\b", "a*", "\xc3\xa4"}) {
    const auto problem = ProcessNameProblem(name);
    ASSERT_TRUE(problem) << name;
    EXPECT_THAT(*problem, HasSubstr("is no name for a process"));
  }
  EXPECT_TRUE(ProcessNameProblem(std::string(65, 'a')));
  EXPECT_LT(ProcessNameProblem(std::string(100000, 'a'))->size(), 400U) << "not all of it";
}

}  // namespace
}  // namespace limpet

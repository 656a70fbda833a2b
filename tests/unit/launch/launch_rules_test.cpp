// SPDX-License-Identifier: MIT
// What the text of a mission may start and where it may write, through the plan of its launch.
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/launch/launch.hpp"
#include "limpet/launch/launch_plan.hpp"
#include "limpet/launch/launch_report.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class LaunchRulesTest : public testing::Test {
 protected:
  LaunchRulesTest() {
    fs::create_directories(folder_.path() / "programs");
    fs::create_directories(folder_.path() / "mission");
    for (const char* program : {"programs/pEcho", "programs/LimpetDB", "mission/pOwn", "tool"}) {
      std::ofstream(folder_.path() / program) << "#!/bin/sh\n";
      fs::permissions(folder_.path() / program, fs::perms::owner_all);
    }
  }
  /// Plans a mission with these lines in its ANTLER block, and `more` behind it.
  LaunchPlan PlanOf(const std::string& antler, const std::string& more = "",
                    std::vector<std::string> options = {}) const {
    const fs::path file = folder_.path() / "mission" / "m.moos";
    std::ofstream(file) << "Community = alpha\nProcessConfig = ANTLER\n{\n  Run = pEcho\n"
                        << antler << "\n}\n"
                        << more;
    options.insert(options.begin(), file.string());
    return PlanLaunch(ReadLaunchCommand(options), folder_.path() / "programs");
  }
  std::string RefusalOf(const std::string& antler, const std::string& more = "") const {
    try {
      static_cast<void>(PlanOf(antler, more));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
};

TEST_F(LaunchRulesTest, StartsNoShellNoInterpreterAndNoPath) {
  for (const char* binary : {"/bin/sh", "sh", "python3", "../tool", "bin/pEcho", "pEcho/../../tool",
                             "./tool", "env", "p"}) {
    const std::string refusal =
        RefusalOf(std::string("  Run = ") + binary + " @ NewConsole = false");
    EXPECT_THAT(refusal, HasSubstr("m.moos:5: Run: `" + std::string(binary) + "` is not the plain"))
        << binary;
    EXPECT_THAT(refusal, HasSubstr("--allow-outside"));
  }
}

TEST_F(LaunchRulesTest, StartsThemForThoseWhoAllowIt) {
  const LaunchPlan plan = PlanOf("  Run = /bin/sh ~ pShell\n  Run = sh", "", {"--allow-outside"});
  ASSERT_EQ(plan.items.size(), 3U);
  EXPECT_EQ(plan.items[1].program, "/bin/sh");
}

TEST_F(LaunchRulesTest, TakesNoProgramFromAFolderThatTheMissionNames) {
  for (const char* line : {"  ExecutablePath = ..", "  Run = pEcho @ Path = /tmp ~ pTwo",
                           "  ExecutablePath = ../../usr"}) {
    EXPECT_THAT(RefusalOf(line), HasSubstr("is no folder of PATH, nor the mission's")) << line;
  }
  EXPECT_THAT(RefusalOf("  ExecutablePath = SYSTEM"), IsEmpty());
  // Its own folder is a stock habit: said, but not searched unless that is allowed.
  EXPECT_THAT(PlanOf("  ExecutablePath = ./\n  Run = pOwn").missing, testing::SizeIs(1));
  EXPECT_THAT(PlanOf("  ExecutablePath = ./\n  Run = pOwn", "", {"--allow-outside"}).missing,
              IsEmpty());
}

TEST_F(LaunchRulesTest, NamesOfProcessesAreNoPaths) {
  for (const char* name : {"../x", "a/b", ".hidden", "--moos_port=1", "a b"}) {
    EXPECT_THAT(RefusalOf(std::string("  Run = pEcho ~ ") + name),
                HasSubstr("is no name for a process and its log"))
        << name;
  }
}

TEST_F(LaunchRulesTest, LogsLieInsideUnlessThatIsAllowed) {
  const std::string pLog = "ProcessConfig = pLog\n{\n  ";
  for (const std::string line :
       {"Path = /etc", "Path = ../../x", "File = ../../x", "File = /tmp/x", "Path = ~/logs",
        "LoggingDirectorySummaryFile = /etc/motd", "LoggingDirectorySummaryFile = ../../.bashrc"}) {
    EXPECT_THAT(RefusalOf("", pLog + line + "\n}\n"), HasSubstr("m.moos:9: ")) << line;
    EXPECT_NO_THROW(static_cast<void>(PlanOf("", pLog + line + "\n}\n", {"--allow-outside"})));
  }
  EXPECT_THAT(RefusalOf("", "GlobalLogPath = /var/log\n"),
              HasSubstr("m.moos:7: GlobalLogPath: `/var/log` lies outside"));
  EXPECT_THAT(RefusalOf("", "GlobalLogPath = logs\n" + pLog + "Path = ./\n  File = LOG_A\n}\n"),
              IsEmpty());
}

TEST_F(LaunchRulesTest, ALinkOutOfTheMissionIsOutside) {
  fs::create_directory_symlink("/usr", folder_.path() / "mission" / "link");
  const std::string path = (folder_.path() / "mission" / "link" / "limpet_logs").string();
  EXPECT_THAT(RefusalOf("", "ProcessConfig = pLog\n{\n  Path = " + path + "\n}\n"),
              HasSubstr("lies outside"));
}

TEST_F(LaunchRulesTest, ALoggerUnderAnotherNameIsALoggerToo) {
  EXPECT_THAT(RefusalOf("  Run = pLogger ~ pEars", "ProcessConfig = pEars\n{\nPath = /etc\n}\n"),
              HasSubstr("`/etc` lies outside"));
}

TEST_F(LaunchRulesTest, WhereTheRunLiesIsNotTheMissionsToSay) {
  for (const char* arg :
       {"--run_folder=/tmp", "-run_folder=/tmp", "--allow_outside", "--session=x"}) {
    EXPECT_THAT(
        RefusalOf(std::string("  Run = pEcho @ ExtraProcessParams = A ~ pTwo\n  A = ") + arg),
        HasSubstr("m.moos:5: ExtraProcessParams: `" + std::string(arg) + "` is for"))
        << arg;
  }
  EXPECT_THAT(RefusalOf("  Run = pEcho @ ExtraProcessParams = A ~ pTwo\n  A = --moos_port=9001"),
              IsEmpty());
}

TEST_F(LaunchRulesTest, SessionsHavePlainNames) {
  for (const char* name : {"../x", "", "a/b", "/tmp/x"}) {
    EXPECT_THROW(static_cast<void>(PlanOf("", "", {std::string("--session=") + name})), ConfigError)
        << name;
  }
}

TEST_F(LaunchRulesTest, StartsTheRestWhereAViewerIsMissing) {
  const LaunchPlan plan = PlanOf("  Run = pMarineViewer\n  Run = uMAC\n  Run = pMissingPilot");
  EXPECT_EQ(plan.items.size(), 1U);
  ASSERT_EQ(plan.missing.size(), 3U);
  EXPECT_FALSE(plan.missing[0].is_vital);
  EXPECT_FALSE(plan.missing[1].is_vital);
  EXPECT_TRUE(plan.missing[2].is_vital);
  ASSERT_EQ(plan.notes.size(), 3U);
  EXPECT_THAT(plan.notes[0].Format(), HasSubstr("m.moos:5: Run: no program `pMarineViewer`"));
  EXPECT_EQ(StatusOfMissing({plan.missing[1]}),
            " # app=uMAC,state=missing,restarts=0,last=no program uMAC,database=false");
  EXPECT_EQ(std::string(WithMissing({}, plan.missing)[2].state), "missing");
}

TEST_F(LaunchRulesTest, AMissionWithoutItsDatabaseIsRefused) {
  fs::remove(folder_.path() / "programs" / "LimpetDB");
  EXPECT_THAT(RefusalOf("  Run = MOOSDB"), HasSubstr("no program `LimpetDB`"));
}

TEST_F(LaunchRulesTest, NestedTextOfOthersIsANoteAndOursAnError) {
  const std::string nested = "\n{\n  AppTick = 1\n  driver {\n    id: 1\n  }\n}\n";
  const LaunchPlan plan = PlanOf("", "ProcessConfig = pAcommsHandler" + nested);
  ASSERT_EQ(plan.notes.size(), 1U);
  EXPECT_THAT(plan.notes[0].Format(), HasSubstr("m.moos:10: pAcommsHandler: a `{` inside"));
  EXPECT_THAT(RefusalOf("", "ProcessConfig = pEcho" + nested),
              HasSubstr("m.moos:10: pEcho: a `{` inside"));
}

/// Exit code of `limpet launch` of a mission with these lines to run.
int ExitCodeOf(const fs::path& folder, const std::string& runs, std::vector<std::string> options) {
  const fs::path file = folder / "m.moos";
  std::ofstream(file) << "ServerPort = 1\nProcessConfig = ANTLER\n{\n" << runs << "}\n";
  options.insert(options.begin(), {file.string(), "--run_folder=" + (folder / "run").string()});
  return RunLaunch("limpet launch", options);
}

TEST(LaunchVerb, AMissionThatNamesAShellStartsNothing) {
  const TemporaryFolder folder;
  const std::string runs = "Run = sh @ ExtraProcessParams = args\nargs = -c, true\n";
  EXPECT_EQ(ExitCodeOf(folder.path(), runs, {}), 2);
  EXPECT_FALSE(fs::exists(folder.path() / "run"));
}

TEST(LaunchVerb, SaysAtItsEndThatAVitalProgramWasMissing) {
  const TemporaryFolder viewer, pilot;
  EXPECT_EQ(ExitCodeOf(viewer.path(), "Run = true\nRun = pMarineViewer\n", {"--allow-outside"}), 0);
  EXPECT_EQ(ExitCodeOf(pilot.path(), "Run = true\nRun = pNoSuchPilot\n", {"--allow-outside"}), 1);
}

}  // namespace
}  // namespace limpet

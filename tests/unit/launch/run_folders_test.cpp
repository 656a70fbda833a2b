// SPDX-License-Identifier: MIT
#include "limpet/launch/run_folders.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/launch/launch.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class RunFoldersTest : public testing::Test {
 protected:
  RunFoldersTest() { fs::current_path(folder_.path()); }
  ~RunFoldersTest() override { fs::current_path(fs::temp_directory_path()); }

  /// What a launch of that session leaves in a run: a saved session, of a dive or not.
  static void Leave(const fs::path& folder, bool is_dive) {
    fs::create_directories(folder / "session" / "g000001");
    std::ofstream(folder / "session" / "manifest.json") << "{}";
    if (is_dive) {
      std::ofstream(folder / "session" / "g000001" / "area.txt") << "area";
    }
  }
  static RunFolders Choose(const std::string& session, const std::string& run = "",
                           const std::string& prior = "") {
    LaunchCommand command;
    command.mission_file = "missions/table1/mission.moos";
    command.session = session;
    command.run_folder = run;
    command.prior_folder = prior;
    return ChooseRunFolders(command);
  }
  static std::string Complaint(const std::string& session, const std::string& run = "",
                               const std::string& prior = "") {
    try {
      static_cast<void>(Choose(session, run, prior));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  [[nodiscard]] const fs::path& folder() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

TEST_F(RunFoldersTest, ASecondDiscoveryGetsAFolderOfItsOwn) {
  EXPECT_EQ(Choose("discovery").run, "runs/table1-live");
  Leave("runs/table1-live/discovery", true);
  EXPECT_EQ(Choose("discovery").run, "runs/table1-live-2");
  Leave("runs/table1-live-2/discovery", false);
  EXPECT_EQ(Choose("discovery").run, "runs/table1-live-3");
}

TEST_F(RunFoldersTest, AChangeSessionIsKeptBesideTheLatestDivesDiscovery) {
  Leave("runs/table1-live/discovery", true);
  Leave("runs/table1-live-2/discovery", true);
  Leave("runs/table1-live-3/discovery", false);  // launched, never deployed
  const RunFolders folders = Choose("change");
  EXPECT_EQ(folders.run, "runs/table1-live-2");
  EXPECT_EQ(folders.prior, "runs/table1-live-2/discovery");
}

TEST_F(RunFoldersTest, ASecondChangeSessionComparesWithTheSameDiscoveryInAFolderOfItsOwn) {
  Leave("runs/table1-live/discovery", true);
  Leave("runs/table1-live/change", true);
  const RunFolders folders = Choose("change");
  EXPECT_EQ(folders.run, "runs/table1-live-2");
  EXPECT_EQ(folders.prior, "runs/table1-live/discovery");
}

TEST_F(RunFoldersTest, TakesTheFormerSessionThatIsNamed) {
  Leave("elsewhere", true);
  EXPECT_EQ(Choose("change", "", "elsewhere").prior, "elsewhere");
  EXPECT_THAT(Complaint("change", "", "nowhere"), HasSubstr("nowhere holds no saved session"));
}

TEST_F(RunFoldersTest, RefusesAChangeSessionWithNothingToCompareWith) {
  EXPECT_THAT(Complaint("change"), HasSubstr("no dive is saved in runs/table1-live*"));
  EXPECT_THAT(Complaint("change", "mine"), HasSubstr("mine/discovery holds none"));
}

TEST_F(RunFoldersTest, RefusesASessionNameThatIsAPath) {
  EXPECT_THAT(Complaint("../../x"), HasSubstr("`../../x` cannot name a session"));
  EXPECT_THAT(Complaint(""), HasSubstr("names no session"));
  EXPECT_THAT(Complaint("figures"), HasSubstr("the word is Limpet's own"));
}

TEST_F(RunFoldersTest, ALaunchIntoAFolderOfAFormerOneIsRefusedAndLeavesItAlone) {
  fs::create_directories("missions/table1");
  std::ofstream("missions/table1/mission.moos")
      << "ProcessConfig = ANTLER\n{\n  Run = sh @ InhibitMOOSParams = true\n}\n";
  Leave("mine/discovery", true);
  EXPECT_EQ(RunLaunch("pLaunch", {"missions/table1/mission.moos", "--run_folder=mine"}), 2);
  EXPECT_TRUE(fs::exists("mine/discovery/session/g000001/area.txt"));
  EXPECT_FALSE(fs::exists("mine/discovery/sh.log"));
}

}  // namespace
}  // namespace limpet

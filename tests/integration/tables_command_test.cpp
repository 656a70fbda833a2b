// SPDX-License-Identifier: MIT
// `limpet tables` as its users call it, on a small mission.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "limpet/runs/folder_lock.hpp"
#include "tests/support/limpet_command.hpp"
#include "tests/support/small_mission.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class TablesCommandLine : public testing::Test {
 protected:
  TablesCommandLine() { WriteSmallMission(folder_.path() / "small"); }
  CommandResult Tables(std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"tables", "small",  "--out", "out",        "--runs",
                                   "2",      "--jobs", "2",     "--sessions", "discovery"};
    words.insert(words.end(), more.begin(), more.end());
    return RunLimpet(folder_.path(), words);
  }
  void Write(const std::string& name, const std::string& text) const {
    fs::create_directories(At(name).parent_path());
    std::ofstream(At(name)) << text;
  }
  [[nodiscard]] fs::path At(const std::string& name) const { return folder_.path() / name; }
  TemporaryFolder folder_;
};

TEST_F(TablesCommandLine, GoesOnWithTheSameConfigurationAndWithNoOther) {
  const CommandResult first = Tables({"--json"});
  EXPECT_EQ(first.exit_code, kOk) << first.err;
  EXPECT_EQ(nlohmann::json::parse(first.out).at("runs"), 2);

  const CommandResult again = Tables();
  EXPECT_EQ(again.exit_code, kOk) << again.err;
  EXPECT_THAT(again.err, HasSubstr("2 of 2 seeds are already done"));

  const std::string behaviors = TextOfFile(At("small/mission.bhv"));
  Write("small/mission.bhv", behaviors + "// changed\n");
  const CommandResult edited = Tables();
  EXPECT_EQ(edited.exit_code, kRefused);
  EXPECT_THAT(edited.err, HasSubstr("mission.bhv has changed"));
  Write("small/mission.bhv", behaviors);

  const CommandResult other = Tables({"--set", "pSurvey.coverage_target=0.5"});
  EXPECT_EQ(other.exit_code, kRefused);
  EXPECT_THAT(other.err, HasSubstr("the options were"));

  Write("small/README.md", "what no run reads may change");
  Write("small/expect.yaml", "each: {path_m: {max: 0.01}}\n");
  const CommandResult bounded = Tables();
  EXPECT_EQ(bounded.exit_code, kFailed);
  EXPECT_THAT(bounded.err, HasSubstr("0 of 2 runs keep every bound"));
}

TEST_F(TablesCommandLine, RefusesAFolderInUseOrOfSomebodyElse) {
  fs::create_directories(At("out"));
  {
    const FolderLock held(At("out"));
    const CommandResult result = Tables();
    EXPECT_EQ(result.exit_code, kRefused);
    EXPECT_THAT(result.err, HasSubstr("in use by another run"));
  }
  Write("out/7/precious.txt", "precious");
  EXPECT_EQ(Tables().exit_code, kRefused);
  EXPECT_EQ(TextOfFile(At("out/7/precious.txt")), "precious");
}

TEST_F(TablesCommandLine, EndsWithTwoForWrongUsage) {
  EXPECT_EQ(RunLimpet(folder_.path(), {"tables"}).exit_code, kUsage);
  EXPECT_EQ(RunLimpet(folder_.path(), {"tables", "nowhere"}).exit_code, kUsage);
  EXPECT_EQ(Tables({"--runs", "0"}).exit_code, kUsage);
  EXPECT_EQ(Tables({"--out", ""}).exit_code, kUsage);
}

TEST_F(TablesCommandLine, CountsNoSeedWhoseRunWasRefused) {
  const CommandResult result = Tables({"--sessions", "fourth"});
  EXPECT_EQ(result.exit_code, kRefused) << result.err;
  EXPECT_FALSE(fs::exists(At("out/1.exit")));
}

}  // namespace
}  // namespace limpet

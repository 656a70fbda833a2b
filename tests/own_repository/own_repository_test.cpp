// SPDX-License-Identifier: MIT
// What a stranger does who has Limpet installed and wants a behavior and an app of her own. This
// build is installed into a folder, and nothing else of it is used from there on.
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/limpet_command.hpp"
#include "tests/support/shell.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// What docs/tutorial.md tells a shell, in one script that ends at the first failure.
std::string TutorialScript() {
  std::istringstream page(TextOfFile(fs::path(LIMPET_SOURCE_DIR) / "docs" / "tutorial.md"));
  std::string script = "set -eu\n";
  bool is_inside = false;
  for (std::string line; std::getline(page, line);) {
    const bool is_fence = line.starts_with("```");
    script += is_inside && !is_fence ? line + "\n" : "";
    is_inside = is_fence ? line == "```sh" : is_inside;
  }
  return script;
}

/// The tutorial, followed once.
class OwnRepository : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    fs::create_directory_symlink(LIMPET_BUILD, At("build"));
    std::ofstream(At("tutorial.sh")) << TutorialScript();
    tutorial_ = Shell(
        fmt::format("cd {0} && HOME={0} CMAKE_GENERATOR=Ninja PATH={1}:$PATH bash tutorial.sh",
                    folder_->path().string(), fs::path(LIMPET_CMAKE).parent_path().string()));
    ASSERT_EQ(tutorial_.exit_code, 0) << tutorial_.text;
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string At(const std::string& name) { return (folder_->path() / name).string(); }
  /// The installed one, with the behaviors of the repository.
  static ShellResult Limpet(const std::string& words) {
    return Shell(fmt::format("LIMPET_BEHAVIOR_PATH={} {} {}", At("own/build"),
                             At("limpet/bin/limpet"), words));
  }
  static ShellResult tutorial_;

 private:
  static std::unique_ptr<TemporaryFolder> folder_;
};
std::unique_ptr<TemporaryFolder> OwnRepository::folder_;
ShellResult OwnRepository::tutorial_;

TEST_F(OwnRepository, IsWhatTheTutorialEndsWith) {
  EXPECT_THAT(tutorial_.text, HasSubstr("100% tests passed, 0 tests failed out of 4"));
  EXPECT_THAT(tutorial_.text, HasSubstr("keep_off x 1"));
  EXPECT_THAT(tutorial_.text, HasSubstr("How far around it"));
}

TEST_F(OwnRepository, HasABehaviorThatBidsInASurveyAndCanBeTunedThere) {
  const auto charged = [](const std::string& run) {
    double sum = 0.0;
    const ShellResult why = Limpet("why " + At(run) + " --from 0 --json");
    for (const auto& decision : nlohmann::json::parse(why.text)) {
      for (const auto& option : decision.at("options")) {
        for (const auto& bid : option.at("bids")) {
          const double metres = bid.at("why").value("metres_near", 0.0);
          sum += bid.at("behavior") == "keep_off" && metres > 0.0
                     ? bid.at("value").get<double>() / metres
                     : 0.0;
        }
      }
    }
    return sum;
  };
  EXPECT_LT(charged("first"), -1.0);
  EXPECT_LT(charged("second"), -4.0);
}

TEST_F(OwnRepository, HasAnAppThatSaysItsParameters) {
  const ShellResult example = Shell(At("own/build/pDeep") + " --example");
  EXPECT_EQ(example.exit_code, 0) << example.text;
  EXPECT_THAT(example.text, HasSubstr("max_depth_m"));
}

TEST_F(OwnRepository, IsNeededByTheMissionThatNamesItsBehavior) {
  const ShellResult check = Shell(fmt::format("env -u LIMPET_BEHAVIOR_PATH {} check {}",
                                              At("limpet/bin/limpet"), At("own/missions/trial")));
  EXPECT_NE(check.exit_code, 0);
  EXPECT_THAT(check.text, HasSubstr("BHV_KeepOff"));
}

TEST_F(OwnRepository, IsFoundByCheckFromEitherPath) {
  const std::string limpet = At("limpet/bin/limpet"), mission = At("own/missions/trial");
  const auto check = [&](const std::string& environment, const std::string& what) {
    return Shell(fmt::format("{} {} check {}", environment, limpet, what));
  };
  const std::string behaviors = mission + "/mission.bhv";
  EXPECT_EQ(check("LIMPET_BEHAVIOR_PATH=" + At("own/build"), behaviors).exit_code, 0);
  const std::string none = "env -u LIMPET_BEHAVIOR_PATH";
  EXPECT_THAT(check(none, behaviors).text, HasSubstr("BHV_KeepOff"));
  fs::copy(mission, At("own/missions/paths"));
  const std::string file = At("own/missions/paths/mission.moos");
  const std::string text = TextOfFile(file);
  std::ofstream(file) << "#define BEHAVIOR_PATH ../../build\n" << text;
  const ShellResult by_mission = check(none, At("own/missions/paths"));
  EXPECT_EQ(by_mission.exit_code, 0) << by_mission.text;
  const ShellResult beside = check(none, At("own/missions/paths/mission.bhv"));
  EXPECT_EQ(beside.exit_code, 0) << beside.text;
  EXPECT_THAT(beside.text, ::testing::Not(HasSubstr("BHV_KeepOff: is no behavior")));
}

/// The tutorial's first block is README.md's own lines. The first is run here, on what is built: it
/// compiles nothing. The second takes minutes: `./limpet nightly` runs it.
TEST(Tutorial, BeginsWithLinesOfTheReadmeThatBuildAndSurvey) {
  const auto text = [](const char* name) { return TextOfFile(fs::path(LIMPET_SOURCE_DIR) / name); };
  std::istringstream page(text("docs/tutorial.md"));
  std::vector<std::string> lines;
  bool is_inside = false;
  for (std::string line; std::getline(page, line);) {
    const bool is_fence = line.starts_with("```");
    if (is_inside && !is_fence) lines.push_back(line);
    is_inside = is_fence ? line == "```console" : is_inside;
  }
  ASSERT_EQ(lines, (std::vector<std::string>{"./limpet build", "./limpet survey missions/table1"}));
  const std::string readme = text("README.md");
  EXPECT_THAT(readme, HasSubstr("`./limpet build`"));
  EXPECT_THAT(readme, HasSubstr("\n./limpet survey missions/table1 "));
  EXPECT_THAT(
      text("limpet"),
      HasSubstr("limpet\" survey \"$root/missions/table1\" --out \"$build/nightly-table1\""));
  if (fs::path(LIMPET_BUILD) != fs::path(LIMPET_SOURCE_DIR) / "build") {
    GTEST_SKIP() << "it would build another folder than this";
  }
  const ShellResult build = Shell(fmt::format("cd {} && {}", LIMPET_SOURCE_DIR, lines.front()));
  EXPECT_EQ(build.exit_code, 0) << build.text;
  EXPECT_THAT(build.text, HasSubstr("the programs are in build/bin"));
}

TEST_F(OwnRepository, IsNeverWrittenOver) {
  const ShellResult again = Limpet("new app pDeep --out " + At("own"));
  EXPECT_EQ(again.exit_code, 3);
  EXPECT_THAT(again.text, HasSubstr("is there already: nothing was written"));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
// `limpet tune` as its users call it, on a small mission.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "limpet/mission/expanded_text.hpp"
#include "limpet/sweeps/child_process.hpp"
#include "limpet/tuning/live_setting.hpp"
#include "tests/support/free_port.hpp"
#include "tests/support/limpet_command.hpp"
#include "tests/support/small_mission.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

fs::path ProgramBeside(const std::string& name) { return OwnProgram().parent_path() / name; }

class TuneCommandLine : public testing::Test {
 protected:
  TuneCommandLine() {
    WriteSmallMission(At("small"));
    // With its plug in place: the keys then stand in the mission's own file.
    const std::string behaviors =
        ExpandedText(TextOfFile(At("small/mission.bhv")), At("small/mission.bhv"));
    std::ofstream(At("small/mission.bhv")) << behaviors;
  }
  [[nodiscard]] fs::path At(const std::string& name) const { return folder_.path() / name; }
  static std::vector<std::string> Words(const std::string& out, std::vector<std::string> more) {
    std::vector<std::string> words{"tune", "small",  "--out", out,          "--runs",
                                   "3",    "--jobs", "2",     "--sessions", "discovery"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  CommandResult Tune(const std::string& out, const std::vector<std::string>& more) const {
    return RunLimpet(folder_.path(), Words(out, more));
  }
  TemporaryFolder folder_;
};

/// At the surface both wait as long.
const std::vector<std::string> kSlowOrFast{
    "--vary=follow.speed_mps=0.5:0.8:2", "--objective=sessions.discovery.duration_s",
    "--set=pSurvey.fix_target_m=10", "--set=pSurvey.last_fix_target_m=10"};

TEST_F(TuneCommandLine, FindsTheBetterSettingAndWritesADiffThatApplies) {
  const CommandResult result = Tune("out", kSlowOrFast);
  ASSERT_EQ(result.exit_code, kOk) << result.err;
  EXPECT_THAT(result.out, HasSubstr("follow.speed_mps=0.8 is better than the default: difference"));
  EXPECT_THAT(result.out, HasSubstr("held out from the search"));
  const auto json = nlohmann::json::parse(TextOfFile(At("out/tune.json")));
  EXPECT_EQ(json.at("best").at("values").at("follow.speed_mps"), 0.8);
  EXPECT_EQ(json.at("default").at("values").at("follow.speed_mps"), 0.5);
  EXPECT_EQ(json.at("best").at("runs"), 3);
  EXPECT_LT(json.at("difference").at("high"), 0.0);
  EXPECT_EQ(json.at("settings").size(), 2U);
  EXPECT_THAT(TextOfFile(At("out/tune.svg")), HasSubstr("</svg>"));
  EXPECT_THAT(TextOfFile(At("out/best.bhv.diff")), HasSubstr("+  speed_mps = 0.8"));
  if (std::system("patch --version >/dev/null 2>&1") != 0) return;
  const std::string patch =
      "patch -s -d " + At("small").string() + " -p1 <" + At("out/best.bhv.diff").string();
  EXPECT_EQ(std::system(patch.c_str()), 0);
  EXPECT_THAT(TextOfFile(At("small/mission.bhv")), HasSubstr("speed_mps = 0.8"));
}

TEST_F(TuneCommandLine, SaysSoWhenNothingIsBetter) {
  // No look is ever fruitless so often here.
  const CommandResult result =
      Tune("out", {"--vary=revisit.give_up_looks=3:4:2",
                   "--objective=sessions.discovery.duration_s", "--runs=2"});
  ASSERT_EQ(result.exit_code, kOk) << result.err;
  EXPECT_THAT(result.out, HasSubstr("no setting is better than the default: difference"));
  EXPECT_EQ(TextOfFile(At("out/best.bhv.diff")), "");
  const auto json = nlohmann::json::parse(TextOfFile(At("out/tune.json")));
  EXPECT_EQ(json.at("best"), json.at("default"));
}

TEST_F(TuneCommandLine, KilledFiveTimesComesToTheSameTableAndFliesNothingTwice) {
  std::vector<std::string> two = kSlowOrFast;
  two.emplace_back("--runs=2");
  ASSERT_EQ(Tune("whole", two).exit_code, kOk);
  const std::vector<std::string> words = Words(At("cut").string(), two);
  const fs::path here = fs::current_path();
  fs::current_path(folder_.path());
  int killed = 0;
  for (const int runs_before_kill : {1, 2, 3, 4, 5}) {
    const pid_t child = StartChild(
        {.args = words, .log = At("cut.txt"), .program = ProgramBeside("limpet").string()},
        SIGKILL);
    const auto count = [&] {
      int found = 0;
      if (!fs::exists(At("cut/results"))) return found;
      for (const auto& entry : fs::recursive_directory_iterator(At("cut/results")))
        found += entry.path().extension() == ".json" ? 1 : 0;
      return found;
    };
    while (count() < runs_before_kill && !ReapChild(child))
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ::kill(child, SIGKILL);
    WaitForChild(child);
    if (!fs::exists(At("cut/tune.json"))) ++killed;
  }
  fs::current_path(here);
  EXPECT_EQ(killed, 5) << "it had ended before";
  std::map<fs::path, fs::file_time_type> before;
  for (const auto& entry : fs::recursive_directory_iterator(At("cut/results"))) {
    if (entry.path().extension() == ".json") before[entry.path()] = entry.last_write_time();
  }
  EXPECT_GE(before.size(), 5U);
  const CommandResult other = RunLimpet(folder_.path(), {"tune", "mission", "--resume", "cut"});
  EXPECT_EQ(other.exit_code, kRefused);
  EXPECT_THAT(other.err, HasSubstr("cut was asked for with the mission small, not with mission"));
  const CommandResult resumed =
      RunLimpet(folder_.path(), {"tune", "small", "--runs=2", "--resume", "cut"});
  ASSERT_EQ(resumed.exit_code, kOk) << resumed.err;
  EXPECT_EQ(TextOfFile(At("cut/tune.json")), TextOfFile(At("whole/tune.json")));
  for (const auto& [file, time] : before)
    EXPECT_EQ(fs::last_write_time(file), time) << file << " was flown again";
}

TEST_F(TuneCommandLine, RefusesSlipsBeforeItSearches) {
  const auto complaint = [this](const std::vector<std::string>& more) {
    const CommandResult result = Tune("out", more);
    EXPECT_EQ(result.exit_code, kUsage) << result.err;
    return result.err;
  };
  const std::string objective = "--objective=sessions.discovery.path_m";
  EXPECT_THAT(complaint({objective}), HasSubstr("nothing to vary"));
  EXPECT_THAT(complaint({"--vary=cover.pwt=0:1"}), HasSubstr("--objective is missing"));
  EXPECT_THAT(complaint({objective, "--vary=cover.pwt=1:0"}), HasSubstr("not below"));
  EXPECT_THAT(complaint({objective, "--vary=covr.pwt=0:1"}), HasSubstr("did you mean `cover`"));
  EXPECT_THAT(complaint({objective, "--vary=cover.frontier_weigt=0:1"}),
              HasSubstr("did you mean `frontier_weight`"));
  EXPECT_THAT(complaint({objective, "--vary=cover.nosuch=0:1"}),
              StartsWith("cover.nosuch: no parameter `nosuch`"));
  EXPECT_THAT(complaint({objective, "--vary=cover.frontier_weight=0:999"}),
              HasSubstr("--vary cover.frontier_weight=0:999: `999` is not allowed; allowed: 0 to "
                        "100"));
  for (const char* again : {"--vary=cover.pwt=0:1", "--vary=cover.PWT=0:2"}) {
    EXPECT_THAT(complaint({objective, "--vary=cover.pwt=0:1", again}), HasSubstr("is given twice"));
  }
  EXPECT_THAT(complaint({objective, "--vary=home.when=0:1"}), HasSubstr("no number"));
  EXPECT_THAT(complaint({objective, "--vary=cover.pwt=0:1", "--constraint=seed"}),
              HasSubstr("compares nothing"));
  EXPECT_THAT(complaint({"--objective=1 +", "--vary=cover.pwt=0:1"}), HasSubstr("at 4"));
  EXPECT_THAT(complaint({"--objective=sessions.discovery.path", "--vary=cover.pwt=0:1"}),
              HasSubstr("did you mean `sessions.discovery.path_m`"));
  EXPECT_FALSE(fs::exists(At("out/results"))) << "nothing was flown for any of these";
}

/// LimpetDB and pHelm of the small mission, for as long as it lives.
class LiveHelm {
 public:
  explicit LiveHelm(const fs::path& mission) {
    const std::string port = fmt::format("--moos_port={}", FreePort());
    port_ = port.substr(std::string("--moos_").size());
    const fs::path here = fs::current_path();
    fs::current_path(mission);
    for (const char* program : {"LimpetDB", "pHelm"}) {
      children_.push_back(StartChild({.args = {"mission.moos", port},
                                      .log = std::string(program) + ".txt",
                                      .program = ProgramBeside(program).string()},
                                     SIGKILL));
    }
    fs::current_path(here);
  }
  LiveHelm(const LiveHelm&) = delete;
  LiveHelm& operator=(const LiveHelm&) = delete;
  ~LiveHelm() {
    for (const pid_t child : children_) {
      ::kill(child, SIGTERM);
      WaitForChild(child);
    }
  }
  [[nodiscard]] std::string port() const { return "--" + port_; }

 private:
  std::string port_;
  std::vector<pid_t> children_;
};

TEST_F(TuneCommandLine, ChangesABehaviorThatRunsAndTakesItBack) {
  const LiveHelm helm(At("small"));
  const auto live = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"tune", "--live", "small", helm.port(), "--wait=20"};
    words.insert(words.end(), more.begin(), more.end());
    return RunLimpet(folder_.path(), words);
  };
  const CommandResult first = live({"cover.frontier_weight=0.3"});
  EXPECT_EQ(first.exit_code, kOk) << first.err;
  EXPECT_THAT(first.out, HasSubstr("cover.frontier_weight: 0.5 -> 0.3, applied (1 of 1 updates "
                                   "good)"));
  EXPECT_THAT(live({"cover.frontier_weight=0.7"}).out, HasSubstr("0.3 -> 0.7, applied (2 of 2"));
  EXPECT_THAT(live({"cover.frontier_weight=0.7"}).out, HasSubstr("is 0.7 already"));
  EXPECT_EQ(live({"cover.frontier_weight=900"}).exit_code, kUsage);
  EXPECT_THAT(live({"hold.radius_m=2"}).err, HasSubstr("takes no updates"));
  EXPECT_THAT(live({"--undo"}).out, HasSubstr("0.7 -> 0.3, applied"));
  EXPECT_THAT(live({"--undo"}).out, HasSubstr("0.3 -> 0.5, applied"));
  const CommandResult none = live({"--undo"});
  EXPECT_EQ(none.exit_code, kFailed);
  EXPECT_THAT(none.err, HasSubstr("nothing to undo"));
}

TEST_F(TuneCommandLine, CountsOnlyWhatTheRunningHelmAppliedAndUndoesPastWhatItRefuses) {
  const LiveHelm helm(At("small"));
  const auto run = [&](std::vector<std::string> words, std::vector<std::string> more) {
    words.insert(words.end(), {"small", helm.port(), "--wait=20"});
    words.insert(words.end(), more.begin(), more.end());
    return RunLimpet(folder_.path(), words);
  };
  const auto live = [&](const std::string& wish) { return run({"tune", "--live"}, {wish}); };
  ASSERT_EQ(live("cover.frontier_weight=0.3").exit_code, kOk);
  const std::string updates = "COVER_UPDATES";
  ASSERT_EQ(run({"poke"}, {updates + ":=name=cover#frontier_weight=-1"}).exit_code, kOk);
  EXPECT_THAT(live("cover.frontier_weight=0.7").out, HasSubstr("0.3 -> 0.7, applied"))
      << "-1 was never in force";
  // As a change looks that was told with a value before it that nobody can set.
  const LiveEvent bad{.user = "ann",
                      .host = "boat",
                      .is_applied = true,
                      .change = {"cover", "frontier_weight", "900", "0.7"},
                      .undoable = {{"cover", "frontier_weight", "0.5", "0.3"},
                                   {"cover", "frontier_weight", "900", "0.7"}}};
  ASSERT_EQ(run({"poke"}, {"TUNE_EVENT:=" + bad.Text()}).exit_code, kOk);
  const CommandResult refused = live("--undo");
  EXPECT_EQ(refused.exit_code, kFailed);
  EXPECT_THAT(refused.err, HasSubstr("the helm refused cover.frontier_weight = 900"));
  EXPECT_THAT(live("--undo").out, HasSubstr("0.7 -> 0.5, applied"));
  EXPECT_THAT(live("--undo").err, HasSubstr("nothing to undo"));
}

}  // namespace
}  // namespace limpet

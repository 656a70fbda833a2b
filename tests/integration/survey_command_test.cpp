// SPDX-License-Identifier: MIT
// `limpet survey`, `report` and `change` as their users call them, on a small mission.
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "limpet/core/config.hpp"
#include "limpet/runs/folder_lock.hpp"
#include "tests/support/limpet_command.hpp"
#include "tests/support/small_mission.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

class SurveyCommandLine : public testing::Test {
 protected:
  SurveyCommandLine() { WriteSmallMission(folder_.path() / "small"); }
  CommandResult Run(const std::vector<std::string>& words) const {
    return RunLimpet(folder_.path(), words);
  }
  [[nodiscard]] fs::path At(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] nlohmann::json Sessions(const std::string& report) const {
    return nlohmann::json::parse(TextOfFile(At(report))).at("sessions");
  }
  void Write(const std::string& name, const std::string& text) const {
    fs::create_directories(At(name).parent_path());
    std::ofstream(At(name)) << text;
  }
  TemporaryFolder folder_;
};

std::map<std::string, std::string> StatusesOf(const nlohmann::json& session) {
  std::map<std::string, std::string> expected;
  for (const auto& change : session.at("changes")) {
    if (change.at("truth").is_string()) {
      expected[change.at("truth")] = change.at("expected").get<std::string>();
    }
  }
  return expected;
}

TEST_F(SurveyCommandLine, ComparesEachOfThreeSessionsWithTheOneBefore) {
  Write("run/.lock", "999999999\n");  // of a process that is long dead
  const CommandResult survey =
      Run({"survey", "small", "--out", "run", "--sessions", "discovery,change,third"});
  EXPECT_EQ(survey.exit_code, kOk) << survey.err << survey.out;
  EXPECT_THAT(survey.out, HasSubstr("THIRD"));
  EXPECT_THAT(survey.out, HasSubstr("compared with change"));
  EXPECT_THAT(survey.out + survey.err, Not(HasSubstr("\033")));
  const nlohmann::json sessions = Sessions("run/report.json");
  EXPECT_EQ(StatusesOf(sessions.at("change")).at("goes"), "removed");
  EXPECT_EQ(StatusesOf(sessions.at("third")).at("goes"), "new");
  EXPECT_TRUE(fs::exists(At("run/figures/third_status.svg")));

  const CommandResult again = Run({"report", "run", "--json"});
  EXPECT_EQ(again.exit_code, kOk) << again.err;
  EXPECT_EQ(nlohmann::json::parse(again.out).at("sessions"), sessions);

  const CommandResult change =
      Run({"change", "--session-a", "run/change", "--session-b", "run/third"});
  EXPECT_EQ(change.exit_code, kOk) << change.err;
  EXPECT_EQ(nlohmann::json::parse(change.out).at("session_b").at("session"), "third");
}

TEST_F(SurveyCommandLine, ReportsAlsoTheSessionsThatWereFlownBefore) {
  const CommandResult first = Run({"survey", "small", "--out", "run", "--sessions", "discovery"});
  ASSERT_EQ(first.exit_code, kOk) << first.err << first.out;
  const nlohmann::json discovery = Sessions("run/report.json").at("discovery");
  const CommandResult later = Run({"survey", "small", "--out", "run", "--sessions", "change"});
  EXPECT_EQ(later.exit_code, kOk) << later.err << later.out;
  EXPECT_THAT(later.out, HasSubstr("DISCOVERY"));
  EXPECT_EQ(Sessions("run/report.json").at("discovery"), discovery);
  EXPECT_EQ(StatusesOf(Sessions("run/report.json").at("change")).at("goes"), "removed");
}

TEST_F(SurveyCommandLine, ReplacesAnEarlierRunAndNothingElse) {
  Write("small/expect.yaml", "each: {path_m: {max: 0.01}}\n");
  const std::vector<std::string> words{"survey", "small",      "--out",
                                       "run",    "--sessions", "discovery"};
  const CommandResult first = Run(words);
  EXPECT_EQ(first.exit_code, kFailed) << "a bound is broken: " << first.out;
  EXPECT_THAT(first.out, HasSubstr("path_m"));
  Write("run/discovery/mine.txt", "precious");
  Write("run/notes.txt", "precious");
  const std::string report = TextOfFile(At("run/report.json"));

  const CommandResult refused = Run(words);
  EXPECT_EQ(refused.exit_code, kRefused);
  EXPECT_THAT(refused.err, HasSubstr("discovery/mine.txt"));
  EXPECT_EQ(TextOfFile(At("run/report.json")), report) << "nothing was touched";

  fs::rename(At("run/discovery/mine.txt"), At("mine.txt"));
  EXPECT_EQ(Run(words).exit_code, kFailed);
  EXPECT_EQ(TextOfFile(At("run/notes.txt")), "precious");
}

TEST_F(SurveyCommandLine, RefusesSessionNamesThatLeaveTheRun) {
  Write("x/precious.txt", "precious");
  for (const std::string& name :
       {std::string("../../x"), std::string("../x"), At("x").string(), std::string(""),
        std::string("discovery,"), std::string("discovery,discovery"), std::string("figures"),
        std::string("thrid")}) {
    const CommandResult result = Run({"survey", "small", "--out", "runs/a", "--sessions", name});
    EXPECT_EQ(result.exit_code, kUsage) << name << ": " << result.err;
    EXPECT_THAT(result.err, HasSubstr("--sessions")) << name;
    EXPECT_FALSE(fs::exists(At("runs"))) << name;
  }
  EXPECT_EQ(TextOfFile(At("x/precious.txt")), "precious");
}

TEST_F(SurveyCommandLine, RefusesAFolderThatHoldsSomethingElse) {
  Write("out/thesis.tex", "precious");
  const CommandResult result = Run({"survey", "small", "--out", "out"});
  EXPECT_EQ(result.exit_code, kRefused);
  EXPECT_THAT(result.err, HasSubstr("thesis.tex"));
  EXPECT_EQ(TextOfFile(At("out/thesis.tex")), "precious");
  EXPECT_EQ(Run({"survey", "small", "--out", "out/thesis.tex"}).exit_code, kRefused);
}

TEST_F(SurveyCommandLine, RefusesAFolderThatAnotherRunIsWriting) {
  fs::create_directories(At("run"));
  const FolderLock held(At("run"));
  const CommandResult result = Run({"survey", "small", "--out", "run"});
  EXPECT_EQ(result.exit_code, kRefused);
  EXPECT_THAT(result.err, HasSubstr("in use by another run"));
}

TEST_F(SurveyCommandLine, EndsWithTwoForWrongUsageAndConfiguration) {
  EXPECT_EQ(Run({"survey"}).exit_code, kUsage);
  EXPECT_EQ(Run({"survey", ""}).exit_code, kUsage);
  EXPECT_EQ(Run({"survey", "small", "--out", ""}).exit_code, kUsage);
  EXPECT_EQ(Run({"survey", "nowhere"}).exit_code, kUsage);
  EXPECT_THAT(Run({"survey", "small", "--sedd", "1"}).err, HasSubstr("did you mean --seed"));
  Write("small/scenario.yaml", "seabed: {depth_m: \"\\e[2J\"}\n\"\\e]0;title\\a\": 1\n");
  const CommandResult result = Run({"survey", "small"});
  EXPECT_EQ(result.exit_code, kUsage);
  EXPECT_THAT(result.err, HasSubstr("scenario.yaml:"));
  EXPECT_THAT(result.err, Not(HasSubstr("\033")));
}

TEST_F(SurveyCommandLine, ReportsADiveWithoutTruthWithoutJudgingIt) {
  const CommandResult survey =
      Run({"survey", "small", "--out", "run", "--sessions", "discovery", "--without-truth"});
  ASSERT_EQ(survey.exit_code, kOk) << survey.err << survey.out;
  const CommandResult report = Run({"report", "run"});  // its log has no SIM_TRUTH
  EXPECT_EQ(report.exit_code, kOk) << report.err;
  EXPECT_THAT(report.out, HasSubstr("no truth"));
  for (const char* word : {"INVENTED", "MISSED", "rms", "NEES"}) {
    EXPECT_THAT(report.out, Not(HasSubstr(word)));
  }
  const nlohmann::json session = Sessions("run/report.json").at("discovery");
  EXPECT_TRUE(session.at("false").is_null());
  EXPECT_THAT(session.at("nav"), Each(nlohmann::json(nullptr)));

  // A mission of the field: no scenario, no run.json; the log is all there is.
  fs::remove(At("small/scenario.yaml"));
  fs::create_directories(At("dive/discovery"));
  fs::copy(At("run/discovery"), At("dive/discovery"), fs::copy_options::recursive);
  EXPECT_EQ(Run({"report", "dive"}).exit_code, kUsage) << "nobody says which mission it was";
  const CommandResult dive = Run({"report", "dive", "--mission", "small"});
  EXPECT_EQ(dive.exit_code, kOk) << dive.err;
  EXPECT_THAT(dive.out, HasSubstr("no truth"));
}

TEST_F(SurveyCommandLine, ReportWritesOverNothingThatIsNotAReport) {
  EXPECT_EQ(Run({"report"}).exit_code, kUsage);
  EXPECT_EQ(Run({"report", "nowhere"}).exit_code, kUsage);
  fs::create_directories(At("empty"));
  EXPECT_EQ(Run({"report", "empty"}).exit_code, kUsage);
  EXPECT_TRUE(fs::is_empty(At("empty")));
  EXPECT_EQ(Run({"report", "empty", "--mission", "small"}).exit_code, kFailed) << "no log";
  Write("dive/report.html", "precious");
  Write("dive/discovery/discovery.alog", "%% LOGSTART 1767225600\n0.5 MISSION_END pSurvey home\n");
  const CommandResult result = Run({"report", "dive", "--mission", "small"});
  EXPECT_EQ(result.exit_code, kRefused) << result.out;
  EXPECT_THAT(result.err, HasSubstr("report.html"));
  EXPECT_EQ(TextOfFile(At("dive/report.html")), "precious");
}

TEST_F(SurveyCommandLine, ChangeTakesTwoSessions) {
  EXPECT_EQ(Run({"change", "--session-a", "run/discovery"}).exit_code, kUsage);
  EXPECT_NE(Run({"change", "--session-a", "nowhere", "--session-b", "no\033[2J"}).exit_code, kOk);
}

}  // namespace
}  // namespace limpet

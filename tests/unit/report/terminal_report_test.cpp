// SPDX-License-Identifier: MIT
#include "limpet/report/terminal_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/scoring/verdict.hpp"
#include "tests/support/synthetic_session.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;
using testing::Not;

RunScore BriefRun(bool has_mistakes) {
  SyntheticSession session;
  session.name = "change";
  session.seconds_of_survey = 20.0;
  session.opis = RightBeliefs(Table1Scenario(), "change", 0.3);
  if (has_mistakes) session.opis[0].decided = Status::kRemoved;
  return ScoreRun({RecordOf(session)}, Table1Scenario(), Table1Settings());
}

TEST(TerminalReport, IsPlainWithoutATerminal) {
  const std::string text = TerminalReport(BriefRun(false), false);
  EXPECT_THAT(text, Not(HasSubstr("\033")));
  EXPECT_THAT(text, Not(HasSubstr("<td>")));
}

TEST(TerminalReport, NamesAWrongStatusAndAMissedObject) {
  const std::string text = TerminalReport(BriefRun(true), false);
  EXPECT_THAT(text, HasSubstr("WRONG"));
  EXPECT_THAT(text, HasSubstr("MISSED"));
}

TEST(TerminalReport, SaysWhatAnOpenObjectMayBe) {
  RunScore run = BriefRun(false);
  ChangeScore& change = run.sessions[0].opis.changes.at(0);
  change.decided = Status::kUncertain;
  change.posterior =
      StatusPosterior{.confirmed = 0.72, .removed = 0.25, .appeared = 0.0, .nothing = 0.03};
  EXPECT_THAT(TerminalReport(run, false), HasSubstr("open: confirmed or removed\n"));
  change.decided = Status::kNotInspected;
  EXPECT_THAT(TerminalReport(run, false), HasSubstr(" open\n"));
}

TEST(TerminalReport, SaysNoProbabilityOfWhatNoLookSaysAnythingAbout) {
  RunScore run = BriefRun(false);
  ChangeScore& change = run.sessions[0].opis.changes.at(0);
  change.decided = Status::kNotInspected;
  change.posterior.reset(), change.probability.reset();
  const std::string text = TerminalReport(run, false);
  EXPECT_THAT(text, HasSubstr("not_inspected      -"));
}

TEST(TerminalReport, FitsA100ColumnTerminalInItsTables) {
  const std::string text = TerminalReport(BriefRun(false), false);
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    EXPECT_LE(line.size(), 100U) << line;
    begin = end + 1;
  }
}

TEST(TerminalReport, SaysWhereTheTimeWent) {
  EXPECT_THAT(TerminalReport(BriefRun(false), false),
              HasSubstr("  time [s]: DIVE 20, SURVEY 20, ASCEND "));
}

TEST(TerminalReport, SaysTheLeastWayAndWhatWasNotSeen) {
  const std::string text = TerminalReport(BriefRun(false), false);
  EXPECT_THAT(text, HasSubstr("  least way 322 m, 1080 m2 over a swath of 3.36 m\n"));
  EXPECT_THAT(text, testing::ContainsRegex("  not seen of the band: .*not reached 9[0-9]"));
}

TEST(TerminalReport, SaysNeverForALevelNotReached) {
  EXPECT_THAT(TerminalReport(BriefRun(false), false), HasSubstr("never"));
}

TEST(TerminalReport, SaysThatThereWasNoTruthInsteadOfJudging) {
  SyntheticSession session;
  session.name = "change";
  session.seconds_of_survey = 20.0;
  session.opis = RightBeliefs(Table1Scenario(), "change", 0.3);
  SessionRecord record = RecordOf(session);
  record.truth = {};
  const std::string text =
      TerminalReport(ScoreRun({record}, Table1Scenario(), Table1Settings()), false);
  EXPECT_THAT(text, HasSubstr("no truth"));
  for (const char* word : {"INVENTED", "MISSED", "WRONG", "rms", "NEES"}) {
    EXPECT_THAT(text, Not(HasSubstr(word)));
  }
}

TEST(TerminalReport, ObeysNothingThatAMissionSays) {
  Scenario scenario = Table1Scenario();
  for (ScenarioOpi& opi : scenario.opis)
    opi.name += "\033[2J\n";
  SyntheticSession session;
  session.seconds_of_survey = 20.0;
  session.opis = RightBeliefs(scenario, "discovery", 0.3);
  session.opis.pop_back();
  ReportSettings settings = Table1Settings();
  settings.mission = "m\033]0;x\007";
  const std::string text = TerminalReport(ScoreRun({RecordOf(session)}, scenario, settings), false);
  EXPECT_THAT(text, Not(HasSubstr("\033")));
  EXPECT_THAT(text, HasSubstr("OPI 1\\x1b[2J\\n"));
}

TEST(Verdict, IsBadWhenTheVehicleIsNotHome) { EXPECT_FALSE(VerdictOf(BriefRun(false)).is_good); }

TEST(Verdict, IsBadOfNoSessionAtAll) { EXPECT_FALSE(VerdictOf(RunScore{}).is_good); }

}  // namespace
}  // namespace limpet

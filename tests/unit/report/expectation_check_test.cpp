// SPDX-License-Identifier: MIT
#include "limpet/report/expectation_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/report/report_json.hpp"
#include "tests/support/synthetic_session.hpp"

namespace limpet {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RunScore ChangeRun(bool has_wrong_status) {
  SyntheticSession session;
  session.name = "change";
  session.seconds_of_survey = 20.0;
  session.opis = RightBeliefs(Table1Scenario(), "change", 0.3);
  if (has_wrong_status) session.opis[0].decided = Status::kRemoved;
  return ScoreRun({RecordOf(session)}, Table1Scenario(), Table1Settings());
}

ExpectationCheck Check(const RunScore& run, const std::string& expected) {
  return CheckReport(ParseExpectations(expected, "expect.yaml", {"change"}), ReportJson(run));
}

TEST(ExpectationCheck, KeepsBoundsThatTheReportIsInside) {
  const ExpectationCheck check =
      Check(ChangeRun(false),
            "each: {missed: {max: 0}, error_m: {max: 1}}\nchange: {wrong_statuses: {max: 0}}\n");
  EXPECT_EQ(check.compared, 3);
  EXPECT_THAT(check.breaches, IsEmpty());
}

TEST(ExpectationCheck, SaysWhichBoundBrokeAndWhereItStands) {
  const ExpectationCheck check = Check(ChangeRun(true), "change:\n  wrong_statuses: {max: 0}\n");
  EXPECT_THAT(check.breaches,
              ElementsAre("change: wrong_statuses is 1, expected at most 0 (expect.yaml:2)"));
}

TEST(ExpectationCheck, MayBeUncertainAndWrongWhenUnsure) {
  const std::string expected = "change:\n  wrong_when_sure: {max: 0}\n";
  RunScore run = ChangeRun(false);
  ChangeScore& change = run.sessions[0].opis.changes[0];
  EXPECT_THAT(Check(run, expected).breaches, IsEmpty());
  change.decided = Status::kUncertain, change.probability = 0.97;
  EXPECT_THAT(Check(run, expected).breaches, IsEmpty());
  change.decided = Status::kRemoved, change.probability = 0.94;
  EXPECT_THAT(Check(run, expected).breaches, IsEmpty());
  change.probability = 0.95;
  EXPECT_THAT(Check(run, expected).breaches, ElementsAre(HasSubstr("wrong_when_sure is 1")));
  change.truth.reset(), change.expected.reset();
  EXPECT_THAT(Check(run, expected).breaches, ElementsAre(HasSubstr("wrong_when_sure is 1")));
}

TEST(ExpectationCheck, AWayToALevelNeverReachedKeepsNoBound) {
  const ExpectationCheck check =
      Check(ChangeRun(false), "each:\n  coverage_95_path_m: {max: 9999}\n");
  EXPECT_THAT(check.breaches, ElementsAre(HasSubstr("never reached")));
}

TEST(ExpectationCheck, HoldsThePlannerThatTheyAreForToItsBounds) {
  RunScore run = ChangeRun(false);
  run.settings.planner = "lawnmower";
  const std::string bound = "change:\n  coverage_95_path_m: {max: 9999}\n";
  EXPECT_TRUE(Check(run, bound).is_other_method);
  const ExpectationCheck check = Check(run, "planner: lawnmower\n" + bound);
  EXPECT_FALSE(check.is_other_method);
  EXPECT_FALSE(check.is_kept());
}

TEST(ExpectationCheck, HoldsThePapersPlannerToNothing) {
  RunScore run = ChangeRun(true);
  run.settings.planner = "paper";
  const ExpectationCheck check = Check(run, "change:\n  wrong_statuses: {max: 0}\n");
  EXPECT_TRUE(check.is_other_method);
  EXPECT_TRUE(check.is_kept());
}

TEST(ExpectationCheck, HoldsAThirdSessionToItsBounds) {
  Scenario scenario = Table1Scenario();
  for (ScenarioOpi& opi : scenario.opis)
    opi.places["third"] = opi.Place("change");
  SyntheticSession session;
  session.name = "third";
  session.former = "change";
  session.seconds_of_survey = 20.0;
  session.opis = RightBeliefs(Table1Scenario(), "change", 0.3);  // says "removed" of what was gone
  const RunScore run = ScoreRun({RecordOf(session)}, scenario, Table1Settings());
  const ExpectationCheck check =
      CheckReport(ParseExpectations("third: {wrong_statuses: {max: 0}}", "expect.yaml", {"third"}),
                  ReportJson(run));
  EXPECT_EQ(check.compared, 1);
  EXPECT_THAT(check.breaches, ElementsAre(HasSubstr("third: wrong_statuses is ")));
}

TEST(ExpectationCheck, TakesWhatNobodyCouldMeasureForNoBoundKept) {
  SyntheticSession session;
  session.seconds_of_survey = 20.0;
  SessionRecord record = RecordOf(session);
  record.truth = {};
  const RunScore run = ScoreRun({record}, Table1Scenario(), Table1Settings());
  const ExpectationCheck check = Check(
      run, "each: {missed: {max: 0}, error_m: {max: 1}, covered: {min: 0.9}, nees_mean: {max: 9}}");
  EXPECT_EQ(check.breaches.size(), 4U);
}

/// A key of expect.yaml that no report has would break every run.
TEST(ExpectationCheck, FindsEveryNumberThatMayBeBounded) {
  RunScore run = ChangeRun(false);
  run.sessions[0].wall_s = 1.0;
  run.sessions[0].coverage.prior_opis_seen_path_m = 1.0;
  run.sessions[0].home_error_m = 1.0;
  run.sessions[0].obstacles = {{.name = "pile", .distance_m = 1.0}};
  for (CoverageLevel& level : run.sessions[0].coverage.seabed)
    level.path_m = 1.0;
  for (CoverageLevel& level : run.sessions[0].coverage.band)
    level.path_m = 1.0;
  std::string expected = "change:\n";
  for (const std::string& key : ExpectableNumbers()) {
    expected += "  " + key + ": {min: -1000000, max: 1000000}\n";
  }
  EXPECT_THAT(Check(run, expected).breaches, IsEmpty());
}

}  // namespace
}  // namespace limpet

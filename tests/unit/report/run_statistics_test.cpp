// SPDX-License-Identifier: MIT
#include "limpet/report/run_statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/report/paper_tables.hpp"
#include "limpet/report/report_json.hpp"
#include "tests/support/synthetic_session.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

/// A short change session whose objects are all where they should be, or all but the first.
std::string ReportOf(bool has_wrong_status) {
  SyntheticSession session;
  session.name = "change";
  session.seconds_of_survey = 20.0;
  session.opis = RightBeliefs(Table1Scenario(), "change", 0.3);
  if (has_wrong_status) session.opis[0].decided = Status::kRemoved;
  return ReportJson(ScoreRun({RecordOf(session)}, Table1Scenario(), Table1Settings()));
}

TEST(Statistic, HasTheSampleDeviation) {
  Statistic statistic;
  for (const double sample : {2.0, 4.0, 6.0})
    statistic.Add(sample);
  EXPECT_DOUBLE_EQ(statistic.sd(), 2.0);
}

TEST(Statistic, CountsWhatWasNeverReachedWithoutAveragingIt) {
  Statistic statistic;
  statistic.Add(4.0);
  statistic.Add(std::nullopt);
  EXPECT_EQ(statistic.mean(), 4.0);
  EXPECT_EQ(statistic.asked(), 2U);
}

TEST(RunStatistics, CountsTheRunsWithEveryStatusRight) {
  RunStatistics runs;
  EXPECT_FALSE(runs.Add(ReportOf(false)));
  EXPECT_FALSE(runs.Add(ReportOf(true)));
  EXPECT_EQ(runs.sessions["change"].statuses_right.good, 1);
  EXPECT_EQ(runs.sessions["change"].statuses_right.of, 2);
}

TEST(RunStatistics, CallsARunThatDidNotCoverTheAreaFlawed) {
  RunStatistics runs;
  EXPECT_FALSE(runs.Add(ReportOf(false)));
  EXPECT_EQ(runs.flawless.good, 0);
}

TEST(RunStatistics, IsUnchangedByABrokenReport) {
  RunStatistics runs;
  EXPECT_TRUE(runs.Add("{\"mission\": \"table1\", \"sessions\": {\"change\": {}}}"));
  EXPECT_EQ(runs.runs, 0);
  EXPECT_TRUE(runs.sessions.empty());
}

TEST(RunStatistics, JudgesNoSessionWithoutTruth) {
  SyntheticSession session;
  session.seconds_of_survey = 20.0;
  SessionRecord record = RecordOf(session);
  record.truth = {};
  RunStatistics runs;
  EXPECT_FALSE(runs.Add(ReportJson(ScoreRun({record}, Table1Scenario(), Table1Settings()))));
  EXPECT_EQ(runs.flawless.good, 0);
  EXPECT_EQ(runs.sessions["discovery"].none_missed.of, 0);
  EXPECT_EQ(runs.sessions["discovery"].position_rmse_m.asked(), 0U);
}

TEST(PaperTables, HaveTheStatusesOfEverySessionWithAFormerOne) {
  SyntheticSession session;
  session.name = "third";
  session.former = "change";
  session.seconds_of_survey = 20.0;
  session.opis = RightBeliefs(Table1Scenario(), "change", 0.3);
  RunStatistics runs;
  EXPECT_FALSE(
      runs.Add(ReportJson(ScoreRun({RecordOf(session)}, Table1Scenario(), Table1Settings()))));
  const std::string text = PlainText(PaperTables(runs));
  EXPECT_THAT(text, HasSubstr("Statuses, third session"));
  EXPECT_THAT(text, HasSubstr("Way: third session"));
}

TEST(PaperTables, ObeyNothingThatAMissionSays) {
  const std::string text = PlainText({{"t\033[2J", {"a"}, {{"x\ny"}}, "n\a"}});
  EXPECT_EQ(text, "t\\x1b[2J\n  a\n  x\\ny\n  n\\x07\n");
}

TEST(PaperTables, NameTheSeedsThatLeftNoReport) {
  RunStatistics runs;
  EXPECT_FALSE(runs.Add(ReportOf(false)));
  runs.failed = {7, 9};
  EXPECT_THAT(PlainText(PaperTables(runs)), HasSubstr("2 more runs left no report: seed 7 9."));
}

TEST(PaperTables, SayInHowManyRunsALevelWasReached) {
  RunStatistics runs;
  EXPECT_FALSE(runs.Add(ReportOf(false)));
  SessionStatistics& session = runs.sessions["change"];
  session.seabed_path_m[0.95] = Statistic();
  session.seabed_path_m[0.95].Add(200.0);
  session.seabed_path_m[0.95].Add(std::nullopt);
  EXPECT_THAT(PlainText(PaperTables(runs)), HasSubstr("200.0 \u00b1 0.0 (1 of 2)"));
}

TEST(PaperTables, ShowTheBasinsTablesForTheBasin) {
  RunStatistics runs;
  EXPECT_FALSE(runs.Add(ReportOf(false)));
  runs.mission = "basin";
  EXPECT_THAT(Markdown(PaperTables(runs)), HasSubstr("Table 8"));
}

TEST(PaperTables, AlignColumnsThatHoldPlusMinusSigns) {
  const std::string text =
      PlainText({{"t", {"a", "b"}, {{"x", "1.0 \u00b1 0.5"}, {"y", "12.0 + 0.5"}}, ""}});
  EXPECT_THAT(text, HasSubstr("  x   1.0 \u00b1 0.5\n  y  12.0 + 0.5\n"));
}

}  // namespace
}  // namespace limpet

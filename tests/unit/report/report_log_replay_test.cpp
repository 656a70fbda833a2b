// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/figures/figures.hpp"
#include "limpet/logbook/alog_writer.hpp"
#include "limpet/report/report_json.hpp"
#include "limpet/scoring/log_replay.hpp"
#include "tests/support/synthetic_session.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

SyntheticSession BriefChange() {
  SyntheticSession session;
  session.name = "change";
  session.seconds_of_survey = 30.0;
  session.opis = RightBeliefs(Table1Scenario(), "change", 0.3);
  return session;
}

/// The session as its folder gives it back, with its messages as pLog would leave them.
SessionRecord Replayed() {
  const TemporaryFolder run;
  const fs::path folder = run.path() / "change";
  fs::create_directories(folder);
  {
    AlogWriter writer = *AlogWriter::Open(folder / "change.alog", Seconds(kEpoch), {});
    for (const Message& message : MessagesOf(BriefChange()))
      writer.Write(message);
  }
  return *RecordFromLog(folder);
}

/// Live and replayed, both scored.
struct BothWays {
  SessionRecord live = RecordOf(BriefChange());
  SessionRecord replayed = Replayed();
};

std::string JsonOf(const SessionRecord& record) {
  return ReportJson(ScoreRun({record}, Table1Scenario(), Table1Settings()));
}

TEST(LogReplay, GivesTheSameReportAsListeningLive) {
  const BothWays both;
  EXPECT_EQ(JsonOf(both.live), JsonOf(both.replayed));
}

TEST(LogReplay, GivesTheSameFiguresAsListeningLive) {
  const BothWays both;
  const Scenario scenario = Table1Scenario();
  const ReportSettings settings = Table1Settings();
  const SessionScore score = ScoreSession(both.live, scenario, settings);
  const auto live = FiguresOf({both.live, score, settings, scenario});
  const auto replayed = FiguresOf({both.replayed, score, settings, scenario});
  ASSERT_EQ(live.size(), replayed.size());
  for (std::size_t i = 0; i < live.size(); ++i)
    EXPECT_EQ(live[i].svg, replayed[i].svg) << live[i].file;
}

TEST(LogReplay, NamesTheSessionAfterItsFolder) { EXPECT_EQ(Replayed().name, "change"); }

TEST(LogReplay, TakesTheLastOfSeveralRuns) {
  const TemporaryFolder run;
  for (const auto& [name, begin] : {std::pair{"9", 1.0}, {"1", 3.0}, {"5", 2.0}}) {
    SyntheticSession session = BriefChange();
    session.seconds_of_survey = 10.0 * begin;
    AlogWriter writer =
        *AlogWriter::Open(run.path() / (std::string(name) + ".alog"), Seconds(begin), {});
    for (const Message& message : MessagesOf(session))
      writer.Write(message);
  }
  SyntheticSession last = BriefChange();
  last.name = run.path().filename().string();
  EXPECT_EQ(RecordFromLog(run.path())->truth.size(), RecordOf(last).truth.size());
}

TEST(LogReplay, SaysWhichFolderHoldsNoLog) {
  const TemporaryFolder run;
  const auto record = RecordFromLog(run.path() / "no_such_session");
  ASSERT_FALSE(record.has_value());
  EXPECT_THAT(record.error().text, testing::HasSubstr("no_such_session"));
}

}  // namespace
}  // namespace limpet

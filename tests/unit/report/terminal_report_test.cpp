// SPDX-License-Identifier: MIT
#include "apps/limpet/report/terminal_report.hpp"

#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/console/progress_line.hpp"
#include "apps/limpet/report/verdict.hpp"

#include "synthetic_session.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;
using testing::Not;

RunScore BriefRun(bool has_mistakes) {
  SyntheticSession session;
  session.name = "change";
  session.seconds_of_survey = 20.0;
  session.opis = RightBeliefs(Table1Scenario(), "change", 0.3);
  if (has_mistakes) session.opis[0].decided = "removed";
  return ScoreRun({RecordOf(session)}, Table1Scenario(), Table1Settings());
}

TEST(TerminalReport, IsPlainWithoutATerminal) {
  EXPECT_THAT(TerminalReport(BriefRun(false), false), Not(HasSubstr("\033")));
}

TEST(TerminalReport, NamesAWrongStatusAndAMissedObject) {
  const std::string text = TerminalReport(BriefRun(true), false);
  EXPECT_THAT(text, HasSubstr("WRONG"));
  EXPECT_THAT(text, HasSubstr("MISSED"));
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

TEST(TerminalReport, SaysNeverForALevelNotReached) {
  EXPECT_THAT(TerminalReport(BriefRun(false), false), HasSubstr("never"));
}

TEST(Verdict, IsBadWhenTheVehicleIsNotHome) { EXPECT_FALSE(VerdictOf(BriefRun(false)).is_good); }

TEST(Verdict, IsBadOfNoSessionAtAll) { EXPECT_FALSE(VerdictOf(RunScore{}).is_good); }

TEST(ProgressLine, WritesAboutEveryTenthWhereThereIsNoTerminal) {
  std::FILE* file = std::tmpfile();
  {
    ProgressLine progress("survey", file);
    for (int i = 0; i <= 1000; ++i)
      progress.Update(i / 1000.0, "going");
  }
  std::rewind(file);
  int lines = 0;
  for (int letter = std::fgetc(file); letter != EOF; letter = std::fgetc(file))
    lines += letter == '\n';
  std::fclose(file);
  EXPECT_EQ(lines, 11);
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/console/progress_line.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/console/shown_text.hpp"
#include "tests/support/pseudo_terminal.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kLongDetail =
    "SURVEY  seabed 100 %  band 100 %  objects 12, last seen near the wall";

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
    lines += letter == '\n' ? 1 : 0;
  std::fclose(file);
  EXPECT_EQ(lines, 11);
}

/// A line of progress on a terminal of this width.
class ProgressOnTerminal {
 public:
  explicit ProgressOnTerminal(unsigned short columns) : terminal_(columns) {}
  PseudoTerminal& terminal() { return terminal_; }
  ProgressLine& line() { return line_; }
  /// What the last write shows, without what clears the line.
  std::string Shown() {
    const std::string written = terminal_.Written();
    const std::size_t begin = written.rfind("\033[K");
    return begin == std::string::npos ? written : written.substr(begin + 3);
  }

 private:
  PseudoTerminal terminal_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream_{terminal_.Open(), std::fclose};
  ProgressLine line_{"discovery", stream_.get()};
};

TEST(ProgressLine, FitsTheTerminalsWidth) {
  for (const unsigned short columns : std::initializer_list<unsigned short>{80, 40, 20, 7, 1}) {
    ProgressOnTerminal progress(columns);
    progress.line().Announce(0.5, kLongDetail);
    EXPECT_LT(ColumnsOf(progress.Shown()), columns) << columns;
  }
}

TEST(ProgressLine, KeepsWhatIsGoingOnAndGivesUpTheBarFirst) {
  ProgressOnTerminal progress(40);
  progress.line().Announce(0.5, "DIVE  diving");
  const std::string wide = progress.Shown();
  EXPECT_THAT(wide, HasSubstr("#"));
  EXPECT_THAT(wide, HasSubstr("DIVE  diving"));
  progress.line().Announce(0.5, "SURVEY  seabed  12 %  band");
  const std::string narrow = progress.Shown();
  EXPECT_THAT(narrow, Not(HasSubstr("#")));
  EXPECT_THAT(narrow, HasSubstr(" 50 %  SURVEY"));
}

TEST(ProgressLine, FollowsAChangeOfTheWidth) {
  ProgressOnTerminal progress(120);
  progress.line().Announce(0.5, kLongDetail);
  EXPECT_THAT(progress.Shown(), HasSubstr(kLongDetail));
  progress.terminal().SetColumns(30);
  progress.line().Announce(0.6, kLongDetail);
  EXPECT_LT(ColumnsOf(progress.Shown()), 30U);
}

TEST(ProgressLine, ObeysNothingThatItsTextsSay) {
  ProgressOnTerminal progress(80);
  progress.line().Announce(0.5, "seed\033[2J 7\n\n");
  EXPECT_THAT(progress.Shown(), HasSubstr("seed\\x1b[2J 7\\n\\n"));
}

}  // namespace
}  // namespace limpet

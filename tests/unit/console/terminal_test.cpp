// SPDX-License-Identifier: MIT
#include "limpet/console/terminal.hpp"

#include <algorithm>
#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "tests/support/pseudo_terminal.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Code = Key::Code;

TEST(KeyReader, TellsKeysApart) {
  KeyReader reader;
  EXPECT_THAT(reader.Feed("q\033[A\033OB\033[6~\r\x7f"),
              ElementsAre(Key{Code::kCharacter, 'q'}, Key{Code::kUp}, Key{Code::kDown},
                          Key{Code::kPageDown}, Key{Code::kEnter}, Key{Code::kBackspace}));
}

TEST(KeyReader, WaitsForTheRestOfASequence) {
  KeyReader reader;
  EXPECT_THAT(reader.Feed("\033[5"), ElementsAre());
  EXPECT_THAT(reader.Feed("~"), ElementsAre(Key{Code::kPageUp}));
}

TEST(KeyReader, TakesALoneEscapeForTheKey) {
  KeyReader reader;
  EXPECT_THAT(reader.Feed("\033"), ElementsAre(Key{Code::kEscape}));
}

TEST(KeyReader, SwallowsSequencesItDoesNotKnow) {
  KeyReader reader;
  EXPECT_THAT(reader.Feed("\033[1;5Cq"),
              ElementsAre(Key{Code::kOther}, Key{Code::kCharacter, 'q'}));
  EXPECT_THAT(reader.Feed("\033[" + std::string(30, '1')), ElementsAre(Key{Code::kOther}));
}

Frame TextFrame(const std::vector<std::string>& lines) {
  Frame frame;
  for (const std::string& line : lines) {
    frame.push_back(FrameLine().Add(line));
  }
  return frame;
}

TEST(FrameWriter, WritesEveryLineOnce) {
  FrameWriter writer(true);
  EXPECT_EQ(writer.Update(TextFrame({"a", "b"}), {.columns = 9, .lines = 2}),
            "\033[1;1Ha\033[K\033[2;1Hb\033[K");
  EXPECT_EQ(writer.Update(TextFrame({"a", "b"}), {.columns = 9, .lines = 2}), "");
}

TEST(FrameWriter, WritesOnlyWhatHasChanged) {
  FrameWriter writer(true);
  static_cast<void>(writer.Update(TextFrame({"a", "b"}), {.columns = 9, .lines = 2}));
  EXPECT_EQ(writer.Update(TextFrame({"a", "c"}), {.columns = 9, .lines = 2}), "\033[2;1Hc\033[K");
}

TEST(FrameWriter, ErasesNothingBehindAFullLine) {
  FrameWriter writer(true);
  EXPECT_EQ(writer.Update(TextFrame({"abc"}), {.columns = 3, .lines = 1}), "\033[1;1Habc");
}

TEST(FrameWriter, WritesAllAgainOnAnotherSize) {
  FrameWriter writer(true);
  static_cast<void>(writer.Update(TextFrame({"a"}), {.columns = 9, .lines = 1}));
  EXPECT_EQ(writer.Update(TextFrame({"a"}), {.columns = 8, .lines = 2}),
            "\033[1;1Ha\033[K\033[2;1H\033[K");
}

TEST(FrameLine, IsAsciiWhereATerminalReadsNothingElse) {
  // Its second byte would begin a control sequence on a terminal of eight-bit controls.
  EXPECT_EQ(FrameLine().Add("\u015b").MakeAscii().PlainText(), "\\u015b");
}

TEST(Painted, HasNoColorsWithoutColors) {
  for (int ink = 0; ink <= static_cast<int>(Ink::kGood); ++ink) {
    const FrameLine line = FrameLine().Add("x", static_cast<Ink>(ink));
    EXPECT_THAT(Painted(line, false), Not(HasSubstr("\033[3")));
    EXPECT_THAT(Painted(line, false), Not(HasSubstr(";3")));
  }
}

constexpr const char* kAlternateScreen = "\033[?1049h";
constexpr const char* kFormerScreen = "\033[m\033[?7h\033[?25h\033[?1049l";

TEST(Terminal, ShowsFramesOnAScreenOfItsOwnAndLeavesNothingBehind) {
  PseudoTerminal pty;
  const auto [status, output] = pty.Run([] {
    Terminal terminal;
    terminal.Show({FrameLine().Add("hello")});
    return terminal.Size() == ScreenSize{.columns = 50, .lines = 10} ? 7 : 1;
  });
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_THAT(output, StartsWith(kAlternateScreen));
  EXPECT_THAT(output, HasSubstr("\033[1;1Hhello\033[K"));
  EXPECT_THAT(output, EndsWith(kFormerScreen));
  EXPECT_TRUE(pty.IsAsBefore());
}

TEST(Terminal, ReadsKeysAsTheyArePressed) {
  PseudoTerminal pty;
  const auto [status, output] = pty.Run([&pty] {
    Terminal terminal;
    pty.Type("s\033[A");
    std::vector<Key> keys;
    while (keys.size() < 2 && terminal.is_open()) {
      std::ranges::copy(terminal.ReadKeys(Seconds(5.0)), std::back_inserter(keys));
    }
    return keys == std::vector<Key>{{Code::kCharacter, 's'}, {Code::kUp}} ? 7 : 1;
  });
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(Terminal, LeavesTheTerminalAsItWasWhenTheProgramIsKilledOrCrashes) {
  for (const int signal : {SIGHUP, SIGQUIT, SIGABRT, SIGSEGV}) {
    PseudoTerminal pty;
    const auto [status, output] = pty.Run([signal] {
      const Terminal terminal;
      return ::raise(signal);
    });
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_THAT(output, EndsWith(kFormerScreen)) << signal;
    EXPECT_TRUE(pty.IsAsBefore()) << signal;
  }
}

}  // namespace
}  // namespace limpet

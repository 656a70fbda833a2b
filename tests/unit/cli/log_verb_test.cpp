// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/command_line.hpp"
#include "apps/limpet/verbs/log.hpp"
#include "tests/support/pseudo_terminal.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

class LogVerbTest : public ::testing::Test {
 protected:
  LogVerbTest() {
    std::ofstream(log_) << "%% LOGSTART                  1767225600 \n"
                           "0.50000         NAV_X                pNav            1.00000      \n"
                           "0.50000         NAV_Y                pNav            2.00000      \n"
                           "a line that a MOOS string was broken into\n"
                           "1.50000         MODE                 pHelm:aux       ACTIVE \n"
                           "2.50000         NAV_X                pSim            3.00000      \n"
                           "3.50000         NAV_X                pNa";
  }
  int Run(std::vector<std::string> words) {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    words.insert(words.begin(), "log");
    const int code = RunCommandLine(words);
    out_ = ::testing::internal::GetCapturedStdout();
    err_ = ::testing::internal::GetCapturedStderr();
    return code;
  }
  [[nodiscard]] static std::string TextOf(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

  TemporaryFolder folder_;
  std::filesystem::path log_ = folder_.path() / "run.alog";
  std::string out_;
  std::string err_;
};

TEST_F(LogVerbTest, ScanListsVariablesAndNamesLinesThatAreNone) {
  EXPECT_EQ(Run({"scan", log_.string()}), kOk);
  EXPECT_THAT(out_, HasSubstr("4 entries of 3 variables"));
  EXPECT_THAT(out_, HasSubstr("pNav, pSim\n"));
  EXPECT_THAT(err_, HasSubstr("run.alog:4: no entry: does not begin with a time\n"));
  EXPECT_THAT(err_, HasSubstr("the last line is torn"));
}

TEST_F(LogVerbTest, ScanTakesTheOneLogOfAFolder) {
  EXPECT_EQ(Run({"scan", folder_.path().string(), "NAV_*", "--json"}), kOk);
  EXPECT_THAT(out_, HasSubstr("\"name\": \"NAV_X\""));
  EXPECT_THAT(out_, Not(HasSubstr("MODE")));
}

TEST_F(LogVerbTest, StatPrintsMeans) {
  EXPECT_EQ(Run({"stat", log_.string(), "NAV_X"}), kOk);
  EXPECT_THAT(out_, HasSubstr("NAV_X           2    1     2    3   1      1     3"));
}

TEST_F(LogVerbTest, GrepPrintsLinesAsTheyAre) {
  EXPECT_EQ(Run({"grep", log_.string(), "M*"}), kOk);
  EXPECT_EQ(out_,
            "%% LOGSTART                  1767225600 \n"
            "1.50000         MODE                 pHelm:aux       ACTIVE \n");
  EXPECT_EQ(Run({"grep", log_.string(), "NAV_*", "--source", "pSim", "--bare"}), kOk);
  EXPECT_EQ(out_, "2.50000         NAV_X                pSim            3.00000      \n");
  EXPECT_EQ(Run({"grep", log_.string(), "--value", "ACT", "--json"}), kOk);
  EXPECT_EQ(out_, R"({"time":1.5,"name":"MODE","source":"pHelm","aux":"aux","value":"ACTIVE"})"
                  "\n");
}

TEST_F(LogVerbTest, GrepFailsWhenNothingMatches) {
  EXPECT_EQ(Run({"grep", log_.string(), "NO_SUCH"}), kFailed);
}

TEST_F(LogVerbTest, GrepTakesVariablesOut) {
  EXPECT_EQ(Run({"grep", log_.string(), "NAV_*", "--invert", "--bare"}), kOk);
  EXPECT_EQ(out_, "1.50000         MODE                 pHelm:aux       ACTIVE \n");
}

TEST_F(LogVerbTest, ClipKeepsTimesWithin) {
  EXPECT_EQ(Run({"clip", log_.string(), "--from", "1", "--to=2.5", "--bare"}), kOk);
  EXPECT_THAT(out_, HasSubstr("1.50000         MODE"));
  EXPECT_THAT(out_, HasSubstr("2.50000         NAV_X"));
  EXPECT_THAT(out_, Not(HasSubstr("0.50000")));
}

TEST_F(LogVerbTest, CsvMakesColumnsOfVariables) {
  EXPECT_EQ(Run({"csv", log_.string(), "NAV_?", "--join", "last"}), kOk);
  EXPECT_EQ(out_, "time,NAV_X,NAV_Y\n0.50000,1.00000,2.00000\n2.50000,3.00000,2.00000\n");
}

TEST_F(LogVerbTest, RecoverWritesASoundLog) {
  const auto sound = folder_.path() / "sound.alog";
  EXPECT_EQ(Run({"recover", log_.string(), "--out", sound.string()}), kOk);
  EXPECT_THAT(TextOf(sound), HasSubstr("pSim            3.00000      \n"));
  EXPECT_THAT(TextOf(sound), Not(HasSubstr("3.50000")));
  EXPECT_THAT(out_, HasSubstr("1 torn last line left out"));
}

TEST_F(LogVerbTest, WritesOverNothingUnlessForced) {
  const auto other = folder_.path() / "other";
  std::ofstream(other) << "precious";
  const std::vector<std::string> words{"grep", log_.string(), "NAV_X", "--out", other.string()};
  EXPECT_EQ(Run(words), kRefused);
  EXPECT_EQ(TextOf(other), "precious");
  EXPECT_EQ(Run({"grep", log_.string(), "NAV_X", "--out", log_.string(), "--force"}), kRefused);
  std::vector<std::string> forced = words;
  forced.emplace_back("--force");
  EXPECT_EQ(Run(forced), kOk);
  EXPECT_THAT(TextOf(other), HasSubstr("NAV_X"));
}

TEST_F(LogVerbTest, HelpsWithEveryCommand) {
  for (const char* command : {"scan", "stat", "grep", "clip", "csv", "recover"}) {
    EXPECT_EQ(Run({command, "--help"}), kOk);
    EXPECT_THAT(out_, HasSubstr(std::string("usage: limpet log ") + command));
  }
  EXPECT_EQ(Run({"scna"}), kUsage);
  EXPECT_THAT(err_, HasSubstr("did you mean `scan`?"));
}

TEST_F(LogVerbTest, NamesOptionAndValueThatAreNotAllowed) {
  EXPECT_EQ(Run({"scan", log_.string(), "--sort", "nmae"}), kUsage);
  EXPECT_EQ(err_, "limpet: --sort takes name, entries, size, rate, first or last, not `nmae`\n");
  EXPECT_EQ(Run({"clip", log_.string(), "--from=noon"}), kUsage);
  EXPECT_EQ(err_, "limpet: --from takes seconds since the start of the log, not `noon`\n");
  EXPECT_EQ(Run({"clip", log_.string()}), kUsage);
  EXPECT_EQ(err_, "limpet: log clip takes one log and --from SECONDS, --to SECONDS or both\n");
  EXPECT_EQ(Run({"recover", log_.string()}), kUsage);
  EXPECT_EQ(err_, "limpet: log recover takes one log and --out FILE\n");
}

TEST_F(LogVerbTest, ComplainsOfALogThatIsNotThere) {
  EXPECT_EQ(Run({"scan", (folder_.path() / "none.alog").string()}), kFailed);
}

/// A log by somebody who knows what terminals obey: a window's title, colours, a C1 sequence.
class HostileLogTest : public LogVerbTest {
 protected:
  HostileLogTest() {
    ::setenv("NO_COLOR", "1", 1);  // NOLINT(concurrency-mt-unsafe): no thread yet
    std::ofstream(log_, std::ios::app)
        << "\n4.50000         EVIL\033[31m           pEvil\033[5m         " << kEvil << " \n"
        << "5.50000         NUMBER\033[8m         pEvil           7.00000      \n";
  }
  ~HostileLogTest() override { ::unsetenv("NO_COLOR"); }  // NOLINT(concurrency-mt-unsafe)
  HostileLogTest(const HostileLogTest&) = delete;
  HostileLogTest& operator=(const HostileLogTest&) = delete;

  static constexpr const char* kEvil =
      "\033]0;owned\007\033[2J\x7f\xc2\x9b"
      "31m\x9b"
      "1mtext";
  const std::vector<std::vector<std::string>> commands_{{"grep", log_.string()},
                                                        {"grep", log_.string(), "EVIL*", "--json"},
                                                        {"clip", log_.string(), "--from", "0"},
                                                        {"csv", log_.string(), "EVIL*"},
                                                        {"scan", log_.string()},
                                                        {"scan", log_.string(), "--json"},
                                                        {"stat", log_.string()}};
};

bool IsObeyed(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n' && c != '\r') || (byte >= 0x7F && byte < 0xA0);
}

TEST_F(HostileLogTest, ShowsATerminalNothingThatItObeys) {
  for (const auto& words : commands_) {
    PseudoTerminal terminal;
    const auto [status, output] = terminal.Run([&words] {
      const int code = RunLog(words);
      std::fflush(stdout);
      return code;
    });
    EXPECT_EQ(status, 0) << words[0];
    EXPECT_THAT(output, AnyOf(HasSubstr("EVIL"), HasSubstr("NUMBER"))) << words[0];
    EXPECT_TRUE(std::ranges::none_of(output, IsObeyed)) << words[0] << ": " << output;
  }
}

TEST_F(HostileLogTest, GivesAFileOrAPipeTheBytesAsTheyAre) {
  EXPECT_EQ(Run({"grep", log_.string(), "EVIL*", "--bare"}), kOk);
  EXPECT_THAT(out_, HasSubstr(kEvil));
  EXPECT_EQ(Run({"csv", log_.string(), "EVIL*"}), kOk);
  EXPECT_THAT(out_, HasSubstr(kEvil));
}

TEST_F(HostileLogTest, TellsOfAFileByANameThatIsHarmless) {
  const auto file = folder_.path() / "a\033[2Jb.alog";
  std::filesystem::copy_file(log_, file);
  EXPECT_EQ(Run({"scan", file.string()}), kOk);
  EXPECT_TRUE(std::ranges::none_of(out_ + err_, IsObeyed));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

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
    const auto end_capture = [this] {
      out_ = ::testing::internal::GetCapturedStdout();
      err_ = ::testing::internal::GetCapturedStderr();
    };
    try {
      const int code = RunLog(words);
      end_capture();
      return code;
    } catch (...) {
      end_capture();
      throw;
    }
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
  EXPECT_THROW(Run({"scna"}), UsageError);
}

TEST_F(LogVerbTest, ComplainsOfALogThatIsNotThere) {
  EXPECT_THROW(Run({"scan", (folder_.path() / "none.alog").string()}), std::runtime_error);
}

}  // namespace
}  // namespace limpet

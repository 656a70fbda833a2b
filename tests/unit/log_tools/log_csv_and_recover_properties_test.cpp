// SPDX-License-Identifier: MIT
// Tables hold what the log says; what is torn or damaged is found, named and left out, no more.
#include <map>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include "limpet/logbook/alog_reader.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/log_tools/made_log.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// RFC 4180, one line at a time: no value of the logs here holds an end of line.
std::vector<std::string> CellsOf(const std::string& line) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[i++];
    } else if (line[i] == '"') {
      is_quoted = !is_quoted;
    } else if (line[i] == ',' && !is_quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  return cells;
}

std::vector<std::vector<std::string>> TableOf(const std::vector<std::string>& words) {
  const LogRun run = RunLogCommand(kLogCsv, words);
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : LinesOf(run.out))
    rows.push_back(CellsOf(line));
  return rows;
}

class LogTables : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  LogTables() {
    Random random(GetParam(), "tables");
    entries_ = MakeEntries(random, 100, true);
    WriteLog(log_, LogTextOf(entries_));
  }
  TemporaryFolder folder_;
  std::string log_ = (folder_.path() / "run.alog").string();
  std::vector<MadeEntry> entries_;
};

TEST_P(LogTables, HaveARowPerEntryWithItsValueInItsColumn) {
  const auto rows = TableOf({log_, "MODE", "NAV_?"});
  ASSERT_FALSE(rows.empty());
  EXPECT_THAT(rows[0], ElementsAre("time", "MODE", "NAV_X", "NAV_Y"));
  std::size_t r = 1;
  for (const MadeEntry& entry : entries_) {
    const auto column = std::ranges::find(rows[0], entry.name);
    if (column == rows[0].end()) continue;
    ASSERT_LT(r, rows.size());
    std::vector<std::string> expected(4);
    expected[0] = fmt::format("{:.5f}", entry.time);
    expected[static_cast<std::size_t>(column - rows[0].begin())] = entry.value;
    EXPECT_EQ(rows[r++], expected);
  }
  EXPECT_EQ(r, rows.size());
}

TEST_P(LogTables, JoinedHaveTheLastValueOfEveryColumnAtEachInstant) {
  const auto rows = TableOf({log_, "NAV_X", "MODE", "--join", "last"});
  std::map<double, std::array<std::string, 2>> by_time;
  std::array<std::string, 2> last;
  for (const MadeEntry& entry : entries_) {
    if (entry.name == "NAV_X" || entry.name == "MODE") {
      last[entry.name == "NAV_X" ? 0 : 1] = entry.value;
      by_time[entry.time] = last;
    }
  }
  ASSERT_EQ(rows.size(), by_time.size() + 1);
  std::size_t r = 1;
  for (const auto& [time, values] : by_time) {
    EXPECT_THAT(rows[r++], ElementsAre(fmt::format("{:.5f}", time), values[0], values[1]));
  }
}

INSTANTIATE_TEST_SUITE_P(RandomLogs, LogTables,
                         ::testing::Range(std::uint64_t{1}, std::uint64_t{9}));

class OddLog : public ::testing::Test {
 protected:
  [[nodiscard]] nlohmann::json Recover(const std::string& from, const std::string& to) const {
    const LogRun run = RunLogCommand(kLogRecover, {from, "--out", to, "--force", "--json"});
    EXPECT_EQ(run.code, kOk) << run.err;
    return nlohmann::json::parse(run.out);
  }
  [[nodiscard]] std::string Path(const char* name) const {
    return (folder_.path() / name).string();
  }

  TemporaryFolder folder_;
};

TEST_F(OddLog, GivesEveryWholeLineWhereverItIsTorn) {
  Random random(4, "torn");
  const std::string text = LogTextOf(MakeEntries(random, 12, true));
  for (std::size_t cut = text.find('\n') + 1; cut <= text.size(); cut += 3) {
    WriteLog(Path("run.alog"), text.substr(0, cut));
    const auto whole = std::ranges::count(text.substr(0, cut), '\n') - 1;
    const LogRun run = RunLogCommand(kLogScan, {Path("run.alog"), "--json"});
    const auto said = nlohmann::json::parse(run.out);
    EXPECT_EQ(said.at("entries"), whole) << cut;
    EXPECT_EQ(said.at("torn_end"), text[cut - 1] != '\n') << cut;
  }
}

TEST_F(OddLog, IsRecoveredToWhatNeedsNoMoreRecovering) {
  Random random(6, "damage");
  for (int run = 0; run < 6; ++run) {  // each is written to the disk and waited for
    std::string text = LogTextOf(MakeEntries(random, 30, true));
    for (int i = 0; i < 8; ++i) {
      text[random.Index(text.size())] = static_cast<char>(random.Index(256));
    }
    text.resize(text.size() - random.Index(20));
    const std::string torn = WriteLog(Path("torn.alog"), text).string();
    const auto first = Recover(torn, Path("once.alog"));
    const auto second = Recover(Path("once.alog"), Path("twice.alog"));
    EXPECT_EQ(BytesOf(torn), text) << "the log itself stays as it is";
    EXPECT_EQ(BytesOf(Path("once.alog")), BytesOf(Path("twice.alog")));
    EXPECT_EQ(second.at("entries"), first.at("entries"));
    EXPECT_EQ(second.at("damaged_lines"), 0);
    EXPECT_EQ(second.at("torn_end"), false);
  }
}

TEST_F(OddLog, LosesNothingThatWasSound) {
  Random random(9, "sound");
  const std::string text = LogTextOf(MakeEntries(random, 40, true));
  WriteLog(Path("run.alog"), text);
  const auto said = Recover(Path("run.alog"), Path("sound.alog"));
  EXPECT_EQ(BytesOf(Path("sound.alog")), text);
  EXPECT_EQ(said.at("entries"), 40);
  EXPECT_EQ(said.at("has_logstart"), true);
}

TEST_F(OddLog, SaysThatItsBannerIsLost) {
  WriteLog(Path("run.alog"), "1.0 A p 1 \n");
  const LogRun run = RunLogCommand(kLogRecover, {Path("run.alog"), "--out", Path("sound.alog")});
  EXPECT_THAT(run.out, HasSubstr("the banner is lost"));
  EXPECT_THAT(run.out, HasSubstr("sound.alog: 1 entries\n"));
}

TEST_F(OddLog, SaysWhichBinaryValuesHaveLostTheirBytes) {
  const auto marker = [](int offset, int bytes) {
    return fmt::format("<MOOS_BINARY>File=run.blog,Offset={},Bytes={}</MOOS_BINARY>", offset,
                       bytes);
  };
  WriteLog(Path("run.blog"), "01234567");
  WriteLog(Path("run.alog"), std::string(kMadeBanner) + "1.0 F p " + marker(0, 8) + " \n2.0 F p " +
                                 marker(4, 5) + " \n3.0 F p " + marker(9, 1) + " \n");
  const LogRun run = RunLogCommand(kLogRecover, {Path("run.alog"), "--out", Path("sound.alog")});
  EXPECT_THAT(run.out, HasSubstr("2 binary values left out"));
  EXPECT_THAT(BytesOf(Path("sound.alog")), Not(HasSubstr("2.0 F")));
}

TEST_F(OddLog, NamesTheFirstLinesThatAreNoEntriesAndCountsTheRest) {
  std::string text = kMadeBanner;
  for (int i = 0; i < 40; ++i)
    text += "what is this\n1.0 A p 1 \n";
  WriteLog(Path("run.alog"), text);
  const LogRun run = RunLogCommand(kLogScan, {Path("run.alog")});
  EXPECT_THAT(run.err, HasSubstr("run.alog:2: no entry: does not begin with a time\n"));
  EXPECT_THAT(run.err, HasSubstr(" further lines are no entries\n"));
  const auto named = LinesOf(run.err).size() - 1;
  EXPECT_THAT(run.err, HasSubstr(fmt::format(": {} further lines", 40 - named)));
}

TEST_F(OddLog, OfWindowsReadsAsAnyOther) {
  Random random(2, "crlf");
  const auto entries = MakeEntries(random, 20, true);
  std::string text;
  for (const std::string& line : LinesOf(LogTextOf(entries)))
    text += line + "\r\n";
  WriteLog(Path("run.alog"), text);
  const auto rows = TableOf({Path("run.alog"), "MODE"});
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), 2U);
    EXPECT_THAT(row[1], Not(HasSubstr("\r")));
  }
  EXPECT_EQ(rows.size(),
            1U + static_cast<std::size_t>(std::ranges::count(entries, "MODE", &MadeEntry::name)));
}

TEST_F(OddLog, CompressedGivesTheTableOfThePlainOne) {
  Random random(3, "gzip");
  const std::string text = LogTextOf(MakeEntries(random, 200, true));
  WriteLog(Path("run.alog"), text);
  const std::string packed = Path("packed.alog.gz");
  gzFile file = gzopen(packed.c_str(), "wb");
  ASSERT_NE(file, nullptr);
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  EXPECT_EQ(TableOf({packed, "NAV_*", "MODE"}), TableOf({Path("run.alog"), "NAV_*", "MODE"}));
}

TEST_F(OddLog, WithoutTheVariableAskedForFailsWithAnEmptyTable) {
  WriteLog(Path("run.alog"), "1.0 A p 1 \n");
  const LogRun run = RunLogCommand(kLogCsv, {Path("run.alog"), "B"});
  EXPECT_EQ(run.code, kFailed);
  EXPECT_EQ(run.out, "time,B\n");
  EXPECT_THAT(run.err, HasSubstr("no entry of these variables"));
}

TEST(LogCsv, DoesNotReadThePipeTwice) {
  const LogRun run = RunLogCommand(kLogCsv, {"-", "NAV_*"});
  EXPECT_EQ(run.code, kUsage);
  EXPECT_THAT(run.err, HasSubstr("cannot read the standard input twice"));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
// `grep` and `clip` take lines of a log apart without losing or changing one.
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limpet/log_tools/entry_filter.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/log_tools/made_log.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// By trying every length that a star may stand for.
bool IsMatch(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return text.empty();
  if (pattern[0] == '*') {
    for (std::size_t taken = 0; taken <= text.size(); ++taken) {
      if (IsMatch(pattern.substr(1), text.substr(taken))) return true;
    }
    return false;
  }
  return !text.empty() && (pattern[0] == '?' || pattern[0] == text[0]) &&
         IsMatch(pattern.substr(1), text.substr(1));
}

std::string RandomWord(Random& random, std::string_view letters, std::size_t longest) {
  std::string word;
  for (std::size_t length = random.Index(longest + 1); length > 0; --length) {
    word += letters[random.Index(letters.size())];
  }
  return word;
}

TEST(LogPatterns, MatchAsTheyReadWhateverTheNames) {
  Random random(1, "patterns");
  int matches = 0;
  for (int run = 0; run < 4000; ++run) {
    const std::string pattern = RandomWord(random, "AB_*?", 6);
    const std::string name = RandomWord(random, "AB_", 7);
    EntryFilter filter(std::vector<std::string>{pattern});
    AlogEntry entry;
    entry.name = name;
    const bool is_match = IsMatch(pattern, name);
    matches += is_match ? 1 : 0;
    EXPECT_EQ(filter.Accepts(entry), is_match) << "`" << pattern << "` `" << name << "`";
    EXPECT_EQ(filter.Accepts(entry), is_match) << "asked again";
  }
  EXPECT_GT(matches, 300);
}

class LogFilterProperties : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  LogFilterProperties() : random_(GetParam(), "log_filter") {
    entries_ = MakeEntries(random_, 50 + random_.Index(200), random_.Chance(0.5));
    WriteLog(log_, LogTextOf(entries_));
  }
  [[nodiscard]] std::vector<std::string> Grep(std::vector<std::string> words) const {
    words.insert(words.begin(), log_);
    words.emplace_back("--bare");
    return LinesOf(RunLogCommand(kLogGrep, words).out);
  }

  TemporaryFolder folder_;
  std::string log_ = (folder_.path() / "run.alog").string();
  Random random_;
  std::vector<MadeEntry> entries_;
};

TEST_P(LogFilterProperties, AGrepAndItsInverseShareTheLogBetweenThem) {
  for (const std::string pattern : {"NAV_?", "*", "MODE", "*E*", "NONE"}) {
    const std::vector<std::string> kept = Grep({pattern}), others = Grep({pattern, "--invert"});
    std::size_t k = 0, o = 0;
    for (const MadeEntry& entry : entries_) {
      if (IsMatch(pattern, entry.name)) {
        ASSERT_LT(k, kept.size());
        EXPECT_EQ(kept[k++], entry.Line());
      } else {
        ASSERT_LT(o, others.size());
        EXPECT_EQ(others[o++], entry.Line());
      }
    }
    EXPECT_EQ(k, kept.size()) << pattern;
    EXPECT_EQ(o, others.size()) << pattern;
  }
}

TEST_P(LogFilterProperties, ClipsThatMeetGiveTheWholeLog) {
  // A cut between hundredths is at no entry's time.
  const double cut = entries_[random_.Index(entries_.size())].time + 0.005;
  const auto clip = [this](const char* end, double time) {
    return LinesOf(RunLogCommand(kLogClip, {log_, end, fmt::format("{:.3f}", time), "--bare"}).out);
  };
  const std::vector<std::string> before = clip("--to", cut), after = clip("--from", cut);
  EXPECT_EQ(before.size() + after.size(), entries_.size());
  std::multiset<std::string> all(before.begin(), before.end());
  all.insert(after.begin(), after.end());
  for (const MadeEntry& entry : entries_) {
    EXPECT_TRUE(all.contains(entry.Line()));
    const auto& side = entry.time < cut ? before : after;
    EXPECT_NE(std::ranges::find(side, entry.Line()), side.end()) << entry.Line();
  }
}

TEST_P(LogFilterProperties, AClipKeepsBothOfItsEnds) {
  const double at = entries_[random_.Index(entries_.size())].time;
  const std::string text = fmt::format("{:.2f}", at);
  const auto lines =
      LinesOf(RunLogCommand(kLogClip, {log_, "--from", text, "--to", text, "--bare"}).out);
  const auto expected = std::ranges::count(entries_, at, &MadeEntry::time);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(lines.size()), expected);
}

TEST_P(LogFilterProperties, AGrepIsALogAgainThatSaysTheSame) {
  const std::string file = (folder_.path() / "small.alog").string();
  const LogRun run = RunLogCommand(kLogGrep, {log_, "NAV_*", "--out", file});
  ASSERT_EQ(run.code, kOk) << run.err;
  const auto of = [](const std::string& log) {
    const LogRun scan = RunLogCommand(kLogScan, {log, "NAV_*", "--json"});
    EXPECT_THAT(scan.err, IsEmpty());
    return nlohmann::json::parse(scan.out);
  };
  const nlohmann::json whole = of(log_), small = of(file);
  EXPECT_EQ(whole.at("variables"), small.at("variables"));
  EXPECT_EQ(whole.at("logstart"), small.at("logstart")) << "times count from the same instant";
  EXPECT_THAT(run.out, HasSubstr(fmt::format("{} of {} entries", small.at("entries").get<int>(),
                                             entries_.size())));
}

TEST_P(LogFilterProperties, JsonHasAnObjectPerEntryWithNumbersAsNumbers) {
  const auto lines = LinesOf(RunLogCommand(kLogGrep, {log_, "--json"}).out);
  ASSERT_EQ(lines.size(), entries_.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const nlohmann::json object = nlohmann::json::parse(lines[i]);
    EXPECT_EQ(object.at("time"), entries_[i].time);
    EXPECT_EQ(object.at("name"), entries_[i].name);
    EXPECT_EQ(object.at("source"), entries_[i].source);
    if (entries_[i].is_number) {
      EXPECT_EQ(object.at("value"), entries_[i].number);
    } else {
      EXPECT_EQ(object.at("value"), entries_[i].value);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RandomLogs, LogFilterProperties,
                         ::testing::Range(std::uint64_t{1}, std::uint64_t{7}));

class LogFilterTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string log_ =
      WriteLog(folder_.path() / "run.alog",
               std::string(kMadeBanner) + "1.0 A pX 1 \n2.0 B pY:aux two \n3.0 A pY 3 \n")
          .string();
};

TEST_F(LogFilterTest, SaysThatNothingMatchedAndFails) {
  const LogRun run = RunLogCommand(kLogGrep, {log_, "C"});
  EXPECT_EQ(run.code, kFailed);
  EXPECT_EQ(run.err, "no entry of 3 matches\n");
}

TEST_F(LogFilterTest, TakesSeveralSources) {
  const auto count = [this](std::vector<std::string> words) {
    words.insert(words.begin(), log_);
    words.emplace_back("--bare");
    return LinesOf(RunLogCommand(kLogGrep, words).out).size();
  };
  EXPECT_EQ(count({"--source", "pX"}), 1U);
  EXPECT_EQ(count({"--source", "pY"}), 2U) << "what stands behind the colon is no part of it";
  EXPECT_EQ(count({"--source", "pX", "--source", "pY"}), 3U);
  EXPECT_EQ(count({"--source", "p?", "A"}), 2U);
}

TEST_F(LogFilterTest, RefusesTimesThatLieTheWrongWayRound) {
  const LogRun run = RunLogCommand(kLogClip, {log_, "--from", "3", "--to", "2"});
  EXPECT_EQ(run.code, kUsage);
  EXPECT_EQ(run.err, "--from lies behind --to");
}

TEST_F(LogFilterTest, NamesTheLogsOfAFolderThatHoldsSeveral) {
  WriteLog(folder_.path() / "second.alog", "");
  const LogRun run = RunLogCommand(kLogGrep, {folder_.path().string()});
  EXPECT_EQ(run.code, kFailed);
  EXPECT_THAT(run.err, HasSubstr("holds several logs; which one?"));
  EXPECT_THAT(run.err, HasSubstr("run.alog"));
  EXPECT_THAT(run.err, HasSubstr("second.alog"));
}

TEST_F(LogFilterTest, SaysThatAFolderHoldsNoLog) {
  const auto empty = folder_.path() / "empty";
  std::filesystem::create_directories(empty);
  WriteLog(empty / "notes.txt", "1.0 A p 1 \n");
  const LogRun run = RunLogCommand(kLogGrep, {empty.string()});
  EXPECT_EQ(run.code, kFailed);
  EXPECT_THAT(run.err, HasSubstr("empty: holds no .alog file"));
}

TEST_F(LogFilterTest, LeavesNothingBehindWhereItFailed) {
  const std::string out = (folder_.path() / "clip.alog").string();
  EXPECT_EQ(RunLogCommand(kLogClip,
                          {(folder_.path() / "none.alog").string(), "--from", "0", "--out", out})
                .code,
            kFailed);
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(LogFilterTest, SaysThatBinaryValuesStayBehind) {
  const auto elsewhere = folder_.path() / "elsewhere";
  std::filesystem::create_directories(elsewhere);
  WriteLog(log_, std::string(kMadeBanner) +
                     "1.0 F p <MOOS_BINARY>File=run.blog,Offset=0,Bytes=2</MOOS_BINARY> \n");
  const auto out_in = [this](const std::filesystem::path& folder) {
    return RunLogCommand(kLogGrep, {log_, "--out", (folder / "few.alog").string()}).out;
  };
  EXPECT_THAT(out_in(elsewhere), HasSubstr("keep that beside it"));
  EXPECT_THAT(out_in(folder_.path()), ::testing::Not(HasSubstr("keep that beside it")));
}

}  // namespace
}  // namespace limpet

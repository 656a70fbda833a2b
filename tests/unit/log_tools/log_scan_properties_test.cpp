// SPDX-License-Identifier: MIT
// What `scan` and `stat` say of random logs is what a plain count of their entries says.
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/temporary_folder.hpp"
#include "tests/unit/log_tools/made_log.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

using ByVariable = std::map<std::string, std::vector<MadeEntry>>;

ByVariable Grouped(const std::vector<MadeEntry>& entries) {
  ByVariable grouped;
  for (const MadeEntry& entry : entries)
    grouped[entry.name].push_back(entry);
  return grouped;
}

nlohmann::json ScanOf(const std::string& log, std::vector<std::string> words = {}) {
  words.insert(words.begin(), log);
  words.emplace_back("--json");
  const LogRun run = RunLogCommand(kLogScan, words);
  EXPECT_EQ(run.code, kOk) << run.err;
  return nlohmann::json::parse(run.out);
}

void ExpectNumbers(const nlohmann::json& numbers, const std::vector<double>& values) {
  if (values.empty()) {
    EXPECT_TRUE(numbers.is_null()) << "text alone has no mean";
    return;
  }
  double sum = 0.0, squares = 0.0;
  for (const double value : values)
    sum += value;
  const double mean = sum / static_cast<double>(values.size());
  for (const double value : values)
    squares += (value - mean) * (value - mean);
  EXPECT_EQ(numbers.at("count"), values.size());
  EXPECT_EQ(numbers.at("min"), *std::ranges::min_element(values));
  EXPECT_EQ(numbers.at("max"), *std::ranges::max_element(values));
  EXPECT_NEAR(numbers.at("mean"), mean, 1e-9);
  EXPECT_NEAR(numbers.at("sd"), std::sqrt(squares / static_cast<double>(values.size())), 1e-9);
  EXPECT_EQ(numbers.at("first"), values.front());
  EXPECT_EQ(numbers.at("last"), values.back());
}

void ExpectVariable(const nlohmann::json& said, const std::vector<MadeEntry>& entries) {
  std::set<std::string> sources;
  std::vector<double> numbers, times;
  std::size_t bytes = 0;
  for (const MadeEntry& entry : entries) {
    sources.insert(entry.source);
    times.push_back(entry.time);
    bytes += entry.Line().size() + 1;
    if (entry.is_number) numbers.push_back(entry.number);
  }
  EXPECT_EQ(said.at("entries"), entries.size());
  EXPECT_EQ(said.at("bytes"), bytes);
  EXPECT_EQ(said.at("sources").get<std::set<std::string>>(), sources);
  const double first = *std::ranges::min_element(times), last = *std::ranges::max_element(times);
  EXPECT_EQ(said.at("first_s"), first);
  EXPECT_EQ(said.at("last_s"), last);
  const double rate = last > first ? static_cast<double>(times.size() - 1) / (last - first) : 0.0;
  EXPECT_NEAR(said.at("rate_hz"), rate, 1e-9);
  ExpectNumbers(said.at("numbers"), numbers);
}

TEST(LogScan, CountsWhatAPlainCountOfTheEntriesFinds) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed, "scan");
    const auto entries = MakeEntries(random, 1 + random.Index(300), random.Chance(0.5));
    const std::string text = LogTextOf(entries);
    const nlohmann::json said = ScanOf(WriteLog(folder.path() / "run.alog", text).string());
    EXPECT_EQ(said.at("entries"), entries.size());
    EXPECT_EQ(said.at("bytes"), text.size());
    EXPECT_EQ(said.at("logstart"), 1767225600.0);
    EXPECT_EQ(said.at("skipped_lines"), 0);
    const ByVariable grouped = Grouped(entries);
    ASSERT_EQ(said.at("variables").size(), grouped.size());
    auto variable = said.at("variables").begin();
    for (const auto& [name, its_entries] : grouped) {  // both are sorted by name
      ASSERT_EQ(variable->at("name"), name);
      ExpectVariable(*variable++, its_entries);
    }
  }
}

TEST(LogScan, FindsTheLongestTimeWithoutAnEntry) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    Random random(seed, "gaps");
    const auto entries = MakeEntries(random, 120, true);
    const auto said = ScanOf(WriteLog(folder.path() / "run.alog", LogTextOf(entries)).string());
    const ByVariable grouped = Grouped(entries);
    for (const nlohmann::json& variable : said.at("variables")) {
      const std::vector<MadeEntry>& its = grouped.at(variable.at("name"));
      double longest = 0.0;
      for (std::size_t i = 1; i < its.size(); ++i) {
        longest = std::max(longest, its[i].time - its[i - 1].time);
      }
      EXPECT_EQ(variable.at("longest_gap_s"), longest) << variable.at("name") << seed;
    }
  }
}

TEST(LogScan, CountsEntriesThatCameTooLate) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    Random random(seed, "late");
    const auto entries = MakeEntries(random, 200, false);
    std::size_t late = 0;
    double latest = entries.front().time;
    for (const MadeEntry& entry : entries) {
      late += entry.time < latest ? 1 : 0;
      latest = std::max(latest, entry.time);
    }
    const auto log = WriteLog(folder.path() / "run.alog", LogTextOf(entries)).string();
    EXPECT_EQ(ScanOf(log).at("out_of_order"), late);
    const std::string shown = RunLogCommand(kLogScan, {log}).out;
    EXPECT_EQ(shown.find("not in order") != std::string::npos, late > 0) << shown;
  }
}

TEST(LogScan, KnowsOnlyWhatItsFilterLetsThrough) {
  const TemporaryFolder folder;
  Random random(5, "filter");
  const auto entries = MakeEntries(random, 400, true);
  const auto log = WriteLog(folder.path() / "run.alog", LogTextOf(entries)).string();
  const double from = entries[100].time, to = entries[300].time;
  std::size_t expected = 0;
  for (const MadeEntry& entry : entries) {
    expected += entry.name.starts_with("NAV_") && entry.source == "pSim" && entry.time >= from &&
                        entry.time <= to && entry.value.find('1') != std::string::npos
                    ? 1
                    : 0;
  }
  const auto said = ScanOf(log, {"NAV_*", "--source", "pSim", "--from", fmt::format("{}", from),
                                 "--to", fmt::format("{}", to), "--value", "1"});
  ASSERT_GT(expected, 5U);
  EXPECT_EQ(said.at("entries"), expected);
}

struct SortedBy {
  const char* key;
  const char* field;
  bool is_falling;
};

TEST(LogScan, SortsByTheKeyAskedFor) {
  const TemporaryFolder folder;
  Random random(8, "sort");
  const auto log =
      WriteLog(folder.path() / "run.alog", LogTextOf(MakeEntries(random, 150, true))).string();
  for (const SortedBy by : {SortedBy{"entries", "entries", true},
                            {"size", "bytes", true},
                            {"rate", "rate_hz", true},
                            {"first", "first_s", false},
                            {"last", "last_s", false}}) {
    const auto said = ScanOf(log, {"--sort", by.key});
    std::vector<double> values;
    for (const auto& variable : said.at("variables"))
      values.push_back(variable.at(by.field));
    if (by.is_falling) std::ranges::reverse(values);
    EXPECT_TRUE(std::ranges::is_sorted(values)) << by.key;
    EXPECT_EQ(values.size(), 5U);
  }
}

TEST(LogScan, ShowsEveryVariableOnceWithItsShareOfTheFile) {
  const TemporaryFolder folder;
  Random random(11, "share");
  const auto entries = MakeEntries(random, 200, true);
  const auto log = WriteLog(folder.path() / "run.alog", LogTextOf(entries)).string();
  const std::vector<std::string> lines = LinesOf(RunLogCommand(kLogScan, {log}).out);
  for (const auto& [name, its] : Grouped(entries)) {
    EXPECT_EQ(std::ranges::count_if(
                  lines,
                  [&name = name](const std::string& line) { return line.starts_with(name + " "); }),
              1)
        << name;
  }
  EXPECT_THAT(lines.at(0), HasSubstr("200 entries of 5 variables"));
}

TEST(LogScan, NamesNoMoreThanThreeWritersInATable) {
  const TemporaryFolder folder;
  std::string text = kMadeBanner;
  for (const char* source : {"pA", "pB", "pC", "pD", "pE"}) {
    text += MadeEntry{.time = 1.0, .name = "NEWS", .source = source, .value = "x"}.Line() + "\n";
  }
  const auto log = WriteLog(folder.path() / "run.alog", text).string();
  EXPECT_THAT(RunLogCommand(kLogScan, {log}).out, HasSubstr("pA, pB, pC +2\n"));
}

TEST(LogStat, SaysHowManyVariablesHoldNoNumber) {
  const TemporaryFolder folder;
  const auto log =
      WriteLog(folder.path() / "run.alog", std::string(kMadeBanner) +
                                               "1.0 MODE p ACTIVE \n2.0 WHY p because \n"
                                               "3.0 NAV_X p 4 \n")
          .string();
  const std::string out = RunLogCommand(kLogStat, {log}).out;
  EXPECT_THAT(out, HasSubstr("\n2 variables hold no number\n"));
  EXPECT_THAT(RunLogCommand(kLogStat, {log, "MODE"}).out, HasSubstr("1 variables hold no number"));
}

TEST(LogStat, OfAnEmptyLogSaysNothingButThat) {
  const TemporaryFolder folder;
  for (const char* text : {"", "%% LOGSTART 5 \n", "\n\n\n"}) {
    const auto log = WriteLog(folder.path() / "run.alog", text).string();
    const LogRun run = RunLogCommand(kLogStat, {log});
    EXPECT_EQ(run.code, kOk);
    EXPECT_THAT(run.out, HasSubstr("0 entries of 0 variables"));
    const auto said = ScanOf(log);
    EXPECT_EQ(said.at("entries"), 0);
    EXPECT_THAT(said.at("variables"), IsEmpty());
  }
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
// What a kill or a power cut leaves of a log.
#include "limpet/logbook/alog_recovery.hpp"

#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "limpet/core/random.hpp"
#include "limpet/logbook/alog_format.hpp"
#include "limpet/logbook/log_thread.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

constexpr Seconds kRecoveryStart{1767225600.0};

MessagePtr RecordOf(const std::string& name, Value value, double time) {
  return std::make_shared<const Message>(Message{.name = name,
                                                 .value = std::move(value),
                                                 .time = kRecoveryStart + Seconds(time),
                                                 .source = "pNav",
                                                 .source_aux = "",
                                                 .community = ""});
}

/// A log of numbers and strings with what strings may hold.
std::string SampleLog() {
  const AlogFormat format(kRecoveryStart, {});
  std::string text;
  format.AppendBanner(text, "run.alog");
  for (int i = 0; i < 400; ++i) {
    const double time = 0.1 * i;
    format.AppendLine(text, *RecordOf("NAV_X", 0.25 * i, time));
    format.AppendLine(text, *RecordOf("MODE", std::string("a\nb \\ 12 %% x"), time));
  }
  return text;
}

std::vector<double> TimesIn(std::string_view text) {
  AlogReader reader = AlogReader::OfText(text);
  std::vector<double> times;
  for (AlogEntry entry; reader.Next(entry);) {
    times.push_back(entry.time);
  }
  return times;
}

/// Complete lines of `text` that are entries, counted without the reader.
std::size_t CompleteEntries(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string_view::npos;
       begin = end + 1) {
    count += text[begin] == '%' ? 0 : 1;
  }
  return count;
}

TEST(TornLog, KeepsEveryCompleteLineWhereverItIsCut) {
  const std::string whole = SampleLog();
  std::vector<std::size_t> cuts;
  for (std::size_t cut = whole.size() - 2048; cut <= whole.size(); ++cut) {
    cuts.push_back(cut);
  }
  for (std::size_t cut = 0; cut < 800; ++cut) {
    cuts.push_back(cut);  // the banner
  }
  Random random(7, "cuts");
  for (int i = 0; i < 200; ++i) {
    cuts.push_back(
        static_cast<std::size_t>(random.Uniform(0.0, static_cast<double>(whole.size()))));
  }
  for (const std::size_t cut : cuts) {
    const std::string_view torn = std::string_view(whole).substr(0, cut);
    ASSERT_EQ(TimesIn(torn).size(), CompleteEntries(torn)) << "cut at byte " << cut;
  }
}

TEST(TornLog, IsReadPastABlockOfZeros) {
  std::string text = SampleLog();
  const std::size_t before = CompleteEntries(text);
  const std::size_t entries_hit = CompleteEntries(text.substr(8192, 4096)) + 1;
  text.replace(8192, 4096, std::string(4096, '\0'));
  text += std::string(4096, '\0');  // as preallocated blocks look after a power cut
  AlogReader reader = AlogReader::OfText(text);
  std::size_t count = 0;
  for (AlogEntry entry; reader.Next(entry);) {
    EXPECT_TRUE(entry.name == "NAV_X" || entry.name == "MODE");
    ++count;
  }
  EXPECT_EQ(count, before - entries_hit);
  EXPECT_EQ(reader.skipped_lines(), 1U);
  EXPECT_TRUE(reader.has_torn_end());
}

TEST(TornLog, IsReadWhateverBytesItHolds) {
  Random random(3, "bytes");
  for (int run = 0; run < 200; ++run) {
    std::string text = SampleLog().substr(0, 3000);
    for (int i = 0; i < 40; ++i) {
      const auto at = static_cast<std::size_t>(random.Uniform(0.0, 2999.0));
      text[at] = static_cast<char>(static_cast<int>(random.Uniform(0.0, 255.9)));
    }
    EXPECT_LE(TimesIn(text).size(), CompleteEntries(text));
  }
}

TEST(AlogRecovery, KeepsWhatIsSoundAndCountsTheRest) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "run.blog") << "0123456789";
  const std::string blob = "<MOOS_BINARY>File=run.blog,Offset=";
  const std::string text =
      "%% LOGSTART 100 \n1.0 A p 1 \nrest of a string\n2.0 B\x01 p 1 \n3.0 C\x02\n" +
      ("4.0 F p " + blob + "0,Bytes=10</MOOS_BINARY>\n") +
      ("5.0 F p " + blob + "5,Bytes=6</MOOS_BINARY>\n6.0 A p");
  AlogReader reader = AlogReader::OfText(text);
  AlogRecovery recovery(folder.path());
  AlogLine line;
  std::vector<std::size_t> kept;
  for (AlogEntry entry; reader.NextLine(line, entry);) {
    if (recovery.Keeps(line, entry)) {
      kept.push_back(line.number);
    }
  }
  EXPECT_THAT(kept, ::testing::ElementsAre(1, 2, 3, 4, 6))
      << "bytes in a string are its own affair";
  EXPECT_EQ(recovery.entries(), 3U);
  EXPECT_EQ(recovery.other_lines(), 1U);
  EXPECT_EQ(recovery.damaged_lines(), 1U);
  EXPECT_EQ(recovery.lost_binaries(), 1U);
}

/// Logs through a thread until it is killed; tells through the pipe what it has handed over.
[[noreturn]] void LogForEver(const std::filesystem::path& folder, int report) {
  LogThread thread(*LogFiles::Open(folder, "run", kRecoveryStart, {}));
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0;; ++i) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    thread.Put(LogLine{LogLine::File::kAsync, RecordOf("COUNT", 1.0 * i, elapsed.count())});
    const double time = elapsed.count();
    [[maybe_unused]] const ssize_t written = ::write(report, &time, sizeof time);
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
}

double LastOf(int pipe) {
  double last = 0.0;
  for (double time = 0.0; ::read(pipe, &time, sizeof time) == sizeof time;) {
    last = time;
  }
  return last;
}

TEST(LogThread, LosesLessThanASecondWhenItsProcessIsKilled) {
  for (const int after_ms : {120, 333, 617}) {
    const TemporaryFolder folder;
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe(pipe.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(pipe[0]);
      LogForEver(folder.path(), pipe[1]);
    }
    ::close(pipe[1]);
    std::this_thread::sleep_for(std::chrono::milliseconds(after_ms));
    ::kill(child, SIGKILL);
    const double last = LastOf(pipe[0]);
    ::waitpid(child, nullptr, 0);
    ::close(pipe[0]);
    AlogReader reader = *AlogReader::Open(folder.path() / "run.alog");
    double logged = 0.0;
    double expected = 0.0;
    for (AlogEntry entry; reader.Next(entry); expected += 1.0) {
      ASSERT_EQ(entry.number, expected) << "a hole in the log";
      logged = entry.time;
    }
    EXPECT_LT(last - logged, 1.0);
  }
}

}  // namespace
}  // namespace limpet

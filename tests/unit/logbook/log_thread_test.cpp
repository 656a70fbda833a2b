// SPDX-License-Identifier: MIT
#include "limpet/logbook/log_thread.hpp"

#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/logbook/alog_reader.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/torn_disk.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

constexpr Seconds kThreadStart{1767225600.0};

LogRecord LineOf(double value, std::size_t text_size = 0) {
  return LogLine{LogLine::File::kAsync,
                 std::make_shared<const Message>(Message{
                     .name = "COUNT",
                     .value = text_size == 0 ? Value(value) : Value(std::string(text_size, 'x')),
                     .time = kThreadStart + Seconds(value),
                     .source = "test",
                     .source_aux = "",
                     .community = ""})};
}

class LogThreadTest : public ::testing::Test {
 protected:
  [[nodiscard]] LogFiles Files() const {
    return *LogFiles::Open(folder_.path(), "run", kThreadStart, {});
  }
  [[nodiscard]] std::string Text() const {
    std::ifstream in(folder_.path() / "run.alog");
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  [[nodiscard]] int Entries() const {
    AlogReader reader = *AlogReader::Open(folder_.path() / "run.alog");
    int count = 0;
    for (AlogEntry entry; reader.Next(entry);) {
      ++count;
    }
    return count;
  }
  TemporaryFolder folder_;
};

TEST_F(LogThreadTest, HasEverythingOnTheDiskAtItsEnd) {
  {
    LogThread thread(Files());
    for (int i = 0; i < 10'000; ++i) {
      EXPECT_TRUE(thread.Put(LineOf(i)));
    }
  }
  EXPECT_EQ(Entries(), 10'000);
}

TEST_F(LogThreadTest, KeepsTheOrderOfArrival) {
  {
    LogThread thread(Files());
    for (int i = 0; i < 2000; ++i) {
      thread.Put(LineOf(i));
    }
  }
  AlogReader reader = *AlogReader::Open(folder_.path() / "run.alog");
  double expected = 0.0;
  for (AlogEntry entry; reader.Next(entry); expected += 1.0) {
    ASSERT_EQ(entry.number, expected);
  }
}

TEST_F(LogThreadTest, HandsToTheSystemWithoutBeingAsked) {
  LogThread thread(Files());
  thread.Put(LineOf(1.0));
  for (int i = 0; i < 200 && Entries() == 0; ++i) {
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_EQ(Entries(), 1);
}

TEST_F(LogThreadTest, DropsRatherThanWaitAndSaysSoInTheLog) {
  int refused = 0;
  {
    LogThread thread(Files(), {.queue_bytes = 64U << 10U, .batch = 1ms, .sync = 500ms});
    for (int i = 0; i < 2000; ++i) {
      refused += thread.Put(LineOf(i, 8000)) ? 0 : 1;
    }
    EXPECT_EQ(thread.dropped(), static_cast<std::uint64_t>(refused));
    std::this_thread::sleep_for(50ms);
    thread.Put(LineOf(1.0));
  }
  EXPECT_GT(refused, 0) << "16 MB do not wait in 64 kB";
  EXPECT_EQ(Entries(), 2001 - refused);
  EXPECT_THAT(Text(), HasSubstr("messages are missing here: the disk was too slow\n"));
}

TEST_F(LogThreadTest, HasWhatItCallsSettledAfterAPowerCut) {
  const TemporaryFolder place(PlaceInMemory());
  const auto root = place.path() / "disk", left = place.path() / "left";
  std::filesystem::create_directory(root);
  TornDisk disk(root);
  Random random(1, "cuts");
  LogThread thread(*LogFiles::Open(root, "run", kThreadStart, {.lines = {}, .disk = &disk}),
                   {.queue_bytes = 1U << 20U, .batch = 1ms, .sync = 1ms});
  for (std::uint64_t put = 1; put <= 20; ++put) {
    thread.Put(LineOf(static_cast<double>(put)));
    while (thread.settled() < put) {
      std::this_thread::yield();
    }
    disk.Cut(disk.calls(), random, left);
    AlogReader reader = *AlogReader::Open(left / "run.alog");
    std::uint64_t found = 0;
    for (AlogEntry entry; reader.Next(entry);) {
      ++found;
    }
    EXPECT_EQ(found, put);
  }
}

TEST_F(LogThreadTest, StopsWithoutWaiting) {
  LogThread thread(Files());
  thread.Put(LineOf(1.0));
  thread.Stop();
  EXPECT_FALSE(thread.Put(LineOf(2.0)));
  for (int i = 0; i < 1000 && !thread.is_finished(); ++i) {
    std::this_thread::sleep_for(5ms);
  }
  EXPECT_TRUE(thread.is_finished());
  EXPECT_EQ(Entries(), 1);
}

}  // namespace
}  // namespace limpet

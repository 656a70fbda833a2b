// SPDX-License-Identifier: MIT
#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/durable/append_thread.hpp"
#include "limpet/durable/disk_jobs.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/durable/failing_file_system.hpp"
#include "limpet/durable/journal_format.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string JournalOf(const std::vector<std::string>& records) {
  std::string bytes(kJournalHeader);
  std::uint64_t chain = 0;
  for (const std::string& record : records) {
    AppendJournalRecord(bytes, chain, record);
  }
  return bytes;
}

std::vector<std::string> RecordsIn(const std::string& bytes) {
  std::istringstream in(bytes);
  JournalReader reader(in, bytes.size());
  std::vector<std::string> records;
  for (std::string payload; reader.Next(payload);) {
    records.push_back(payload);
  }
  return records;
}

TEST(JournalFormat, GivesBackTheRecordsInOrder) {
  EXPECT_THAT(RecordsIn(JournalOf({"one", "", "three"})), ElementsAre("one", "", "three"));
  EXPECT_THAT(RecordsIn(JournalOf({})), IsEmpty());
  EXPECT_THAT(RecordsIn(""), IsEmpty());
}

TEST(JournalFormat, EndsBeforeWhateverBitIsFlipped) {
  const std::string good = JournalOf({"one", "two", "three"});
  const std::size_t first_end = JournalOf({"one"}).size(),
                    second_end = JournalOf({"one", "two"}).size();
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ (1 << (i % 8)));
    const std::size_t sound = i < kJournalHeader.size() ? 0
                              : i < first_end           ? 0
                              : i < second_end          ? 1
                                                        : 2;
    EXPECT_EQ(RecordsIn(bad).size(), sound) << i;
  }
}

TEST(JournalFormat, TakesNoZerosForRecords) {
  EXPECT_THAT(RecordsIn(JournalOf({"one"}) + std::string(100, '\0')), ElementsAre("one"));
}

TEST(JournalFormat, TakesNothingOfAnEarlierLifeBehindItsEnd) {
  const std::string former = JournalOf({"same", "torn", "later"});
  std::string next = JournalOf({"same", "TORN"});
  next += former.substr(next.size());
  EXPECT_THAT(RecordsIn(next), ElementsAre("same", "TORN"));
}

TEST(AppendThread, HasEverythingInTheFileAtItsEnd) {
  const TemporaryFolder folder;
  std::string all;
  {
    AppendThread thread(*AppendFile::Create(folder.path() / "x"));
    for (int i = 0; i < 1000; ++i) {
      all += std::to_string(i) + "\n";
      thread.Put(std::to_string(i) + "\n");
    }
  }
  EXPECT_EQ(*ReadWhole(folder.path() / "x"), all);
}

TEST(AppendThread, RemovesAFileThatItCannotGoOnWith) {
  const TemporaryFolder folder;
  FailingFileSystem disk(RealFileSystem());
  AppendFile file = *AppendFile::Create(folder.path() / "x", disk);
  ASSERT_TRUE(file.Append("half of it"));
  disk.Set(FailingFileSystem::Fault::kFull);
  {
    AppendThread thread(std::move(file));
    thread.Put("the rest");
    while (!thread.trouble()) {
    }
    EXPECT_EQ(thread.trouble(), std::errc::no_space_on_device);
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "x"));
}

TEST(AppendThread, GivesUpRatherThanQueueWithoutEnd) {
  const TemporaryFolder folder;
  AppendThread thread(*AppendFile::Create(folder.path() / "x"),
                      {.queue_bytes = 10, .sync = SyncTimer::kInterval});
  thread.Put("more than ten bytes");
  EXPECT_EQ(thread.trouble(), std::errc::device_or_resource_busy);
}

TEST(DiskJobs, AreDoneAtOnceWithoutAThread) {
  bool is_done = false;
  DiskJobs jobs(false);
  jobs.Put([&is_done] { is_done = true; });
  EXPECT_TRUE(is_done);
  EXPECT_TRUE(jobs.is_idle());
}

TEST(DiskJobs, AreDoneInOrderOnAThread) {
  std::vector<int> done;
  DiskJobs jobs(true);
  for (int i = 0; i < 100; ++i) {
    jobs.Put([&done, i] { done.push_back(i); });
  }
  jobs.Wait();
  EXPECT_TRUE(jobs.is_idle());
  ASSERT_EQ(done.size(), 100U);
  EXPECT_TRUE(std::ranges::is_sorted(done));
}

}  // namespace
}  // namespace limpet

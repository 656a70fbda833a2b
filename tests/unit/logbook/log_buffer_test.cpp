// SPDX-License-Identifier: MIT
#include "limpet/logbook/log_buffer.hpp"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/durable/durable_file.hpp"
#include "limpet/durable/failing_file_system.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using Fault = FailingFileSystem::Fault;
using ::testing::ElementsAre;

class LogBufferTest : public ::testing::Test {
 protected:
  void Add(const std::string& line) {
    buffer_.text() += line;
    buffer_.NoteEntry();
  }
  /// Dropped, in doubt, waiting.
  [[nodiscard]] std::vector<std::uint64_t> Losses() const {
    const LogLosses& losses = buffer_.losses();
    return {losses.dropped, losses.in_doubt, losses.waiting};
  }

  TemporaryFolder folder_{PlaceInMemory()};
  FailingFileSystem disk_{RealFileSystem()};
  LogBuffer buffer_{*AppendFile::Create(folder_.path() / "x", disk_)};
};

TEST_F(LogBufferTest, CountsWhatWaits) {
  Add("one\n");
  EXPECT_THAT(Losses(), ElementsAre(0U, 0U, 1U));
  EXPECT_TRUE(buffer_.Flush());
  EXPECT_THAT(Losses(), ElementsAre(0U, 0U, 0U));
}

TEST_F(LogBufferTest, CountsOnceWhatAFailedSyncLeavesInDoubt) {
  Add("one\n");
  Add("two\n");
  ASSERT_TRUE(buffer_.Flush());
  disk_.Set(Fault::kFailing);
  EXPECT_FALSE(buffer_.Sync());
  EXPECT_EQ(buffer_.trouble(), std::errc::io_error);
  EXPECT_FALSE(buffer_.Sync());
  EXPECT_THAT(Losses(), ElementsAre(0U, 2U, 0U));
  disk_.Set(Fault::kNone);
  Add("three\n");
  EXPECT_TRUE(buffer_.Sync());
  EXPECT_FALSE(buffer_.trouble());
  EXPECT_THAT(Losses(), ElementsAre(0U, 2U, 0U));
}

TEST_F(LogBufferTest, SaysHowManyAreMissingWhereTheyWouldBe) {
  Add("one\n");
  ASSERT_TRUE(buffer_.Flush());
  disk_.Set(Fault::kFull);
  Add(std::string(LogBuffer::kMostBytesKept, 'x') + "\n");
  EXPECT_FALSE(buffer_.Flush());
  Add("three\n");
  EXPECT_FALSE(buffer_.Flush());
  EXPECT_THAT(Losses(), ElementsAre(1U, 0U, 1U));
  disk_.Set(Fault::kNone);
  EXPECT_TRUE(buffer_.Sync());
  EXPECT_EQ(*ReadWhole(folder_.path() / "x"),
            "one\n%% 1 messages are missing here: the disk did not take them\nthree\n");
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/durable/append_thread.hpp"

#include <string>

#include <gtest/gtest.h>

#include "limpet/durable/durable_file.hpp"
#include "limpet/durable/failing_file_system.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

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

}  // namespace
}  // namespace limpet

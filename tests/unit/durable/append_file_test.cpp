// SPDX-License-Identifier: MIT
#include "limpet/durable/append_file.hpp"

#include <gtest/gtest.h>

#include "limpet/durable/durable_file.hpp"
#include "limpet/durable/failing_file_system.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using Fault = FailingFileSystem::Fault;

TEST(AppendFile, TakesNothingOfWhatAFullDiskRefuses) {
  AppendFile full = *AppendFile::Create("/dev/full");
  EXPECT_FALSE(full.Append("a line\n"));
  EXPECT_EQ(full.size(), 0U);
  EXPECT_EQ(full.trouble(), std::errc::no_space_on_device);
}

TEST(AppendFile, WritesOverWhatIsThereAndGoesOnAtTheEnd) {
  const TemporaryFolder folder;
  AppendFile file = *AppendFile::Create(folder.path() / "x");
  EXPECT_TRUE(file.Append("abcdef"));
  EXPECT_TRUE(file.Overwrite(1, "XY"));
  EXPECT_TRUE(file.Append("g"));
  EXPECT_TRUE(file.Sync());
  EXPECT_EQ(*ReadWhole(folder.path() / "x"), "aXYdefg");
}

TEST(AppendFile, CutsOffHalfAPieceThatAFullDiskTook) {
  const TemporaryFolder folder;
  FailingFileSystem disk(RealFileSystem());
  AppendFile file = *AppendFile::Create(folder.path() / "x", disk);
  EXPECT_TRUE(file.Append("one\n"));
  disk.Set(Fault::kFull);
  EXPECT_FALSE(file.Append("two\n"));
  EXPECT_EQ(*ReadWhole(folder.path() / "x"), "one\n");
  disk.Set(Fault::kNone);
  EXPECT_TRUE(file.Append("three\n"));
  EXPECT_FALSE(file.trouble());
  EXPECT_EQ(*ReadWhole(folder.path() / "x"), "one\nthree\n");
}

TEST(AppendFile, SaysWhichTroubleADiskHas) {
  const TemporaryFolder folder;
  FailingFileSystem disk(RealFileSystem());
  AppendFile file = *AppendFile::Create(folder.path() / "x", disk);
  ASSERT_TRUE(file.Append("one\n"));
  disk.Set(Fault::kFailing);
  EXPECT_FALSE(file.Sync());
  EXPECT_EQ(file.trouble(), std::errc::io_error);
  disk.Set(Fault::kReadOnly);
  EXPECT_FALSE(AppendFile::Create(folder.path() / "y", disk).has_value());
}

TEST(DurableFile, LeavesTheOldFileOnADiskThatFails) {
  const TemporaryFolder folder;
  FailingFileSystem disk(RealFileSystem());
  ASSERT_FALSE(WriteDurably(folder.path() / "x", "old", disk));
  for (const Fault fault : {Fault::kFull, Fault::kFailing, Fault::kReadOnly}) {
    disk.Set(fault);
    EXPECT_TRUE(WriteDurably(folder.path() / "x", "new", disk));
    EXPECT_EQ(*ReadWhole(folder.path() / "x"), "old");
  }
  disk.Set(Fault::kFull);
  EXPECT_TRUE(WriteDurably(folder.path() / "x", "new", disk));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "x.new")) << "it would fill the disk";
}

TEST(DurableFile, CreatesEveryFolderThatIsMissing) {
  const TemporaryFolder folder;
  EXPECT_FALSE(CreateFolders(folder.path() / "a/b/c"));
  EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "a/b/c"));
  EXPECT_FALSE(CreateFolders(folder.path() / "a/b/c"));
  EXPECT_TRUE(CreateFolders("/proc/none"));
  RemoveFolder(folder.path() / "a");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a"));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
// The disk that the other tests cut: that it forgets what a disk may, and nothing else.
#include "tests/support/torn_disk.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/durable/durable_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::Each;
using ::testing::SizeIs;

class TornDiskTest : public ::testing::Test {
 protected:
  TornDiskTest() { fs::create_directory(root_); }
  [[nodiscard]] static FileSystem::Opened Open(TornDisk& disk, const fs::path& file) {
    FileSystem::Opened opened = disk.Open(file, FileSystem::Opening::kAsItIs);
    EXPECT_NE(opened.file, nullptr);
    return opened;
  }
  /// What a hundred cuts leave of a file; "none" where it is gone.
  [[nodiscard]] std::multiset<std::string> Left(const TornDisk& disk, const char* name) {
    std::multiset<std::string> found;
    for (int cut = 0; cut < 100; ++cut) {
      disk.Cut(disk.calls(), random_, folder_.path() / "left");
      const Expected<std::string> text = ReadWhole(folder_.path() / "left" / name);
      found.insert(text ? *text : "none");
    }
    return found;
  }

  TemporaryFolder folder_{PlaceInMemory()};
  fs::path root_ = folder_.path() / "disk";
  Random random_{1, "cuts"};
};

TEST_F(TornDiskTest, KeepsWhatIsSyncedWithItsName) {
  TornDisk disk(root_);
  const FileSystem::Opened file = Open(disk, root_ / "x");
  ASSERT_FALSE(file.file->WriteAt(0, "synced"));
  ASSERT_FALSE(file.file->Sync());
  ASSERT_FALSE(disk.SyncFolder(root_));
  EXPECT_THAT(Left(disk, "x"), Each("synced"));
}

TEST_F(TornDiskTest, MayForgetANameWhoseFolderIsNotSynced) {
  TornDisk disk(root_);
  const FileSystem::Opened file = Open(disk, root_ / "x");
  ASSERT_FALSE(file.file->WriteAt(0, "synced"));
  ASSERT_FALSE(file.file->Sync());
  EXPECT_THAT(Left(disk, "x"), Contains("none"));
}

TEST_F(TornDiskTest, DropsTearsAndReordersWhatIsNotSynced) {
  TornDisk disk(root_);
  const FileSystem::Opened file = Open(disk, root_ / "x");
  ASSERT_FALSE(disk.SyncFolder(root_));
  ASSERT_FALSE(file.file->WriteAt(0, "ab"));
  ASSERT_FALSE(file.file->WriteAt(2, "cd"));
  const std::multiset<std::string> left = Left(disk, "x");
  EXPECT_THAT(left, Contains(""));
  EXPECT_THAT(left, Contains("ab"));
  EXPECT_THAT(left, Contains("abcd"));
  EXPECT_THAT(left, Contains("a")) << "torn";
  EXPECT_THAT(left, Contains(std::string("\0\0cd", 4))) << "the later write alone";
}

TEST_F(TornDiskTest, HasAMovedFileUnderOneOfItsNames) {
  ASSERT_FALSE(WriteDurably(root_ / "old", "content"));
  TornDisk disk(root_);
  ASSERT_FALSE(disk.Rename(root_ / "old", root_ / "new"));
  const std::multiset<std::string> old = Left(disk, "old");
  EXPECT_THAT(old, Contains("none"));
  EXPECT_THAT(old, Contains("content"));
  ASSERT_FALSE(disk.SyncFolder(root_));
  EXPECT_THAT(Left(disk, "old"), Each("none"));
  EXPECT_THAT(Left(disk, "new"), Each("content"));
}

TEST_F(TornDiskTest, HasALinkedFileUnderItsNewNameOnceThatFolderIsSynced) {
  TornDisk disk(root_);
  ASSERT_FALSE(disk.CreateFolder(root_ / "new"));
  ASSERT_FALSE(SyncFolder(root_, disk));
  ASSERT_FALSE(WriteDurably(root_ / "x", "content", disk));
  ASSERT_FALSE(disk.Link(root_ / "x", root_ / "new/x"));
  const std::multiset<std::string> left = Left(disk, "new/x");
  EXPECT_THAT(left, Contains("none"));
  EXPECT_THAT(left, Contains("content"));
  EXPECT_THAT(Left(disk, "x"), Each("content"));
  ASSERT_FALSE(SyncFolder(root_ / "new", disk));
  ASSERT_FALSE(disk.Remove(root_ / "x"));
  EXPECT_THAT(Left(disk, "new/x"), Each("content")) << "whatever becomes of its other name";
}

TEST_F(TornDiskTest, TearsALinkedFileThatIsNotSyncedUnderBothNamesAlike) {
  TornDisk disk(root_);
  const FileSystem::Opened file = Open(disk, root_ / "x");
  ASSERT_FALSE(file.file->WriteAt(0, "content"));
  ASSERT_FALSE(disk.Link(root_ / "x", root_ / "y"));
  ASSERT_FALSE(disk.SyncFolder(root_));
  bool is_torn = false;
  for (int cut = 0; cut < 100; ++cut) {
    disk.Cut(disk.calls(), random_, folder_.path() / "left");
    const std::string x = *ReadWhole(folder_.path() / "left/x");
    EXPECT_EQ(*ReadWhole(folder_.path() / "left/y"), x);
    is_torn = is_torn || x != "content";
  }
  EXPECT_TRUE(is_torn);
  ASSERT_FALSE(file.file->Sync());
  EXPECT_THAT(Left(disk, "y"), Each("content"));
}

TEST_F(TornDiskTest, IsReadBackAsItWasWritten) {
  TornDisk disk(root_);
  ASSERT_FALSE(WriteDurably(root_ / "x", "now", disk));
  EXPECT_EQ(*ReadWhole(root_ / "x"), "now");
  EXPECT_THAT(Left(disk, "x"), SizeIs(100));
}

}  // namespace
}  // namespace limpet

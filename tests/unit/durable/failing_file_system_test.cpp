// SPDX-License-Identifier: MIT
#include "limpet/durable/failing_file_system.hpp"

#include <gtest/gtest.h>

#include "limpet/durable/durable_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

TEST(FailingFileSystem, SaysOfItsRoomWhatItIsToldAndNothingBefore) {
  FailingFileSystem disk(RealFileSystem());
  EXPECT_FALSE(disk.Room("/"));
  disk.SetRoom(std::uint64_t{200} << 20U);
  EXPECT_EQ(disk.Room("/"), std::uint64_t{200} << 20U);
  disk.Set(FailingFileSystem::Fault::kFull);
  EXPECT_EQ(disk.Room("/"), 0U) << "a full disk has none";
  disk.Set(FailingFileSystem::Fault::kNone);
  disk.SetRoom(std::nullopt);
  EXPECT_EQ(disk.Room("/"), std::uint64_t{10} << 30U);
}

TEST(FailingFileSystem, LinksNothingWhileItFails) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "x", name = folder.path() / "y";
  ASSERT_FALSE(WriteDurably(file, "content"));
  FailingFileSystem disk(RealFileSystem());
  for (const auto fault : {FailingFileSystem::Fault::kFull, FailingFileSystem::Fault::kFailing,
                           FailingFileSystem::Fault::kReadOnly}) {
    disk.Set(fault);
    const std::error_code trouble = disk.Link(file, name);
    EXPECT_TRUE(trouble);
    EXPECT_FALSE(IsWithoutLinks(trouble)) << "a copy would fare no better";
    EXPECT_FALSE(std::filesystem::exists(name));
  }
  disk.Set(FailingFileSystem::Fault::kNone);
  EXPECT_FALSE(disk.Link(file, name));
  EXPECT_EQ(*ReadWhole(name), "content");
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/durable/file_system.hpp"

#include <gtest/gtest.h>

#include "limpet/durable/durable_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

TEST(RealFileSystem, LinksAFileUnderOneMoreName) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "x", name = folder.path() / "y";
  ASSERT_FALSE(WriteDurably(file, "content"));
  ASSERT_FALSE(RealFileSystem().Link(file, name));
  EXPECT_TRUE(fs::equivalent(file, name));
  EXPECT_EQ(fs::hard_link_count(name), 2U);
  ASSERT_FALSE(RealFileSystem().Remove(file));
  EXPECT_EQ(*ReadWhole(name), "content");
}

TEST(RealFileSystem, SaysWhyItCannotLink) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "x", name = folder.path() / "y";
  EXPECT_EQ(RealFileSystem().Link(file, name), std::errc::no_such_file_or_directory);
  ASSERT_FALSE(WriteDurably(file, "content"));
  ASSERT_FALSE(WriteDurably(name, "taken"));
  const std::error_code trouble = RealFileSystem().Link(file, name);
  EXPECT_EQ(trouble, std::errc::file_exists);
  EXPECT_FALSE(IsWithoutLinks(trouble));
  EXPECT_EQ(*ReadWhole(name), "taken");
}

TEST(RealFileSystem, IsWithoutLinksAcrossDisks) {
  if (PlaceInMemory() == fs::temp_directory_path()) GTEST_SKIP() << "one disk only";
  const TemporaryFolder disk, memory(PlaceInMemory());
  ASSERT_FALSE(WriteDurably(disk.path() / "x", "content"));
  const std::error_code trouble = RealFileSystem().Link(disk.path() / "x", memory.path() / "x");
  if (!trouble) GTEST_SKIP() << "one disk only";
  EXPECT_TRUE(IsWithoutLinks(trouble)) << trouble.message();
}

}  // namespace
}  // namespace limpet

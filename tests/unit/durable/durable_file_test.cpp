// SPDX-License-Identifier: MIT
#include "limpet/durable/durable_file.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

TEST(ReadWhole, NamesWhatItCannotRead) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "map.ot");
  for (const char* name : {"map.ot", "absent.csv"}) {
    const Expected<std::string> text = ReadWhole(folder.path() / name);
    ASSERT_FALSE(text) << name;
    EXPECT_THAT(text.error().text, ::testing::HasSubstr(name));
  }
}

}  // namespace
}  // namespace limpet

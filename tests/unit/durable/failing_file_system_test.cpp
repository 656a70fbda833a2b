// SPDX-License-Identifier: MIT
#include "limpet/durable/failing_file_system.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace limpet

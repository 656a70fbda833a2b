// SPDX-License-Identifier: MIT
#include "estimation/mapping/cell_hash.hpp"

#include <set>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(CellHash, TellsNorthFromEastAndSouthFromNorth) {
  EXPECT_EQ(CellHash(0, 0), 0U);
  EXPECT_NE(CellHash(1, 2), CellHash(2, 1));
  EXPECT_NE(CellHash(-1, 2), CellHash(1, 2));
  EXPECT_NE(CellHash(1, -2), CellHash(-1, 2));
}

TEST(CellHash, IsAnotherForEachCellOfAnArea) {
  constexpr std::int32_t kReach = 50;
  std::set<std::size_t> hashes;
  for (std::int32_t north = -kReach; north < kReach; ++north) {
    for (std::int32_t east = -kReach; east < kReach; ++east)
      hashes.insert(CellHash(north, east));
  }
  EXPECT_EQ(hashes.size(), 4U * kReach * kReach);
}

TEST(CellHash, LeavesNoBucketOfAPrimeCountEmpty) {
  constexpr std::size_t kBuckets = 541;
  for (const std::int32_t north : {0, 7, -3}) {
    std::set<std::size_t> filled;
    for (std::int32_t east = 0; east < static_cast<std::int32_t>(8 * kBuckets); ++east)
      filled.insert(CellHash(north, east) % kBuckets);
    EXPECT_EQ(filled.size(), kBuckets) << north;
  }
}

}  // namespace
}  // namespace limpet

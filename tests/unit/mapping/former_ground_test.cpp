// SPDX-License-Identifier: MIT
#include "estimation/mapping/former_ground.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "estimation/mapping/saved_map.hpp"

namespace limpet {
namespace {

constexpr double kResolution = 0.5;

FormerGround GroundOf(const SemanticOctree& former) {
  FormerGround ground(kResolution);
  const Expected<std::vector<MapTile>> tiles = TilesOf(former.Serialize());
  for (const MapTile& tile : *tiles) {
    EXPECT_FALSE(ground.Add(tile));
  }
  return ground;
}

/// All that is laid, tile by tile.
std::vector<FormerGround::Laid> LaidOf(const FormerGround& ground) {
  std::vector<FormerGround::Laid> all;
  for (const TileKey& tile : ground.Tiles()) {
    const auto& laid = ground.LaidIn(tile);
    all.insert(all.end(), laid.begin(), laid.end());
  }
  return all;
}

TEST(FormerGround, KeepsHalfOfWhatWasKnownOfTheGroundAndNothingOfObjects) {
  SemanticOctree former{Meters(kResolution)};
  former.Set({1.25, 0.25, 6.25}, {.occupied = 2.0F});
  former.Set({5.25, 0.25, 6.25}, {.occupied = 2.0F, .label = VoxelLabel::kNew});
  const FormerGround ground = GroundOf(former);
  EXPECT_FLOAT_EQ(ground.At(KeyOf({1.3, 0.3, 6.3}, kResolution)).value(), 1.0F);
  EXPECT_FALSE(ground.At(KeyOf({5.3, 0.3, 6.3}, kResolution)));
  EXPECT_FALSE(ground.At(KeyOf({1.8, 0.3, 6.3}, kResolution)));
}

TEST(FormerGround, LaysEachVoxelOfACubeThatTheTreeHadMerged) {
  SemanticOctree former{Meters(kResolution)};
  for (int i = 0; i < 64; ++i) {
    former.Set({0.5 * (i % 4) + 0.25, 0.5 * (i / 4 % 4) + 0.25, 0.5 * (i / 16) + 0.25},
               {.occupied = -1.0F});
  }
  const Expected<SemanticOctree> saved = SemanticOctree::Parse(former.Serialize());
  ASSERT_TRUE(saved);
  ASSERT_EQ(saved->Leaves().size(), 1U) << "one cube of two metres";
  const FormerGround ground = GroundOf(*saved);
  const std::vector<FormerGround::Laid> laid = LaidOf(ground);
  EXPECT_EQ(laid.size(), 64U);
  for (const auto& [key, occupied] : laid) {
    EXPECT_FLOAT_EQ(occupied, -0.5F);
    EXPECT_EQ(ground.At({key[0], key[1], key[2]}), occupied);
  }
}

TEST(FormerGround, LiesWhereTheFormerFrameIsAndOccupiedWhereTwoMeet) {
  SemanticOctree former{Meters(kResolution)};
  former.Set({0.25, 0.25, 6.25}, {.occupied = -1.0F});
  former.Set({0.75, 0.25, 6.25}, {.occupied = 2.0F});
  FormerGround ground = GroundOf(former);
  EXPECT_FALSE(
      ground.SetOffset({.shift_W = {0.05, 0.0}, .turn = 0.0, .pivot_W = {0.0, 0.0}, .down = 0.0}))
      << "no voxel would show it";
  EXPECT_TRUE(ground.SetOffset(
      {.shift_W = {10.0, 0.0}, .turn = 0.785, .pivot_W = {0.5, 0.25}, .down = 0.0}));
  float greatest = -9.0F;
  for (const auto& [key, occupied] : LaidOf(ground)) {
    greatest = std::max(greatest, occupied);
    EXPECT_NEAR((key[0] + 0.5) * kResolution, 10.5, 0.6);
  }
  EXPECT_FLOAT_EQ(greatest, 1.0F);
}

/// More tiles than are unpacked at a time, turned by 30 degrees: nothing is lost at their seams.
TEST(FormerGround, LaysAllOfALargeMapTileByTile) {
  SemanticOctree former{Meters(kResolution)};
  int voxels = 0;
  for (double north = 5.25; north < 300.0; north += 10.0) {
    for (double east = 5.25; east < 300.0; east += 10.0, ++voxels) {
      former.Set({north, east, 6.25}, {.occupied = 2.0F});
    }
  }
  FormerGround ground = GroundOf(former);
  EXPECT_EQ(static_cast<int>(LaidOf(ground).size()), voxels);
  EXPECT_TRUE(ground.SetOffset(
      {.shift_W = {-20.0, 7.0}, .turn = 0.52, .pivot_W = {100.0, 100.0}, .down = 0.0}));
  EXPECT_EQ(static_cast<int>(LaidOf(ground).size()), voxels);
}

}  // namespace
}  // namespace limpet

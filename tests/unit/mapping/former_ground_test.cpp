// SPDX-License-Identifier: MIT
#include "estimation/mapping/former_ground.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr double kResolution = 0.5;

TEST(FormerGround, KeepsHalfOfWhatWasKnownOfTheGroundAndNothingOfObjects) {
  SemanticOctree former{Meters(kResolution)};
  former.Set({1.25, 0.25, 6.25}, {.occupied = 2.0F});
  former.Set({5.25, 0.25, 6.25}, {.occupied = 2.0F, .label = VoxelLabel::kNew});
  FormerGround ground(kResolution);
  ground.Set(former);
  EXPECT_FALSE(ground.is_laid());
  ground.Lay();
  EXPECT_TRUE(ground.is_laid());
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
  FormerGround ground(kResolution);
  ground.Set(*saved);
  ground.Lay();
  int count = 0;
  ground.ForEach([&](const VoxelKey& key, float occupied) {
    ++count;
    EXPECT_FLOAT_EQ(occupied, -0.5F);
    EXPECT_EQ(ground.At(key), occupied);
  });
  EXPECT_EQ(count, 64);
}

TEST(FormerGround, LiesWhereTheFormerFrameIsAndOccupiedWhereTwoMeet) {
  SemanticOctree former{Meters(kResolution)};
  former.Set({0.25, 0.25, 6.25}, {.occupied = -1.0F});
  former.Set({0.75, 0.25, 6.25}, {.occupied = 2.0F});
  FormerGround ground(kResolution);
  ground.Set(former);
  ground.Lay();
  ground.SetOffset({.shift_W = {0.05, 0.0}, .turn = 0.0, .pivot_W = {0.0, 0.0}, .down = 0.0});
  EXPECT_TRUE(ground.is_laid()) << "no voxel would show it";
  ground.SetOffset({.shift_W = {10.0, 0.0}, .turn = 0.785, .pivot_W = {0.5, 0.25}, .down = 0.0});
  EXPECT_FALSE(ground.is_laid());
  ground.Lay();
  float greatest = -9.0F;
  ground.ForEach([&](const VoxelKey& key, float occupied) {
    greatest = std::max(greatest, occupied);
    EXPECT_NEAR(CentreOf(key, kResolution).x(), 10.5, 0.6);
  });
  EXPECT_FLOAT_EQ(greatest, 1.0F);
}

}  // namespace
}  // namespace limpet

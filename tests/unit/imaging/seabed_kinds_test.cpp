// SPDX-License-Identifier: MIT
#include "limpet/imaging/seabed_kinds.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

SeabedTile TileOf(const char* kind, std::uint64_t seed = 3) {
  return MakeSeabed(kind, seed).Lit({0.3, 0.5, 0.8}, 1.0);
}

/// Mean of a channel's packed value over the coarsest level.
double MeanOf(const SeabedTile& tile, unsigned channel) {
  const SeabedTile::Level level = tile.level(SeabedTile::kLevels - 1);
  constexpr int kStep = SeabedTile::kUnitsPerTexel << (SeabedTile::kLevels - 1);
  double sum = 0.0;
  for (int row = 0; row < 128; ++row) {
    for (int column = 0; column < 128; ++column) {
      sum += (level.At(column * kStep, row * kStep) >> (8U * channel)) & 255U;
    }
  }
  return sum / (128.0 * 128.0);
}

TEST(SeabedKinds, GrassIsGreenerAndDarkerThanSand) {
  const SeabedTile sand = TileOf("sand");
  const SeabedTile grass = TileOf("seagrass");
  EXPECT_LT(MeanOf(grass, 1), 0.8 * MeanOf(sand, 1));
  EXPECT_GT(MeanOf(grass, 1) / MeanOf(grass, 2), 1.1 * MeanOf(sand, 1) / MeanOf(sand, 2));
}

TEST(SeabedKinds, CoarseLevelsAreAsBrightAsFineOnes) {
  const SeabedTile sand = TileOf("sand");
  double fine = 0.0;
  for (int row = 0; row < SeabedTile::kSize; row += 16) {
    for (int column = 0; column < SeabedTile::kSize; column += 16) {
      fine += (sand.level(0).At(column * SeabedTile::kUnitsPerTexel,
                                row * SeabedTile::kUnitsPerTexel) >>
               8U) &
              255U;
    }
  }
  EXPECT_NEAR(fine / (128.0 * 128.0), MeanOf(sand, 1), 3.0);
}

TEST(SeabedKinds, RepeatWithoutASeamAndWithTheSeed) {
  const SeabedTile one = TileOf("sand");
  constexpr int kSide = SeabedTile::kSize * SeabedTile::kUnitsPerTexel;
  EXPECT_EQ(one.Between(12345, 67890), one.Between(12345 + kSide, 67890 - kSide));
  EXPECT_EQ(one.level(1).At(12345, 67890), TileOf("sand").level(1).At(12345, 67890));
  EXPECT_NE(MeanOf(one, 1), MeanOf(TileOf("sand", 4), 1));
}

}  // namespace
}  // namespace limpet

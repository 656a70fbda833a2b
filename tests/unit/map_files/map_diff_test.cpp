// SPDX-License-Identifier: MIT
#include "limpet/map_files/map_diff.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

/// 12 by 12 m; `depth` of a place.
template <class Depth>
DepthGrid GridOf(const Depth& depth) {
  DepthGrid grid{.north_min = -6.0,
                 .east_min = -6.0,
                 .cell_m = 0.2,
                 .rows = 60,
                 .columns = 60,
                 .down_m = {},
                 .sigma_m = {}};
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      grid.down_m.push_back(static_cast<float>(
          depth(grid.north_min + 0.2 * (row + 0.5), grid.east_min + 0.2 * (column + 0.5))));
      grid.sigma_m.push_back(0.06F);
    }
  }
  return grid;
}

double Flat(double, double) { return 7.5; }

TEST(MapDiff, ASessionDoesNotDifferFromItself) {
  const DepthGrid grid = GridOf(Flat);
  const DepthDifference difference = Difference(grid, grid, {});
  EXPECT_EQ(difference.cells, 3600U);
  EXPECT_EQ(difference.offset_m, 0.0);
  EXPECT_EQ(difference.rms_m, 0.0);
  EXPECT_TRUE(difference.changes.empty());
}

TEST(MapDiff, TheTideIsNoChange) {
  Random random(1);
  const DepthDifference difference = Difference(
      GridOf(Flat), GridOf([&](double, double) { return 8.1 + random.Normal(0.05); }), {});
  EXPECT_NEAR(difference.offset_m, 0.6, 0.02);
  EXPECT_TRUE(difference.changes.empty());
}

TEST(MapDiff, FindsAHoleAndAHeapWithTheirSigns) {
  const DepthDifference difference =
      Difference(GridOf(Flat), GridOf([](double north, double east) {
                   if (std::hypot(north - 2.0, east - 1.0) < 1.0) return 8.3;
                   return std::hypot(north + 3.0, east) < 0.6 ? 6.9 : 7.5;
                 }),
                 {});
  ASSERT_EQ(difference.changes.size(), 2U);
  const DepthChange& hole = difference.changes[0];
  EXPECT_NEAR(hole.north, 2.0, 0.1);
  EXPECT_NEAR(hole.east, 1.0, 0.1);
  EXPECT_NEAR(hole.mean_m, 0.8, 0.01);
  EXPECT_NEAR(hole.area_m2, 3.14, 0.4);
  EXPECT_GT(hole.z, 3.0);
  EXPECT_NEAR(difference.changes[1].mean_m, -0.6, 0.01);
}

TEST(MapDiff, ComparesPlacesWhereTheFramesSayTheyAre) {
  const auto heap = [](double north, double east) {
    return std::hypot(north, east) < 1.0 ? 6.5 : 7.5;
  };
  FrameOffset offset;
  offset.shift = {1.0, -2.0};
  const auto moved = [&](double north, double east) { return heap(north - 1.0, east + 2.0); };
  EXPECT_FALSE(Difference(GridOf(heap), GridOf(moved), {}).changes.empty());
  EXPECT_TRUE(Difference(GridOf(heap), GridOf(moved), offset).changes.empty());
}

TEST(MapDiff, OfGroundThatOneNeverSawNothingIsSaid) {
  EXPECT_EQ(Difference({}, GridOf(Flat), {}).cells, 0U);
  EXPECT_EQ(Difference(GridOf(Flat), {}, {}).cells, 0U);
}

}  // namespace
}  // namespace limpet

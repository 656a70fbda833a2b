// SPDX-License-Identifier: MIT
#include "limpet/map_files/map_diff.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

/// 12 by 12 m; `depth` of a place.
template <class Depth>
DepthGrid GridOf(const Depth& depth) {
  DepthGrid grid;
  grid.frame = {.north_min = -6.0, .east_min = -6.0, .cell_m = 0.2, .rows = 60, .columns = 60};
  for (int row = 0; row < grid.frame.rows; ++row) {
    for (int column = 0; column < grid.frame.columns; ++column) {
      grid.down_m.push_back(
          static_cast<float>(depth(-6.0 + 0.2 * (row + 0.5), -6.0 + 0.2 * (column + 0.5))));
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

TEST(MapDiff, SaysHowManyColumnsEitherKnows) {
  DepthGrid part = GridOf(Flat);
  for (std::size_t cell = 1000; cell < part.down_m.size(); ++cell)
    part.down_m[cell] = std::numeric_limits<float>::quiet_NaN();
  const DepthDifference difference = Difference(part, GridOf(Flat), {});
  EXPECT_EQ(difference.cells_a, 1000U);
  EXPECT_EQ(difference.cells_b, 3600U);
  EXPECT_EQ(difference.cells, 1000U + 121U) << "and what lies within 0.6 m of those";
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

/// As a session keeps it: so many beams of a DVL's noise in each column of 6 by 6 m.
DepthGrid SurveyedGrid(int beams, std::uint64_t seed, double patch_m) {
  Random random(seed);
  DepthMap depths(0.2);
  for (double north = -2.9; north < 3.0; north += 0.2) {
    for (double east = -2.9; east < 3.0; east += 0.2) {
      const double down = 7.5 + (std::hypot(north, east) < 0.6 ? patch_m : 0.0);
      for (int beam = 0; beam < beams; ++beam) {
        depths.Add({north, east, down + random.Normal(0.02)});
      }
    }
  }
  return DepthGridOf(depths);
}

TEST(MapDiff, TenBeamsAColumnTellTenCentimetres) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const DepthGrid before = SurveyedGrid(10, seed, 0.0);
    const DepthDifference same = Difference(before, SurveyedGrid(10, seed + 10, 0.0), {});
    EXPECT_TRUE(same.changes.empty());
    const DepthDifference deeper = Difference(before, SurveyedGrid(10, seed + 20, 0.1), {});
    ASSERT_EQ(deeper.changes.size(), 1U);
    EXPECT_NEAR(deeper.changes[0].mean_m, 0.1, 0.02);
    EXPECT_NEAR(deeper.changes[0].area_m2, 3.14 * 0.6 * 0.6, 0.4);
    EXPECT_LT(std::hypot(deeper.changes[0].north, deeper.changes[0].east), 0.1);
    EXPECT_TRUE(Difference(SurveyedGrid(1, seed, 0.0), SurveyedGrid(1, seed + 20, 0.05), {})
                    .changes.empty());
  }
}

/// `grid` as one session knows it whose beams met every third line of columns, from `first` on.
DepthGrid EveryThirdLine(DepthGrid grid, int first) {
  for (int row = 0; row < grid.frame.rows; ++row) {
    if (row % 3 == first) continue;
    for (int column = 0; column < grid.frame.columns; ++column)
      grid.down_m[grid.Index(row, column)] = std::numeric_limits<float>::quiet_NaN();
  }
  return grid;
}

TEST(MapDiff, ComparesColumnsWithThoseBesideThemWhereBeamsMetOtherOnes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const DepthGrid before = EveryThirdLine(SurveyedGrid(10, seed, 0.0), 0);
    const DepthGrid same = EveryThirdLine(SurveyedGrid(10, seed + 10, 0.0), 1);
    const DepthDifference unchanged = Difference(before, same, {});
    EXPECT_EQ(unchanged.cells, unchanged.cells_a + unchanged.cells_b);
    EXPECT_TRUE(unchanged.changes.empty());
    EXPECT_LT(unchanged.sigma_scale, 1.3);
    const DepthGrid dug = EveryThirdLine(SurveyedGrid(10, seed + 20, 0.2), 1);
    const DepthDifference deeper = Difference(before, dug, {});
    ASSERT_EQ(deeper.changes.size(), 1U);
    EXPECT_LT(std::hypot(deeper.changes[0].north, deeper.changes[0].east), 0.2);
    EXPECT_NEAR(deeper.changes[0].mean_m, 0.17, 0.04);
  }
}

TEST(MapDiff, WhatAllGroundDiffersByMoreThanItsSigmasIsNoChange) {
  Random random(7);
  const auto rough = [&random](double, double) { return 7.5 + random.Normal(0.4); };
  const DepthDifference difference = Difference(GridOf(rough), GridOf(rough), {});
  EXPECT_NEAR(difference.sigma_scale, 0.4 / 0.06, 0.3);
  EXPECT_TRUE(difference.changes.empty());
}

TEST(MapDiff, AFewNeighboursThatAPingPutFourSigmasOffAreNoChange) {
  const auto with_patch = [](double cells) {
    return GridOf([cells](double north, double east) {
      const bool is_off = std::abs(north) < 0.1 && east > 0.0 && east < 0.2 * cells;
      return is_off ? 7.5 - 4.0 * 0.06 * std::sqrt(2.0) : 7.5;
    });
  };
  EXPECT_TRUE(Difference(GridOf(Flat), with_patch(6.0), {}).changes.empty());
  EXPECT_EQ(Difference(GridOf(Flat), with_patch(20.0), {}).changes.size(), 1U);
}

TEST(MapDiff, ComparesPlacesWhereTheFramesSayTheyAre) {
  const auto heap = [](double north, double east) {
    return std::hypot(north, east) < 1.0 ? 6.5 : 7.5;
  };
  FrameOffset offset;
  offset.shift_W = {1.0, -2.0};
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

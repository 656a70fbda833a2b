// SPDX-License-Identifier: MIT
// What a grid obeys whatever is seen, over random flights.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/survey/survey_grid.hpp"
#include "tests/support/grid_heights.hpp"

namespace limpet {
namespace {

struct SeenFrom {
  Pose X_WB;
  double altitude = 0.0;
};

SurveyArea SmallArea() {
  return {.north_min = -4.0,
          .north_max = 5.0,
          .east_min = -3.0,
          .east_max = 6.0,
          .margin = 2.0,
          .object_height_max = 2.0};
}

std::vector<SeenFrom> DrawFlight(Random& random, int frames) {
  std::vector<SeenFrom> flight;
  for (int i = 0; i < frames; ++i) {
    const double altitude = random.Uniform(2.0, 5.0);
    flight.push_back(
        {.X_WB = {{random.Uniform(-6.0, 7.0), random.Uniform(-5.0, 8.0), 7.5 - altitude},
                  random.Uniform(-0.1, 0.1),
                  random.Uniform(-0.1, 0.1),
                  random.Uniform(-3.1, 3.1)},
         .altitude = altitude});
  }
  return flight;
}

SurveyGrid Flown(const std::vector<SeenFrom>& flight, double reach = 1e6) {
  SurveyGrid grid(SmallArea());
  grid.SetReach(reach);
  for (const SeenFrom& frame : flight)
    grid.Observe(frame.X_WB, frame.altitude, CameraModel{});
  return grid;
}

class SurveyGridProperties : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam()), "grid"};
  std::vector<SeenFrom> flight_ = DrawFlight(random_, 15);
};

TEST_P(SurveyGridProperties, AFrameSeenTwiceSaysNothingMore) {
  std::vector<SeenFrom> twice = flight_;
  twice.insert(twice.end(), flight_.begin(), flight_.end());
  EXPECT_EQ(HeightsOf(Flown(flight_)), HeightsOf(Flown(twice)));
}

TEST_P(SurveyGridProperties, MoreFramesNeverTakeCoverageBack) {
  SurveyGrid grid(SmallArea());
  Coverage before = grid.coverage();
  std::vector<float> seen = HeightsOf(grid);
  for (const SeenFrom& frame : flight_) {
    grid.Observe(frame.X_WB, frame.altitude, CameraModel{});
    const Coverage now = grid.coverage();
    EXPECT_GE(now.seabed, before.seabed);
    EXPECT_GE(now.band, before.band);
    EXPECT_GE(now.band_top, before.band_top);
    const std::vector<float> heights = HeightsOf(grid);
    EXPECT_TRUE(std::ranges::equal(seen, heights, std::less_equal<>{}));
    before = now, seen = heights;
  }
}

TEST_P(SurveyGridProperties, TheTopIsSeenNoSoonerThanTheBandAndThatNoSoonerThanTheBottom) {
  const Coverage seen = Flown(flight_).coverage();
  EXPECT_LE(seen.band_top, seen.band);
  EXPECT_LE(seen.band, seen.seabed);
  EXPECT_LE(seen.seabed, 1.0);
  EXPECT_GT(seen.seabed, 0.0);
}

TEST_P(SurveyGridProperties, NoHeightIsBeyondTheHighestObject) {
  const SurveyGrid grid = Flown(flight_);
  for (const float height : HeightsOf(grid)) {
    EXPECT_TRUE(height == SurveyGrid::kNeverSeen ||
                (height >= 0.0F && height <= static_cast<float>(grid.object_height_max())));
  }
}

TEST_P(SurveyGridProperties, WhatAMirrorWasToldInAnyPiecesIsTheGrid) {
  SurveyGrid grid(SmallArea());
  SurveyGrid mirror(grid.frame(), grid.object_height_max());
  grid.SetReach(4.0);
  for (const SeenFrom& frame : flight_) {
    grid.Observe(frame.X_WB, frame.altitude, CameraModel{});
    if (random_.Chance(0.3)) {
      grid.SetSeabed(
          {random_.Uniform(-4.0, 5.0), random_.Uniform(-3.0, 6.0), random_.Uniform(7.0, 8.0)});
    }
    if (random_.Chance(0.5)) {
      EXPECT_TRUE(mirror.Apply(grid.TakeDelta()));
    }
  }
  EXPECT_TRUE(mirror.Apply(grid.TakeDelta()));
  EXPECT_EQ(HeightsOf(mirror), HeightsOf(grid));
  EXPECT_EQ(mirror.coverage().band, grid.coverage().band);
  EXPECT_EQ(mirror.coverage().seabed, grid.coverage().seabed);
  SurveyGrid late(grid.frame(), grid.object_height_max());
  EXPECT_TRUE(late.Apply(grid.Everything()));
  EXPECT_EQ(HeightsOf(late), HeightsOf(grid));
}

TEST_P(SurveyGridProperties, ADeltaIsEmptyOnceItWasTaken) {
  SurveyGrid grid = Flown(flight_);
  EXPECT_FALSE(grid.TakeDelta().cells.empty());
  const std::uint64_t version = grid.version();
  EXPECT_TRUE(grid.TakeDelta().cells.empty());
  EXPECT_EQ(grid.version(), version);
}

TEST_P(SurveyGridProperties, WaterThatShowsLessNeverCoversMore) {
  Coverage before{.seabed = 1.0, .band = 1.0, .band_top = 1.0};
  for (const double reach : {12.0, 6.0, 4.0, 3.0, 2.0, 0.5}) {
    const Coverage seen = Flown(flight_, reach).coverage();
    EXPECT_LE(seen.band, before.band);
    EXPECT_LE(seen.seabed, before.seabed);
    before = seen;
  }
  EXPECT_EQ(before.seabed, 0.0) << "no frame was as near to the bottom as half a metre";
}

TEST_P(SurveyGridProperties, TheReachCountsAsItIsTodayNotAsItWasThen) {
  SurveyGrid told_late = Flown(flight_, 12.0);
  told_late.SetReach(3.5);
  const SurveyGrid told_first = Flown(flight_, 3.5);
  EXPECT_EQ(told_late.coverage().band, told_first.coverage().band);
  EXPECT_EQ(told_late.coverage().seabed, told_first.coverage().seabed);
}

TEST_P(SurveyGridProperties, ASeabedIsTheMeanOfItsFirstBeamsAndStaysWithinThem) {
  SurveyGrid grid(SmallArea());
  double sum = 0.0, low = 1e9, high = -1e9;
  for (int i = 1; i <= 4; ++i) {
    const double down = random_.Uniform(6.5, 8.5);
    low = std::min(low, down), high = std::max(high, down), sum += down;
    grid.SetSeabed({0.1, 0.1, down});
    const int row = static_cast<int>(4.1 / 0.25), column = static_cast<int>(3.1 / 0.25);
    ASSERT_TRUE(grid.Seabed(row, column));
    EXPECT_GE(*grid.Seabed(row, column), low - 1e-5);
    EXPECT_LE(*grid.Seabed(row, column), high + 1e-5);
    EXPECT_NEAR(*grid.Seabed(row, column), sum / i, 1e-5);
  }
}

TEST_P(SurveyGridProperties, ABeamTellsOfTheCellsWithinItsReachAlone) {
  SurveyGrid grid(SmallArea());
  const double north = random_.Uniform(-2.0, 3.0), east = random_.Uniform(-1.0, 4.0);
  grid.SetSeabed({north, east, 7.0});
  for (int row = 0; row < grid.frame().rows; ++row) {
    for (int column = 0; column < grid.frame().columns; ++column) {
      const double off = std::hypot(grid.frame().north_min + (row + 0.5) * 0.25 - north,
                                    grid.frame().east_min + (column + 0.5) * 0.25 - east);
      EXPECT_EQ(grid.Seabed(row, column).has_value(), off <= SurveyGrid::kSeabedReach);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, SurveyGridProperties, ::testing::Range(1, 7));

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/survey/survey_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/survey/survey_shape.hpp"
#include "tests/support/grid_heights.hpp"

namespace limpet {
namespace {

const SurveyArea kArea{.north_min = -15.0,
                       .north_max = 15.0,
                       .east_min = -18.0,
                       .east_max = 18.0,
                       .margin = 2.0,
                       .object_height_max = 2.0};

Pose At(double north, double east, double yaw = 0.0) {
  Pose pose;
  pose.p_WB = {north, east, 3.5};
  pose.yaw = yaw;
  return pose;
}

int RowOf(const SurveyGrid& grid, double north) {
  return static_cast<int>((north - grid.frame().north_min) / grid.frame().cell_m);
}
int ColumnOf(const SurveyGrid& grid, double east) {
  return static_cast<int>((east - grid.frame().east_min) / grid.frame().cell_m);
}

double SeenArea(const SurveyGrid& grid, double height) {
  double cells = 0.0;
  for (const float h : HeightsOf(grid)) {
    cells += static_cast<double>(h) >= height ? 1.0 : 0.0;
  }
  return cells * grid.frame().cell_m * grid.frame().cell_m;
}

TEST(SurveyGrid, CoversTheAreaWithWholeCells) {
  const SurveyGrid grid(kArea);
  EXPECT_EQ(grid.frame().rows, 120);
  EXPECT_EQ(grid.frame().columns, 144);
}

TEST(SurveyGrid, StartsWithNothingSeen) {
  const SurveyGrid grid(kArea);
  EXPECT_EQ(grid.coverage().seabed, 0.0);
  EXPECT_FALSE(grid.SeenHeight(60, 70).has_value());
}

TEST(SurveyGrid, OneImageShowsItsFootprintOnTheBottom) {
  SurveyGrid grid(kArea);
  grid.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  EXPECT_NEAR(SeenArea(grid, 0.0), 6.713 * 4.619, 1.0);
}

TEST(SurveyGrid, TheImageIsHalfAsWideAtTheTopOfTheBand) {
  SurveyGrid grid(kArea);
  grid.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  const double inset = 2.0 * SurveyGrid::kDiscInset;
  EXPECT_NEAR(SeenArea(grid, 2.0), (3.356 - inset) * (2.309 - inset), 0.5);
}

TEST(SurveyGrid, TheImageIsWideAcrossTheTrack) {
  SurveyGrid grid(kArea);
  grid.Observe(At(0.0, 0.0, std::numbers::pi / 2.0), 4.0, CameraModel{});  // heading east
  EXPECT_TRUE(grid.SeenHeight(RowOf(grid, 3.0), ColumnOf(grid, 0.0)).has_value());
  EXPECT_FALSE(grid.SeenHeight(RowOf(grid, 0.0), ColumnOf(grid, 3.0)).has_value());
}

TEST(SurveyGrid, RollMovesTheFootprintToTheRaisedSide) {
  SurveyGrid grid(kArea);
  Pose rolled = At(0.0, 0.0);
  rolled.roll = 0.3;  // starboard down: the camera looks to port
  grid.Observe(rolled, 4.0, CameraModel{});
  EXPECT_TRUE(grid.SeenHeight(RowOf(grid, 0.0), ColumnOf(grid, -4.5)).has_value());
  EXPECT_FALSE(grid.SeenHeight(RowOf(grid, 0.0), ColumnOf(grid, 3.0)).has_value());
}

TEST(SurveyGrid, ALaterLowerLookNeverForgetsAHigherOne) {
  SurveyGrid grid(kArea);
  grid.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  const double before = SeenArea(grid, 1.0);
  grid.Observe(At(0.0, 2.5), 4.0, CameraModel{});
  EXPECT_GE(SeenArea(grid, 1.0), before);
  EXPECT_DOUBLE_EQ(grid.SeenHeight(RowOf(grid, 0.1), ColumnOf(grid, 0.1)).value(), 2.0);
}

TEST(SurveyGrid, KnownReliefRaisesTheBottomIntoTheNarrowPartOfTheView) {
  SurveyGrid flat(kArea), ridge(kArea);
  for (double east = -5.0; east < 5.0; east += 0.5) {
    ridge.SetSeabed({0.0, east, 6.0});  // 1.5 m above the flat bottom at 7.5 m
  }
  flat.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  ridge.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  EXPECT_LT(SeenArea(ridge, 0.0), SeenArea(flat, 0.0));
}

TEST(SurveyGrid, SeabedIsUnknownUntilMeasuredAndThenAveraged) {
  SurveyGrid grid(kArea);
  const int row = RowOf(grid, 1.0), column = ColumnOf(grid, 1.0);
  EXPECT_FALSE(grid.Seabed(row, column).has_value());
  grid.SetSeabed({1.0, 1.0, 7.0});
  grid.SetSeabed({1.0, 1.0, 8.0});
  EXPECT_NEAR(grid.Seabed(row, column).value(), 7.5, 1e-6);
}

TEST(SurveyGrid, AMirrorFedWithDeltasIsTheSameGrid) {
  SurveyGrid grid(kArea), mirror(kArea);
  for (int i = 0; i < 5; ++i) {
    grid.SetSeabed(Eigen::Vector3d(i, i, 7.4));
    grid.Observe(At(i, 2.0 * i, 0.3 * i), 4.0, CameraModel{});
    ASSERT_TRUE(mirror.Apply(grid.TakeDelta()));
  }
  EXPECT_EQ(HeightsOf(grid), HeightsOf(mirror));
  EXPECT_TRUE(mirror.TakeDelta().cells.empty()) << "it has nothing to tell of its own";
}

TEST(SurveyGrid, ALateMirrorLearnsEverythingAtOnce) {
  SurveyGrid grid(kArea), mirror(kArea);
  for (int i = 0; i < 5; ++i) {
    grid.Observe(At(i, 2.0 * i, 0.3 * i), 4.0, CameraModel{});
    static_cast<void>(grid.TakeDelta());
  }
  ASSERT_TRUE(mirror.Apply(grid.Everything()));
  EXPECT_EQ(HeightsOf(grid), HeightsOf(mirror));
  EXPECT_TRUE(grid.TakeDelta().cells.empty()) << "others' deltas are not delayed";
}

TEST(SurveyGrid, AMirrorFollowsAlsoToWhatWasNotSeenAfterAll) {
  SurveyGrid grid(kArea), mirror(kArea), corrected(kArea);
  grid.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  grid.Observe(At(5.0, 0.0), 4.0, CameraModel{});
  ASSERT_TRUE(mirror.Apply(grid.TakeDelta()));
  corrected.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  corrected.Observe(At(5.5, 0.5), 4.0, CameraModel{});
  corrected.SetSeabed({5.5, 0.5, 7.6});
  const SurveyGrid expected = corrected;
  const std::uint64_t before = grid.version();
  grid.Become(std::move(corrected));
  EXPECT_EQ(HeightsOf(grid), HeightsOf(expected));
  EXPECT_GT(grid.version(), before);
  const GridDelta delta = grid.TakeDelta();
  EXPECT_LT(delta.cells.size(), 700U) << "of the image that stayed, nothing is told";
  ASSERT_TRUE(mirror.Apply(delta));
  EXPECT_EQ(HeightsOf(mirror), HeightsOf(expected));
  EXPECT_EQ(mirror.coverage().band, expected.coverage().band);
  EXPECT_EQ(mirror.Seabed(RowOf(mirror, 5.5), ColumnOf(mirror, 0.5)), 7.6F);
}

TEST(SurveyGrid, BecomingWhatItIsChangesNothing) {
  SurveyGrid grid(kArea), same(kArea);
  for (SurveyGrid* each : {&grid, &same}) {
    each->Observe(At(0.0, 0.0), 4.0, CameraModel{});
    each->SetSeabed({0.0, 0.0, 7.4});
  }
  static_cast<void>(grid.TakeDelta());
  const std::uint64_t before = grid.version();
  grid.Become(std::move(same));
  EXPECT_EQ(grid.version(), before);
  EXPECT_TRUE(grid.TakeDelta().cells.empty());
}

TEST(SurveyGrid, ADeltaHoldsEachChangedCellOnce) {
  SurveyGrid grid(kArea);
  grid.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  grid.Observe(At(0.1, 0.0), 4.0, CameraModel{});
  const GridDelta delta = grid.TakeDelta();
  std::vector<std::uint32_t> cells;
  for (const GridDelta::Cell& cell : delta.cells) {
    cells.push_back(cell.index);
  }
  std::sort(cells.begin(), cells.end());
  EXPECT_EQ(std::adjacent_find(cells.begin(), cells.end()), cells.end());
  EXPECT_TRUE(grid.TakeDelta().cells.empty());
}

TEST(SurveyGrid, RefusesADeltaOfAnotherFrame) {
  SurveyGrid grid(kArea), coarse(kArea, 0.5);
  coarse.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  EXPECT_FALSE(grid.Apply(coarse.TakeDelta()));
  EXPECT_EQ(grid.coverage().seabed, 0.0);
}

TEST(SurveyGrid, CoverageIsAnHonestShareWhenLanesLeaveThinGaps) {
  // Lanes 6.8 m apart leave gaps of 0.09 m: 1.3 % of the bottom, less than a cell wide.
  SurveyGrid grid(SurveyArea{0.0, 20.0, 0.0, 68.0, 2.0, 0.0});
  for (int lane = 0; lane < 10; ++lane) {
    for (double north = -3.0; north < 23.0; north += 0.25) {
      grid.Observe(At(north, 6.8 * lane + 3.4), 4.0, CameraModel{});
    }
  }
  EXPECT_NEAR(1.0 - grid.coverage().seabed, (6.8 - 6.713) / 6.8, 0.003);
}

TEST(SurveyGrid, BandCoverageIsTheMeanOverTheHeightsOfObjects) {
  SurveyGrid grid(SurveyArea{-0.25, 0.25, -0.25, 0.25, 2.0, 2.0});
  grid.Observe(At(0.0, 0.0), 2.75, CameraModel{});  // seen to about 2.4 m at most: to the top
  EXPECT_NEAR(grid.coverage().band, 1.0, 0.05);
  EXPECT_GT(grid.coverage().band, grid.coverage().band_top - 1e-9);
}

TEST(SurveyGridInMurk, WhatWasTooFarAwayIsNotCovered) {
  SurveyGrid clear(kArea), murky(kArea);
  murky.SetReach(3.0);  // from 4 m
  clear.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  murky.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  EXPECT_GT(clear.coverage().seabed, 0.0);
  EXPECT_EQ(murky.coverage().seabed, 0.0);
  EXPECT_EQ(murky.coverage().band_top, clear.coverage().band_top);
  EXPECT_LT(murky.coverage().band, clear.coverage().band);
  EXPECT_NEAR(murky.SeenFloor(RowOf(murky, 0.0), ColumnOf(murky, 0.0)), 1.0, 0.11);
}

TEST(SurveyGridInMurk, WaterThatTurnsOutMurkyTakesCoverageBack) {
  SurveyGrid grid(kArea);
  grid.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  const double before = grid.coverage().seabed;
  static_cast<void>(grid.TakeDelta());
  grid.SetReach(3.0);
  EXPECT_EQ(grid.coverage().seabed, 0.0);
  EXPECT_FALSE(grid.TakeDelta().cells.empty());
  grid.SetReach(8.0);
  EXPECT_EQ(grid.coverage().seabed, before);
}

TEST(SurveyGridInMurk, ALowerPassShowsWhatTheHigherDidNot) {
  SurveyGrid grid(kArea);
  grid.SetReach(3.0);
  grid.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  Pose low = At(0.0, 0.0);
  low.p_WB.z() = 5.0;  // 2.5 m above the bottom
  grid.Observe(low, 2.5, CameraModel{});
  EXPECT_GT(grid.coverage().seabed, 0.0);
}

TEST(SurveyGridInMurk, AMirrorKnowsWhatWasOutOfSight) {
  SurveyGrid grid(kArea), mirror(kArea);
  grid.SetReach(3.0);
  grid.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  ASSERT_TRUE(mirror.Apply(grid.TakeDelta()));
  EXPECT_EQ(mirror.coverage().seabed, 0.0);
  EXPECT_EQ(mirror.coverage().band, grid.coverage().band);
  grid.SetReach(8.0);
  ASSERT_TRUE(mirror.Apply(grid.TakeDelta()));
  EXPECT_EQ(mirror.coverage().seabed, grid.coverage().seabed);
}

SurveyArea SquareKilometre() {
  SurveyArea area = kArea;
  area.north_max = area.north_min + 1000.0;
  area.east_max = area.east_min + 1000.0;
  return area;
}

TEST(SurveyGrid, ASquareKilometreShowsWhatItsPartWould) {
  SurveyGrid large(SquareKilometre());
  large.Observe(At(900.0, 300.0, 0.4), 4.0, CameraModel{});
  const Coverage seen = large.coverage();
  const double cells = 16.0e6;
  EXPECT_NEAR(seen.seabed * cells * 0.0625, 6.713 * 4.619, 1.0);
  EXPECT_EQ(large.wanted_cells(), 16'000'000U);
  EXPECT_EQ(static_cast<double>(large.TakeDelta().cells.size()), std::round(seen.seabed * cells));
}

TEST(SurveyGrid, ABlankOfItWantsTheSameGroundAndHasSeenNothing) {
  SurveyArea area = AreaWithin({{-15.0, -18.0}, {15.0, -18.0}, {15.0, 18.0}});
  area.object_height_max = 2.0;
  SurveyGrid grid(area);
  grid.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  const SurveyGrid blank = grid.Blank();
  EXPECT_EQ(blank.coverage().seabed, 0.0);
  EXPECT_EQ(blank.wanted_cells(), grid.wanted_cells());
  EXPECT_EQ(blank.IsWanted(100, 10), grid.IsWanted(100, 10));
}

/// Cells of a square of the grid, in order.
std::vector<std::uint32_t> CellsWithin(const SurveyGrid& grid, double low, double high) {
  std::vector<std::uint32_t> cells;
  for (int row = RowOf(grid, low); row < RowOf(grid, high); ++row) {
    for (int column = ColumnOf(grid, low); column < ColumnOf(grid, high); ++column) {
      cells.push_back(static_cast<std::uint32_t>(row * grid.frame().columns + column));
    }
  }
  return cells;
}

TEST(SurveyGrid, GroundThatSomethingStandsOnIsNotToBeSeenAsLongAsItDoes) {
  SurveyGrid grid(kArea);
  grid.Observe(At(0.0, 0.0), 4.0, CameraModel{});
  const Coverage before = grid.coverage();
  const std::uint64_t version = grid.version();
  EXPECT_TRUE(grid.SetStanding(CellsWithin(grid, 6.0, 12.0)));
  EXPECT_FALSE(grid.SetStanding(CellsWithin(grid, 6.0, 12.0)));
  EXPECT_NE(grid.version(), version) << "whoever mirrors it looks again";
  const int in = RowOf(grid, 8.0);
  EXPECT_FALSE(grid.IsWanted(in, ColumnOf(grid, 8.0)));
  EXPECT_TRUE(grid.IsOfArea(in, ColumnOf(grid, 8.0)));
  EXPECT_NEAR(grid.coverage().seabed, before.seabed * 1080.0 / (1080.0 - 36.0), 1e-9);
  EXPECT_EQ(grid.Blank().wanted_cells(), grid.wanted_cells());
  EXPECT_TRUE(grid.SetStanding(CellsWithin(grid, -0.5, 0.5)));
  EXPECT_LT(grid.coverage().seabed, before.seabed) << "what had been seen counts no more";
  EXPECT_TRUE(grid.SetStanding({}));
  EXPECT_EQ(grid.coverage().seabed, before.seabed);
}

TEST(SurveyGrid, NothingIsSeenBehindAnObstacle) {
  const SightObstacles pile(
      {{.id = 1, .outline = {{1.0, -0.5}, {1.0, 0.5}, {1.5, 0.5}, {1.5, -0.5}}, .top = 0.0}});
  SurveyGrid grid(kArea), clear(kArea);
  const Pose X_WB = At(0.0, 0.0);
  grid.Observe(X_WB, 4.0, CameraModel{}, 0.0, pile.From(X_WB.p_WB, 6.0));
  clear.Observe(X_WB, 4.0, CameraModel{});
  const int behind = RowOf(grid, 2.1), before = RowOf(grid, 0.6), beside = ColumnOf(grid, 1.9);
  EXPECT_TRUE(clear.SeenHeight(behind, ColumnOf(grid, 0.1)).has_value());
  EXPECT_FALSE(grid.SeenHeight(behind, ColumnOf(grid, 0.1)).has_value());
  EXPECT_TRUE(grid.SeenHeight(behind, beside).has_value());
  EXPECT_TRUE(grid.SeenHeight(before, ColumnOf(grid, 0.1)).has_value());
}

}  // namespace
}  // namespace limpet

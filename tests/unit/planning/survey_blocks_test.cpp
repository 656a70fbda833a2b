// SPDX-License-Identifier: MIT
#include "limpet/planning/survey_blocks.hpp"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

namespace limpet {
namespace {

SurveyArea Square(double side) {
  SurveyArea area;
  area.north_min = 0.0, area.north_max = side;
  area.east_min = 0.0, area.east_max = side;
  area.object_height_max = 1.0;
  return area;
}

const Footprint kFrom9m({.altitude = 9.0, .object_height_max = 1.0}, CameraModel{});

/// Shows every cell of the block up to the top.
void ShowAll(SurveyGrid& grid, const CellBox& block) {
  GridDelta delta{.frame = grid.frame(), .cells = {}};
  for (int row = block.row_min; row <= block.row_max; ++row) {
    for (int column = block.column_min; column <= block.column_max; ++column) {
      delta.cells.push_back(
          {.index = static_cast<std::uint32_t>(row * grid.frame().columns + column),
           .now = {.seen_height = 1.0F, .seabed_down = 14.0F}});
    }
  }
  ASSERT_TRUE(grid.Apply(delta));
}

Ground GroundOf(const SurveyGrid& grid, const SurveyBlocks& blocks) {
  return {grid, kFrom9m, kBottomTwice, blocks.now(), blocks.cells_per_side()};
}

double Apart(const CellBox& a, const CellBox& b) {
  return 0.125 * (std::abs(a.row_min + a.row_max - b.row_min - b.row_max) +
                  std::abs(a.column_min + a.column_max - b.column_min - b.column_max));
}

TEST(SurveyBlocks, ASurveyOfAHundredMetresIsPlannedAsAWhole) {
  const SurveyGrid grid(Square(100.0));
  SurveyBlocks blocks(grid, kFrom9m);
  EXPECT_TRUE(blocks.is_whole());
  EXPECT_EQ(blocks.count(), 1U);
  EXPECT_EQ(blocks.now().row_max, 399);
  EXPECT_FALSE(blocks.Onward().has_value());
  const Ground ground = GroundOf(grid, blocks);
  EXPECT_FALSE(ground.is_part());
  EXPECT_FALSE(blocks.GoOn(ground, {0.0, 0.0}, 1e6));
}

TEST(SurveyBlocks, OfASquareKilometreEveryCellIsInOneBlockAndEachLeadsToItsNeighbour) {
  SurveyGrid grid(Square(1000.0));
  SurveyBlocks blocks(grid, kFrom9m);
  ASSERT_GT(blocks.count(), 60U);
  ASSERT_TRUE(blocks.GoOn(GroundOf(grid, blocks), {990.0, 2.0}, 0.0)) << "puts them in order";
  EXPECT_EQ(blocks.now().row_max, 3999) << "begins at the corner where the vehicle is";
  EXPECT_EQ(blocks.now().column_min, 0);
  std::size_t cells = 0, steps = 0;
  CellBox before = blocks.now();
  do {
    const CellBox& now = blocks.now();
    cells += static_cast<std::size_t>((now.row_max - now.row_min + 1) *
                                      (now.column_max - now.column_min + 1));
    EXPECT_LT(Apart(before, now), 125.0) << "step " << steps;
    before = now;
    ShowAll(grid, before);
    ++steps;
  } while (blocks.GoOn(GroundOf(grid, blocks), {500.0, 500.0}, 0.0));
  EXPECT_EQ(steps, blocks.count());
  EXPECT_EQ(cells, 16'000'000U);
  EXPECT_EQ(blocks.passed_over(), 0U);
  EXPECT_EQ(grid.coverage().band_top, 1.0);
}

TEST(SurveyBlocks, ABlockThatTakesSeveralTimesItsWayIsPassedOver) {
  const SurveyGrid grid(Square(1000.0));
  SurveyBlocks blocks(grid, kFrom9m);
  static_cast<void>(blocks.GoOn(GroundOf(grid, blocks), {0.0, 0.0}, 0.0));
  const Ground ground = GroundOf(grid, blocks);
  EXPECT_FALSE(blocks.GoOn(ground, {400.0, 400.0}, 9000.0)) << "it has not been there yet";
  EXPECT_FALSE(blocks.GoOn(ground, {10.0, 10.0}, 9400.0));
  EXPECT_FALSE(blocks.GoOn(ground, {10.0, 10.0}, 10'400.0));
  EXPECT_TRUE(blocks.GoOn(ground, {10.0, 10.0}, 14'000.0));
  EXPECT_EQ(blocks.passed_over(), 1U);
}

/// Else a vehicle that has seen all but slivers of a block waits between it and the next.
TEST(SurveyBlocks, ABlockThatItsPlanGivesUpIsLeftAndTheNextOneBegun) {
  SurveyGrid grid(Square(1000.0));
  SurveyBlocks blocks(grid, kFrom9m);
  static_cast<void>(blocks.GoOn(GroundOf(grid, blocks), {0.0, 0.0}, 0.0));
  CellBox nearly = blocks.now();
  nearly.row_max -= (nearly.row_max - nearly.row_min) / 30;  // a margin of three per cent
  ShowAll(grid, nearly);
  EXPECT_FALSE(blocks.GoOn(GroundOf(grid, blocks), {10.0, 10.0}, 10.0));
  blocks.GiveUp();
  EXPECT_TRUE(blocks.GoOn(GroundOf(grid, blocks), {10.0, 10.0}, 10.0));
  EXPECT_EQ(blocks.index(), 1U);
  EXPECT_EQ(blocks.passed_over(), 0U) << "slivers";
  blocks.GiveUp();
  EXPECT_FALSE(blocks.GoOn(GroundOf(grid, blocks), {10.0, 10.0}, 10.0)) << "not reached yet";
  const PlanePoint there{10.0, 0.25 * blocks.now().column_min + 10.0};
  EXPECT_FALSE(blocks.GoOn(GroundOf(grid, blocks), there, 100.0)) << "what was said before";
  blocks.GiveUp();
  EXPECT_TRUE(blocks.GoOn(GroundOf(grid, blocks), there, 100.0));
  EXPECT_EQ(blocks.passed_over(), 1U) << "all of it";
}

TEST(SurveyBlocks, LeavesOutBlocksThatHoldNothingOfTheArea) {
  SurveyArea area = AreaWithin({{0.0, 0.0}, {1000.0, 980.0}, {1000.0, 1000.0}, {0.0, 20.0}});
  area.object_height_max = 1.0;
  const SurveyGrid grid(area);
  const SurveyBlocks blocks(grid, kFrom9m);
  EXPECT_FALSE(blocks.is_whole());
  EXPECT_LT(blocks.count(), 35U);
  EXPECT_GT(blocks.count(), 8U);
}

TEST(SurveyBlocks, ASquareOfCellsIsSeenOnceAllOfThemAre) {
  SurveyGrid grid(Square(200.0));
  const CellBox window{.row_min = 4, .row_max = 10, .column_min = 0, .column_max = 5};
  ShowAll(grid, {.row_min = 4, .row_max = 6, .column_min = 0, .column_max = 5});
  const Ground ground(grid, kFrom9m, kBottomTwice, window, 2);
  EXPECT_EQ(ground.frame().rows, 4);
  EXPECT_EQ(ground.frame().columns, 3);
  EXPECT_EQ(ground.frame().cell_m, 0.5);
  EXPECT_EQ(ground.frame().north_min, 1.0);
  EXPECT_EQ(ground.wanted_cells(), 12U);
  EXPECT_DOUBLE_EQ(ground.SeenShare(), 0.25);
}

TEST(SurveyBlocks, HoldWholeLanes) {
  const SurveyGrid grid(Square(1000.0));
  const SurveyBlocks blocks(grid, kFrom9m);
  const double side = 0.25 * (blocks.now().row_max - blocks.now().row_min + 1);
  const double lanes = side / (2.0 * kFrom9m.half_across(Footprint::kLayers - 1));
  EXPECT_LT(std::ceil(lanes) - lanes, 0.35);
  EXPECT_GT(side, 60.0);
  EXPECT_LT(side, 150.0);
}

}  // namespace
}  // namespace limpet

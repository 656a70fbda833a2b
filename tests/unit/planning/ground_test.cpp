// SPDX-License-Identifier: MIT
#include "limpet/planning/ground.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr SurveyArea kGroundArea{.north_min = -15.0,
                                 .north_max = 15.0,
                                 .east_min = -18.0,
                                 .east_max = 18.0,
                                 .margin = 2.0,
                                 .object_height_max = 2.0};
constexpr int kTop = Footprint::kLayers - 1;
const SurveyHeights kHeights{.altitude = 4.0, .object_height_max = kGroundArea.object_height_max};

Footprint FootprintWith(double reach) { return {kHeights, CameraModel{}, reach}; }

Pose Above() {
  Pose pose;
  pose.p_WB = {0.0, 0.0, 3.5};
  return pose;
}

TEST(FootprintInMurk, ClearWaterIsAsNoWater) {
  const Footprint clear = FootprintWith(9.0), none(kHeights, CameraModel{});
  for (int layer = 0; layer <= kTop; ++layer) {
    EXPECT_EQ(clear.half_across(layer), none.half_across(layer));
    EXPECT_EQ(clear.half_along(layer), none.half_along(layer));
  }
}

TEST(FootprintInMurk, LayersNestWhereCornersAreOutOfSight) {
  const Footprint murky = FootprintWith(4.8);
  EXPECT_TRUE(murky.is_in_reach(0));
  EXPECT_LT(murky.half_across(0), FootprintWith(9.0).half_across(0));
  for (int layer = 1; layer <= kTop; ++layer) {
    EXPECT_LE(murky.half_across(layer), murky.half_across(layer - 1));
    EXPECT_LE(murky.half_along(layer), murky.half_along(layer - 1));
  }
}

TEST(FootprintInMurk, ABottomOutOfReachDoesNotCutWhatIsAbove) {
  const Footprint murky = FootprintWith(3.6);
  EXPECT_FALSE(murky.is_in_reach(0));
  EXPECT_EQ(murky.half_across(0), 0.0);
  EXPECT_TRUE(murky.is_in_reach(kTop));
  EXPECT_GT(murky.half_across(kTop), 0.8 * FootprintWith(9.0).half_across(kTop));
  EXPECT_GT(murky.widest_layer(), 0);
}

TEST(FootprintInMurk, WhereNothingIsInReachThereIsStillSomethingToDivideBy) {
  EXPECT_GT(FootprintWith(1.0).swath(), 0.0);
}

TEST(GroundInMurk, LayersOutOfReachAreDoneAndTheRestIsOpen) {
  const SurveyGrid grid(kGroundArea);
  const Ground ground(grid, FootprintWith(3.6));
  const int lowest = ground.footprint().widest_layer();
  EXPECT_EQ(ground.SeenShare(lowest - 1), 1.0);
  EXPECT_EQ(ground.SeenShare(lowest), 0.0);
}

TEST(GroundInMurk, ACellWhoseBottomWasTooFarAwayStaysOpen) {
  SurveyGrid grid(kGroundArea);
  grid.SetReach(4.2);  // the bottom below is 4 m away, the image's corners 4.6 m and more
  grid.Observe(Above(), 4.0, CameraModel{});
  const Ground ground(grid, FootprintWith(4.8));
  const Ground clear_ground = [] {
    SurveyGrid clear(kGroundArea);
    clear.Observe(Above(), 4.0, CameraModel{});
    return Ground(clear, FootprintWith(9.0));
  }();
  EXPECT_GT(ground.SeenShare(0), 0.0);
  EXPECT_LT(ground.SeenShare(0), 0.5 * clear_ground.SeenShare(0));
}

TEST(GroundInMurk, NothingIsLeftToDoWhereNothingIsInReach) {
  const SurveyGrid grid(kGroundArea);
  const Ground ground(grid, FootprintWith(1.0));
  EXPECT_EQ(ground.SeenShare(), 1.0);
}

TEST(Ground, NothingIsToBeSeenWhereAnObstacleStands) {
  SurveyGrid grid(kGroundArea);
  grid.Observe(Above(), 4.0, CameraModel{});
  Ground ground(grid, FootprintWith(9.0));
  const double before = ground.SeenShare(0);
  std::vector<std::uint32_t> standing;
  for (std::uint32_t row = 90; row < 110; ++row) {
    for (std::uint32_t column = 20; column < 60; ++column)
      standing.push_back(row * 144 + column);
  }
  ASSERT_TRUE(grid.SetStanding(standing));
  ground.Update(grid);
  EXPECT_EQ(ground.wanted_cells(), 120U * 144U - 800U);
  EXPECT_NEAR(ground.SeenShare(0), before * 17280.0 / 16480.0, 1e-9);
  EXPECT_EQ(ground.levels()[100 * 144 + 40], Footprint::kLayers);
  ASSERT_TRUE(grid.SetStanding({}));
  ground.Update(grid);
  EXPECT_EQ(ground.SeenShare(0), before);
}

}  // namespace
}  // namespace limpet

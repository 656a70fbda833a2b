// SPDX-License-Identifier: MIT
#include "limpet/scoring/obstacle_score.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(ObstacleScore, SaysHowNearTheVehicleTrulyCame) {
  Scenario scenario;
  scenario.seabed.roughness_m = 0.0;
  scenario.seabed.depth_m = 8.0;
  scenario.obstacles = {
      {.name = "pile", .north_m = 5.0, .east_m = 2.0, .radius_m = 0.5, .height_m = 10.0},
      {.name = "wreck", .shape = "box", .north_m = 5.0, .size_m = {2.0, 2.0}, .height_m = 3.0}};
  PoseTrack track;
  for (int i = 0; i <= 100; ++i) {
    track.Add(Seconds(i), {.p_WB = {0.1 * i, 0.0, 4.0}, .roll = 0.0, .pitch = 0.0, .yaw = 0.0});
  }
  const auto scores = ScoreObstacles(track, scenario);
  ASSERT_EQ(scores.size(), 2U);
  EXPECT_EQ(scores[0].name, "pile");
  EXPECT_NEAR(scores[0].distance_m, 1.5, 1e-9);
  EXPECT_NEAR(scores[1].distance_m, 1.0, 1e-9);  // it passes a metre above
}

}  // namespace
}  // namespace limpet

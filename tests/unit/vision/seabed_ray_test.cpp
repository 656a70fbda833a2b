// SPDX-License-Identifier: MIT
#include "limpet/vision/seabed_ray.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(SeabedRays, MeetALevelSeabedExactly) {
  SeabedRelief relief([](const Eigen::Vector2d&) { return 7.5; });
  const SeabedRays rays(relief, {1.0, 2.0, 3.5}, 60.0);
  double distance = 4.5;
  const SeabedPoint met = rays.Meet({0.25, -0.5, 1.0}, distance);
  EXPECT_NEAR(distance, 4.0, 1e-6);
  EXPECT_LT((met.p_W - Eigen::Vector3d(2.0, 0.0, 7.5)).norm(), 1e-6);
}

TEST(SeabedRays, MeetASlopeThatRisesTowardsThem) {
  SeabedRelief relief([](const Eigen::Vector2d& p_W) { return 7.0 - 0.2 * p_W.x(); });
  const SeabedRays rays(relief, {0.0, 0.0, 3.0}, 60.0);
  double distance = 4.0;
  const SeabedPoint met = rays.Meet({0.5, 0.0, 1.0}, distance);
  EXPECT_NEAR(met.p_W.z(), 7.0 - 0.2 * met.p_W.x(), 1e-4);
  EXPECT_NEAR(met.ground.slope_north, -0.2, 1e-4);
}

TEST(SeabedRays, AboveTheHorizonEndAtTheFarthest) {
  SeabedRelief relief([](const Eigen::Vector2d&) { return 7.5; });
  const SeabedRays rays(relief, {0.0, 0.0, 3.5}, 60.0);
  double distance = 4.0;
  EXPECT_NEAR(rays.Meet({1.0, 0.0, -0.1}, distance).p_W.x(), 60.0, 1e-9);
  EXPECT_EQ(distance, 60.0);
}

}  // namespace
}  // namespace limpet

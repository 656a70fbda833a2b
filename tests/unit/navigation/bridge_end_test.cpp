// SPDX-License-Identifier: MIT
#include "estimation/navigation/bridge_end.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

/// A model of the water that was taught 0.5 m/s to the north for a minute.
class BridgeEndTest : public ::testing::Test {
 protected:
  BridgeEndTest() {
    for (int i = 0; i < 300; ++i)
      water_.Add(0.2 * i, kNorth, {});
  }
  const Eigen::Vector2d kNorth{0.5, 0.0};
  WaterModel water_{WaterParams{}, 0.0};
  BridgeEndCheck check_{0.012};
};

TEST_F(BridgeEndTest, IsNothingBeforeADropoutHasEnded) {
  check_.Add(60.0, kNorth, {});
  EXPECT_FALSE(check_.end());
  EXPECT_FALSE(check_.Reopen(60.0, Radians(0.0)));
}

TEST_F(BridgeEndTest, AveragesTheVelocitiesOfItsFirstSecondsAlone) {
  check_.Begin({.t = 90.0, .length = 30.0}, water_);
  for (const double t : {90.0, 90.5, 91.0, 91.9})
    check_.Add(t, kNorth - Eigen::Vector2d(0.1, -0.05), {});
  const BridgeEnd in_time = *check_.end();
  EXPECT_EQ(in_time.count, 4);
  EXPECT_NEAR((in_time.off_H - Eigen::Vector2d(0.1, -0.05)).norm(), 0.0, 0.02);
  EXPECT_GT(in_time.variance_H.minCoeff(), 0.0);
  check_.Add(92.5, {9.0, 9.0}, {});
  EXPECT_EQ(check_.end()->count, 4);
}

TEST_F(BridgeEndTest, TellsWhatItIsOffAheadAndAbeamOfTheVehicle) {
  const double east = 0.5 * M_PI;
  check_.Begin({.t = 90.0, .length = 30.0, .yaw = east}, water_);
  check_.Add(90.0, Eigen::Vector2d(0.0, 0.3), {.yaw = east});
  const Eigen::Vector2d off_W = water_.VelocityAt(90.0, {.yaw = east}) - Eigen::Vector2d(0.0, 0.3);
  EXPECT_NEAR(check_.end()->off_H.x(), off_W.y(), 1e-12);
  EXPECT_NEAR(check_.end()->off_H.y(), -off_W.x(), 1e-12);
}

TEST_F(BridgeEndTest, ThatProvesFalseBeginsAnewWithTheWaterOfBefore) {
  check_.Begin({.t = 90.0, .length = 30.0}, water_);
  const WaterModel::State before = water_.state();
  water_.Add(90.0, {0.1, 0.4}, {});
  ASSERT_NE(water_.state(), before);
  const auto restored = check_.Reopen(93.0, Radians(0.3));
  ASSERT_TRUE(restored);
  EXPECT_EQ(restored->state(), before);
  EXPECT_EQ(check_.end()->length, 33.0);
  EXPECT_EQ(check_.end()->count, 0);
  EXPECT_TRUE(check_.end()->is_open);
  check_.Begin({.t = 94.0, .length = 1.0}, water_);
  EXPECT_EQ(check_.end()->t, 93.0) << "what is refused while it is open is no dropout";
  check_.Close();
  check_.Begin({.t = 95.0, .length = 1.0}, water_);
  EXPECT_EQ(check_.end()->t, 95.0);
}

TEST_F(BridgeEndTest, IsNotTakenBackLongAfter) {
  check_.Begin({.t = 90.0, .length = 30.0}, water_);
  EXPECT_FALSE(check_.Reopen(106.0, Radians(0.0)));
  EXPECT_FALSE(check_.end()->is_open);
}

}  // namespace
}  // namespace limpet

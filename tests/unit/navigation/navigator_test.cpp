// SPDX-License-Identifier: MIT
#include "estimation/navigation/navigator.hpp"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr double kSeabed = 7.5, kDown = 3.5;  // [m]

/// A vehicle at rest, tilted, over a flat seabed; the DVL sits off the body's origin.
class NavigatorTest : public ::testing::Test {
 protected:
  static NavigatorParams Params() {
    NavigatorParams params;
    params.odometry.dvl_B = {-0.5, 0.3, 0.4};
    return params;
  }
  /// What the DVL measures: its own height above the seabed.
  static double DvlAltitude(double roll, double pitch) {
    const Eigen::Matrix3d R_WB = RotationFromRollPitchYaw(roll, pitch, 0.0);
    return kSeabed - (kDown + (R_WB * Params().odometry.dvl_B).z());
  }
  void Rest(double roll, double pitch, double seconds, bool has_lock = true) {
    for (const double end = t_ + seconds; t_ < end; t_ += 0.1) {
      AttitudeEstimate attitude;
      attitude.t = t_, attitude.roll = roll, attitude.pitch = pitch;
      navigator_.AddAttitude(attitude);
      navigator_.AddDepth(t_, Meters(kDown));
      if (t_ < 1.0) navigator_.AddGps(t_, {0.0, 0.0}, 0.4);
      if (has_lock) {
        navigator_.AddVelocity(t_, Eigen::Vector3d::Zero());
        navigator_.AddAltitude(t_, Meters(DvlAltitude(roll, pitch)));
      }
      navigator_.Advance(t_);
    }
  }
  Navigator navigator_{Params()};
  double t_ = 0.0;
};

TEST_F(NavigatorTest, AltitudeIsThatOfTheBodyOriginHoweverTheVehicleTilts) {
  Rest(0.2, -0.3, 5.0);
  EXPECT_NEAR(navigator_.Estimate(t_).altitude.value(), kSeabed - kDown, 1e-9);
}

TEST_F(NavigatorTest, AFrameComesWithTheAltitudeAtItsExposure) {
  Rest(0.2, -0.3, 3.0);
  navigator_.AddFrame({.frame = 1, .exposure = Seconds(t_ - 0.1), .boxes = {}});
  Rest(0.2, -0.3, 2.0);
  const std::vector<ObservedFrame> frames = navigator_.TakeFrames();
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_NEAR(frames[0].altitude.value(), kSeabed - kDown, 1e-9);
}

TEST_F(NavigatorTest, AnAltitudeIsForgottenSoonAfterBottomLockIsLost) {
  Rest(0.0, 0.0, 5.0);
  Rest(0.0, 0.0, 3.0, false);
  EXPECT_FALSE(navigator_.Estimate(t_).altitude.has_value());
}

TEST_F(NavigatorTest, ACorruptTimeIsRefusedAndCountedAndStopsNothing) {
  Rest(0.0, 0.0, 5.0);
  AttitudeEstimate leap;
  leap.t = t_ + 1e6;
  navigator_.AddAttitude(leap);
  navigator_.AddVelocity(t_ + 1e6, Eigen::Vector3d::Zero());
  navigator_.AddDepth(std::nan(""), Meters(kDown));
  navigator_.AddFrame({.frame = 1, .exposure = Seconds(t_ + 1e6), .boxes = {}});
  EXPECT_EQ(navigator_.counts().stale_samples, 4);
  const int before = navigator_.node_count();
  Rest(0.0, 0.0, 5.0);
  EXPECT_GE(navigator_.node_count(), before + 4);
}

TEST_F(NavigatorTest, ARealGapInTheAttitudeIsCrossed) {
  Rest(0.0, 0.0, 5.0);
  t_ += 120.0;
  Rest(0.0, 0.0, 5.0);
  EXPECT_NEAR(navigator_.Estimate(t_).t, t_, 1e-9);
  EXPECT_GT(navigator_.Estimate(t_).sd_p_W.x(), 0.5);
}

TEST_F(NavigatorTest, SigmasGrowWhileNothingIsMeasured) {
  Rest(0.0, 0.0, 5.0);
  const NavigatorEstimate fresh = navigator_.Estimate(t_);
  navigator_.Advance(t_ + 100.0);
  const NavigatorEstimate stale = navigator_.Estimate(t_ + 100.0);
  EXPECT_LT(fresh.sd_p_W.x(), 1.0);
  EXPECT_NEAR(stale.sd_p_W.x(), 75.0, 1.0);
  EXPECT_NEAR(stale.sd_p_W.z(), 30.0, 1.0);
  EXPECT_GT(stale.sd_yaw, 1.0);
}

TEST_F(NavigatorTest, WithoutVelocityForLongThePositionIsLostButDepthIsNot) {
  Rest(0.0, 0.0, 5.0);
  Rest(0.0, 0.0, 60.0, false);
  EXPECT_LT(navigator_.Estimate(t_).sd_p_W.x(), 25.0) << "it may have begun to go";
  EXPECT_GT(navigator_.Estimate(t_).sd_p_W.x(), 10.0);
  Rest(0.0, 0.0, 600.0, false);
  const NavigatorEstimate estimate = navigator_.Estimate(t_);
  EXPECT_NEAR(estimate.sd_p_W.x(), 0.75 * 420.0, 30.0);
  EXPECT_LT(estimate.sd_p_W.z(), 0.5);
}

TEST_F(NavigatorTest, VelocitiesThatGoBackInTimeAreCounted) {
  Rest(0.0, 0.0, 5.0);
  navigator_.AddVelocity(t_ - 3.0, Eigen::Vector3d(2.0, 0.0, 0.0));
  EXPECT_EQ(navigator_.counts().stale_samples, 1);
  EXPECT_EQ(navigator_.counts().velocities, 0);
}

TEST(NavigatorMounting, AFixIsOfTheAntennaWhereverThatIs) {
  NavigatorParams params;
  params.antenna_B = {2.0, 1.0, -0.3};
  Navigator navigator(params);
  for (double t = 0.0; t < 5.0; t += 0.1) {
    AttitudeEstimate attitude;
    attitude.t = t, attitude.yaw = 0.5 * std::numbers::pi;
    navigator.AddAttitude(attitude);
    navigator.AddDepth(t, Meters(0.1));
    navigator.AddVelocity(t, Eigen::Vector3d::Zero());
    navigator.AddGps(t, {10.0, 20.0}, 0.4);
    navigator.Advance(t);
  }
  const Eigen::Vector3d p_WB = navigator.Estimate(5.0).X_WB.p_WB;
  EXPECT_NEAR(p_WB.x(), 10.0 + 1.0, 0.05);
  EXPECT_NEAR(p_WB.y(), 20.0 - 2.0, 0.05);
}

TEST(NavigatorMounting, ATurnOnTheSpotIsNoFalseVelocityHoweverFarOffTheDvlIs) {
  NavigatorParams params;
  params.odometry.dvl_B = {-2.0, 0.0, 0.4};
  Navigator navigator(params);
  constexpr double kRate = 0.4;  // [rad/s], from 3 s on
  for (double t = 0.0; t < 20.0; t += 0.1) {
    AttitudeEstimate attitude;
    attitude.t = t, attitude.yaw = WrapAngle(kRate * std::max(0.0, t - 3.0));
    navigator.AddAttitude(attitude);
    navigator.AddDepth(t, Meters(3.0));
    navigator.AddVelocity(t, Eigen::Vector3d(0.0, t > 3.0 ? -2.0 * kRate : 0.0, 0.0));
    if (t < 1.0) navigator.AddGps(t, {0.0, 0.0}, 0.4);
    navigator.Advance(t);
  }
  EXPECT_LE(navigator.counts().velocities, 2) << "while it begins to turn, at once";
  EXPECT_LT(navigator.Estimate(20.0).X_WB.p_WB.head<2>().norm(), 0.2);
}

}  // namespace
}  // namespace limpet

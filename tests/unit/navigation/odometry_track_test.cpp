// SPDX-License-Identifier: MIT
#include "estimation/navigation/odometry_track.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace limpet {
namespace {

/// A vehicle on a circle: 0.5 m/s, 0.1 rad/s, level; the DVL sits off the body's origin.
class OdometryTrackTest : public ::testing::Test {
 protected:
  static constexpr double kSpeed = 0.5, kTurn = 0.1;
  const Eigen::Vector3d v_dvl_ = Eigen::Vector3d(kSpeed, 0.0, 0.0) +
                                 Eigen::Vector3d(0.0, 0.0, kTurn).cross(OdometryParams{}.dvl_B);

  void Drive(double from, double to, bool has_lock = true) {
    for (int i = static_cast<int>(std::lround(from * 20.0)); i < std::lround(to * 20.0); ++i) {
      const double t = 0.05 * i;
      AttitudeEstimate attitude;
      attitude.t = t, attitude.yaw = WrapAngle(kTurn * t), attitude.yaw_rate = kTurn;
      track_.AddAttitude(attitude);
      if (i % 4 == 0) {
        track_.AddVelocity(t, has_lock ? std::optional(v_dvl_) : std::nullopt);
      }
    }
  }
  static Eigen::Vector2d OnCircle(double t) {
    const double radius = kSpeed / kTurn;
    return {radius * std::sin(kTurn * t), radius * (1.0 - std::cos(kTurn * t))};
  }
  OdometryTrack track_{OdometryParams{}};
};

TEST_F(OdometryTrackTest, FollowsACircleWithTheDvlOffTheOrigin) {
  Drive(0.0, 60.0);
  const OdometryStep step = track_.Between({0.0, 50.0});
  EXPECT_NEAR((step.motion.head<2>() - OnCircle(50.0)).norm(), 0.0, 2e-3);
  EXPECT_NEAR(step.motion(3), 5.0, 1e-9);
  EXPECT_NEAR(step.path, 25.0 * v_dvl_.norm() / kSpeed, 0.05);
}

TEST_F(OdometryTrackTest, StepsCompoundToTheWholeWay) {
  Drive(0.0, 20.0);
  const OdometryStep first = track_.Between({1.0, 7.3}), second = track_.Between({7.3, 15.0});
  const OdometryStep whole = track_.Between({1.0, 15.0});
  const Eigen::Vector2d turned = Eigen::Rotation2Dd(first.motion(3)) * second.motion.head<2>();
  EXPECT_NEAR((first.motion.head<2>() + turned - whole.motion.head<2>()).norm(), 0.0, 1e-9);
  EXPECT_NEAR(first.motion(3) + second.motion(3), whole.motion(3), 1e-12);
}

TEST_F(OdometryTrackTest, ADropoutsEndShowsWhatItsBridgeWasOff) {
  const Eigen::Vector3d current_W(0.0, 0.1, 0.0);  // comes up while nothing measures it
  for (int i = 0; i <= 3000; ++i) {
    const double t = 0.05 * i;
    track_.AddAttitude({.t = t, .yaw = 0.3});
    if (i % 4 != 0) continue;
    const bool is_after = t > 120.0;
    const Eigen::Vector3d v_B =
        Eigen::Vector3d(kSpeed, 0.0, 0.0) +
        (is_after ? Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitZ()) * current_W
                  : Eigen::Vector3d(Eigen::Vector3d::Zero()));
    const bool has_lock = t < 60.0 || is_after;
    track_.AddVelocity(t, has_lock ? std::optional(v_B) : std::nullopt);
  }
  ASSERT_TRUE(track_.bridge_end());
  const BridgeEnd& end = *track_.bridge_end();
  EXPECT_NEAR(end.length, 60.4, 0.3);
  EXPECT_GE(end.count, 9);
  const Eigen::Vector2d off_W = Eigen::Rotation2Dd(end.yaw) * end.off_H;  // bridged less true
  EXPECT_NEAR((off_W + current_W.head<2>()).norm(), 0.0, 0.01);
  EXPECT_GT(end.variance_H.minCoeff(), 0.0);
}

/// As the gate judges it: a velocity that a dropout ends with is believed after a second, and
/// proves false when another one comes that is as before.
TEST_F(OdometryTrackTest, WhatADropoutEndedWithAndWasFalseSaysNothingOfItsBridge) {
  const Eigen::Vector3d false_B(0.7, -0.9, 0.0), true_B(kSpeed, 0.0, 0.0);
  const auto velocity_at = [&](double t) -> std::optional<Eigen::Vector3d> {
    if (t < 60.0) return true_B;
    if (t < 91.0) return std::nullopt;  // of the last second all were refused
    if (t < 93.0) return false_B;
    if (t < 93.6) return std::nullopt;  // the truth, not believed yet
    return true_B;
  };
  for (int i = 0; i <= 2200; ++i) {
    const double t = 0.05 * i;
    track_.AddAttitude({.t = t, .yaw = 0.3});
    if (i % 4 != 0) continue;
    const auto v_B = velocity_at(t);
    const auto before = velocity_at(t - 0.2);
    track_.AddVelocity(t, v_B);
    if (v_B && !before) track_.BelieveContested();
    if (v_B && before && t > 93.6) track_.ForgetContested();
  }
  ASSERT_TRUE(track_.bridge_end());
  EXPECT_FALSE(track_.bridge_end()->is_open);
  EXPECT_GE(track_.bridge_end()->count, 9);
  EXPECT_GT(track_.bridge_end()->length, 30.0);
  EXPECT_NEAR(track_.bridge_end()->off_H.norm(), 0.0, 0.02);
}

TEST_F(OdometryTrackTest, CatchesUpWithWhatItDidNotBelieveAtFirst) {
  Drive(0.0, 20.0);
  Drive(20.0, 26.0, false);
  for (int i = 0; i < 30; ++i)  // as the gate says of every velocity meanwhile
    track_.NoteContested(20.0 + 0.2 * i, v_dvl_ + Eigen::Vector3d(0.3, 0.0, 0.0));
  const OdometryStep before = track_.Between({25.0, 25.9});
  track_.BelieveContested();
  const OdometryStep after = track_.Between({25.0, 25.9}), whole = track_.Between({25.0, 25.95});
  EXPECT_LT((after.motion - before.motion).norm(), 1e-9);
  const double caught_up = (whole.motion - after.motion).head<2>().norm();
  EXPECT_GT(caught_up, 0.5);  // a curve of 0.3 m/s over six seconds
  EXPECT_GT(whole.variance(0), 0.05 * caught_up * caught_up);
  Drive(26.0, 27.0);
  EXPECT_LT(track_.Between({26.0, 26.9}).motion.head<2>().norm(), 0.5);
}

TEST_F(OdometryTrackTest, AFalseVelocityThatEndedLeavesNothingBehind) {
  Drive(0.0, 20.0);
  track_.NoteContested(19.8, v_dvl_ + Eigen::Vector3d(1.0, 0.0, 0.0));
  const OdometryStep before = track_.Between({10.0, 19.9});
  track_.ForgetContested();
  track_.BelieveContested();
  EXPECT_EQ(before.motion, track_.Between({10.0, 19.9}).motion);
}

TEST(OdometryTrack, ADvlOfOneHertzHasNoDropout) {
  OdometryTrack track{OdometryParams{}};
  for (int i = 0; i <= 600; ++i) {
    track.AddAttitude({.t = 0.05 * i});
    if (i % 20 == 0) track.AddVelocity(0.05 * i, Eigen::Vector3d(0.5, 0.0, 0.0));
  }
  EXPECT_FALSE(track.DropoutAge(30.9));
  EXPECT_TRUE(track.DropoutAge(33.0));
}

TEST_F(OdometryTrackTest, BridgesADropoutAndSaysHowUnsureItIs) {
  Drive(0.0, 20.0);
  const double sure = track_.Between({10.0, 20.0}).variance(0);
  Drive(20.0, 30.0, false);
  const OdometryStep step = track_.Between({0.0, 29.0});
  EXPECT_NEAR((step.motion.head<2>() - OnCircle(29.0)).norm(), 0.0, 2e-2);
  EXPECT_GT(track_.Between({19.0, 29.0}).variance(0), 5.0 * sure);
}

TEST_F(OdometryTrackTest, AVelocityFarFromTheUsualOneIsNotHeldForLong) {
  Drive(0.0, 120.0);
  for (double t = 120.05; t < 121.0; t += 0.2)
    track_.AddVelocity(t, Eigen::Vector3d::Zero());
  track_.AddVelocity(121.1, std::nullopt);
  Drive(121.2, 150.0, false);
  EXPECT_GT(track_.At(149.0).v_B.x(), 0.5 * kSpeed);
}

/// Turns one way and the other, 20 s each, and slips 0.2 m/s per rad/s outwards.
TEST_F(OdometryTrackTest, ADropoutInTurnsIsBridgedWithWhatTurningDoes) {
  constexpr double kSlip = -0.2;
  const Eigen::Vector3d arm = OdometryParams{}.dvl_B;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_at_dropout = p;
  double yaw = 0.0;
  for (int i = 0; i < 6600; ++i) {
    const double t = 0.05 * i;
    const double rate = 0.15 * std::sin(t * 0.157);
    yaw += 0.05 * rate;
    const Eigen::Vector3d v(kSpeed, kSlip * rate, 0.0);
    AttitudeEstimate attitude;
    attitude.t = t, attitude.yaw = WrapAngle(yaw);
    track_.AddAttitude(attitude);
    if (i % 4 == 0) {
      const Eigen::Vector3d v_dvl = v + Eigen::Vector3d(0.0, 0.0, rate).cross(arm);
      track_.AddVelocity(t, t < 300.0 ? std::optional(v_dvl) : std::nullopt);
    }
    p += 0.05 * (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * v);
    if (i == 6000) p_at_dropout = p;
  }
  const Eigen::Vector3d moved = track_.At(329.9).X_DB.p_WB - track_.At(300.0).X_DB.p_WB;
  EXPECT_NEAR((moved - (p - p_at_dropout)).norm(), 0.0, 0.15) << "of 15 m";
}

TEST_F(OdometryTrackTest, InADropoutAVehicleUnderWayMayHaveStopped) {
  Drive(0.0, 120.0);
  EXPECT_EQ(track_.At(119.9).stop_covariance_D.trace(), 0.0);
  Drive(120.0, 160.0, false);
  // On a circle of 5 m no stop puts it further off than that.
  const Eigen::Matrix2d S = track_.At(159.9).stop_covariance_D;
  EXPECT_GT(std::sqrt(S.trace()), 0.25);
  EXPECT_LT(std::sqrt(S.trace()), 0.75);
  Drive(160.0, 161.0);
  EXPECT_EQ(track_.At(160.9).stop_covariance_D.trace(), 0.0) << "its velocity tells";
}

TEST_F(OdometryTrackTest, SinksAtTheGivenRateInADropout) {
  Drive(0.0, 20.0);
  EXPECT_FALSE(track_.DropoutAge(track_.last_time()));
  track_.SetSinkRate(0.1);
  Drive(20.0, 30.0, false);
  EXPECT_NEAR(track_.Between({22.0, 29.0}).motion(2), 0.7, 1e-6);
  EXPECT_NEAR(track_.At(29.0).v_B.z(), 0.1, 1e-6);
  EXPECT_NEAR(track_.DropoutAge(29.0).value(), 9.2, 0.05);
}

TEST_F(OdometryTrackTest, ChangesOfSpeedBetweenSamplesAreInterpolated) {
  for (int i = 0; i <= 100; ++i) {
    AttitudeEstimate attitude;
    attitude.t = 0.05 * i;
    track_.AddAttitude(attitude);
    if (i % 10 == 0) track_.AddVelocity(attitude.t, Eigen::Vector3d(0.1 * attitude.t, 0.0, 0.0));
  }
  EXPECT_NEAR(track_.Between({0.0, 5.0}).motion(0), 0.05 * 25.0, 1e-9);
}

TEST_F(OdometryTrackTest, ExtrapolatesToThePresentButNotFar) {
  Drive(0.0, 10.0);
  const double last = track_.last_time();
  EXPECT_NEAR(track_.Between({last, last + 0.2}).path, 0.2 * v_dvl_.norm(), 1e-3);
  EXPECT_LT(track_.Between({last, last + 100.0}).path, 0.2);
}

TEST_F(OdometryTrackTest, ForgetsOldSamples) {
  Drive(0.0, 20.0);
  track_.DropBefore(15.0);
  EXPECT_GT(track_.first_time(), 14.0);
  EXPECT_NEAR(track_.Between({16.0, 18.0}).path, 2.0 * v_dvl_.norm(), 1e-3);
}

}  // namespace
}  // namespace limpet

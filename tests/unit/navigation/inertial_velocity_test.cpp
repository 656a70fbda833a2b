// SPDX-License-Identifier: MIT
#include "estimation/navigation/inertial_velocity.hpp"

#include <optional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "estimation/navigation/measurement_buffer.hpp"

namespace limpet {
namespace {

const Eigen::Vector3d kCruise(0.5, 0.0, 0.0), kRest(0.0, 0.0, -9.81);
constexpr double kPeriod = 0.02;  // [s] of the accelerometer

Eigen::Matrix3d Turned(double yaw) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

TEST(InertialVelocity, FeelsACollision) {
  InertialVelocity felt;
  double t = 0.0;
  for (; t < 1.0; t += kPeriod)
    felt.AddForce(t, kRest, Turned(0.7));
  felt.Believe(0.95, kCruise, Turned(0.7));
  for (; t < 1.2; t += kPeriod)
    felt.AddForce(t, kRest + Eigen::Vector3d(-2.5, 0.0, 0.0), Turned(0.7));
  const auto now = felt.At(1.18, Turned(0.7));
  ASSERT_TRUE(now);
  EXPECT_LT((*now - Eigen::Vector3d(0.05, 0.0, 0.0)).norm(), 0.04);
}

TEST(InertialVelocity, TurnsWithTheVehicle) {
  InertialVelocity felt;
  for (double t = 0.0; t < 1.0; t += kPeriod)
    felt.AddForce(t, kRest, Turned(0.0));
  felt.Believe(0.5, kCruise, Turned(0.0));
  const auto now = felt.At(0.9, Turned(0.5 * M_PI));
  ASSERT_TRUE(now);
  EXPECT_LT((*now - Eigen::Vector3d(0.0, -0.5, 0.0)).norm(), 1e-6);
}

TEST(InertialVelocity, KnowsNothingLongAfterOrWhenForcesWereMissing) {
  InertialVelocity felt;
  for (double t = 0.0; t < 3.0; t += kPeriod)
    felt.AddForce(t, kRest, Turned(0.0));
  felt.Believe(1.0, kCruise, Turned(0.0));
  EXPECT_TRUE(felt.At(2.0, Turned(0.0)));
  EXPECT_FALSE(felt.At(2.9, Turned(0.0)));
  felt.Believe(2.9, kCruise, Turned(0.0));
  felt.AddForce(3.5, kRest, Turned(0.0));
  EXPECT_FALSE(felt.At(3.5, Turned(0.0)));
}

/// A cruise at 5 pings a second, whose velocity changes at 10 s by so much each.
class JumpTest : public ::testing::Test {
 protected:
  void Fly(const Eigen::Vector3d& felt_B, const Eigen::Vector3d& said_B, double seconds) {
    for (; t_ < seconds; t_ += kPeriod) {
      buffer_.AddAttitude({.t = t_});
      const double jumping = t_ > 10.0 && t_ <= 10.1 ? 1.0 : 0.0, later = t_ > 10.0 ? 1.0 : 0.0;
      buffer_.AddSpecificForce(t_, kRest + jumping * felt_B / 0.1);
      if (++samples_ % 10 == 0) buffer_.AddVelocity(t_, Eigen::Vector3d(kCruise + later * said_B));
    }
  }
  const Eigen::Vector3d kNothing = Eigen::Vector3d::Zero();
  MeasurementBuffer buffer_{OdometryParams{}, VelocityGateParams{}, Meters(0.015)};
  double t_ = 0.0;
  int samples_ = 0;
};

TEST_F(JumpTest, OfTheVehicleIsFollowedAtOnceWhenItWasFelt) {
  const Eigen::Vector3d jump(-0.45, 0.3, 0.0);
  Fly(jump, jump, 11.0);
  EXPECT_LT((buffer_.track().At(10.9).v_B - (kCruise + jump)).norm(), 0.02);
  EXPECT_LE(buffer_.counts().velocities, 1);
}

TEST_F(JumpTest, OfTheInstrumentAloneIsNotFollowedHoweverLongItLasts) {
  Fly(kNothing, {-0.45, 0.3, 0.0}, 40.0);
  EXPECT_LT((buffer_.track().At(39.9).v_B - kCruise).norm(), 0.05);
}

}  // namespace
}  // namespace limpet

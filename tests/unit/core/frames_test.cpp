// SPDX-License-Identifier: MIT
#include "limpet/core/frames.hpp"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"

namespace limpet {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(WrapAngle, StaysInTheHalfOpenTurnAndKeepsTheAngle) {
  Random random(1, "angles");
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.Uniform(-100.0, 100.0);
    const double wrapped = WrapAngle(angle);
    EXPECT_GT(wrapped, -kPi);
    EXPECT_LE(wrapped, kPi);
    EXPECT_NEAR(std::remainder(angle - wrapped, 2.0 * kPi), 0.0, 1e-12);
  }
}

TEST(WrapAngle, PutsTheCutAtPlusPi) {
  EXPECT_DOUBLE_EQ(WrapAngle(kPi), kPi);
  EXPECT_DOUBLE_EQ(WrapAngle(-kPi), kPi);
  EXPECT_DOUBLE_EQ(WrapAngle(3.0 * kPi), kPi);
  EXPECT_DOUBLE_EQ(WrapAngle(-1e-16), -1e-16);
}

TEST(MoosHeading, MatchesHandComputedDirections) {
  EXPECT_DOUBLE_EQ(MoosHeadingFromYaw(0.0), 0.0);
  EXPECT_DOUBLE_EQ(MoosHeadingFromYaw(kPi / 2.0), 90.0);
  EXPECT_DOUBLE_EQ(MoosHeadingFromYaw(-kPi / 2.0), 270.0);
  EXPECT_DOUBLE_EQ(MoosHeadingFromYaw(kPi), 180.0);
}

TEST(MoosHeading, NeverReaches360) {
  EXPECT_LT(MoosHeadingFromYaw(-1e-18), 360.0);
  EXPECT_GE(MoosHeadingFromYaw(-1e-18), 0.0);
}

TEST(MoosHeading, RoundTrips) {
  Random random(2, "yaws");
  for (int i = 0; i < 1000; ++i) {
    const double yaw = random.Uniform(-kPi, kPi);
    EXPECT_NEAR(WrapAngle(YawFromMoosHeading(MoosHeadingFromYaw(yaw)) - yaw), 0.0, 1e-12);
  }
}

TEST(MoosPose, PutsEastOnXAndNorthOnY) {
  const MoosPose moos = MoosFromNed({1.0, 2.0, 3.0}, kPi);  // heading south
  EXPECT_EQ(moos.x, 2.0);
  EXPECT_EQ(moos.y, 1.0);
  EXPECT_EQ(moos.depth, 3.0);
  EXPECT_DOUBLE_EQ(moos.heading_deg, 180.0);
  EXPECT_NEAR(moos.yaw, -kPi / 2.0, 1e-12) << "as MOOS's simulator publishes for heading 180";
}

TEST(MoosPose, RoundTrips) {
  Random random(3, "poses");
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d p_WB(random.Uniform(-9, 9), random.Uniform(-9, 9), random.Uniform(0, 9));
    const double yaw = random.Uniform(-kPi, kPi);
    const MoosPose moos = MoosFromNed(p_WB, yaw);
    EXPECT_EQ(Eigen::Vector3d(moos.y, moos.x, moos.depth), p_WB);
    EXPECT_NEAR(WrapAngle(YawFromMoosHeading(moos.heading_deg) - yaw), 0.0, 1e-12);
  }
}

TEST(Rotation, TurnsTheNoseEastAtYawNinety) {
  const Eigen::Vector3d nose =
      RotationFromRollPitchYaw(0.0, 0.0, kPi / 2.0) * Eigen::Vector3d::UnitX();
  EXPECT_TRUE(nose.isApprox(Eigen::Vector3d::UnitY(), 1e-12));
}

TEST(Rotation, LiftsTheNoseAtPositivePitch) {
  const Eigen::Vector3d nose = RotationFromRollPitchYaw(0.0, 0.5, 0.0) * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(nose.z(), -std::sin(0.5), 1e-12);
}

TEST(Rotation, IsProperAndRoundTrips) {
  Random random(4, "rotations");
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d angles(random.Uniform(-kPi, kPi), random.Uniform(-1.5, 1.5),
                                 random.Uniform(-kPi, kPi));
    const Eigen::Matrix3d R_WB = RotationFromRollPitchYaw(angles.x(), angles.y(), angles.z());
    EXPECT_TRUE((R_WB * R_WB.transpose()).isIdentity(1e-12));
    EXPECT_NEAR(R_WB.determinant(), 1.0, 1e-12);
    EXPECT_TRUE(RollPitchYawFromRotation(R_WB).isApprox(angles, 1e-9));
  }
}

TEST(Units, KeepDegreesAtTheEdge) {
  EXPECT_NEAR(Radians::FromTextUnit(180.0).value(), kPi, 1e-15);
  EXPECT_DOUBLE_EQ(Radians(kPi).in_text_unit(), 180.0);
  EXPECT_DOUBLE_EQ(Meters(3.0).in_text_unit(), 3.0);
}

TEST(Units, MultiplySpeedByTimeToLength) {
  EXPECT_EQ(MetersPerSecond(0.5) * Seconds(4.0), Meters(2.0));
  EXPECT_DOUBLE_EQ(Meters(6.0) / Meters(3.0), 2.0);
}

}  // namespace
}  // namespace limpet

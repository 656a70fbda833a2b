// SPDX-License-Identifier: MIT
#include "estimation/attitude/attitude_filter.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kPeriod = 0.02;

/// What ideal sensors say in a steady attitude at constant body velocity and yaw rate.
InertialInput Steady(double t, double roll, double pitch, double yaw, double yaw_rate = 0.0,
                     const Eigen::Vector3d& v_B = Eigen::Vector3d::Zero()) {
  const Eigen::Matrix3d R = RotationFromRollPitchYaw(roll, pitch, yaw);
  const Eigen::Vector3d rate = R.transpose() * Eigen::Vector3d(0.0, 0.0, yaw_rate);
  return {.t = t,
          .force_B = R.transpose() * Eigen::Vector3d(0.0, 0.0, -9.81) + rate.cross(v_B),
          .rate_B = rate,
          .heading = yaw};
}

void Feed(AttitudeFilter& filter, double until, double roll, double pitch, double yaw) {
  const double start = filter.estimate() ? filter.estimate()->t : 0.0;
  for (double t = start + kPeriod; t < until; t += kPeriod) {
    const InertialInput input = Steady(t, roll, pitch, yaw);
    filter.AddFogRate(t, RadiansPerSecond(input.rate_B.z()));
    filter.AddInertial(input);
  }
}

TEST(AttitudeFilter, FindsTheTiltOfAVehicleAtRest) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 10.0, 0.1, -0.05, 1.0);
  EXPECT_NEAR(filter.estimate()->roll, 0.1, 1e-3);
  EXPECT_NEAR(filter.estimate()->pitch, -0.05, 1e-3);
}

TEST(AttitudeFilter, AveragesTheHeadingOverTheAlignment) {
  Random random(1);
  AttitudeFilter filter{AttitudeParams{}};
  for (double t = 0.0; t < 6.0; t += kPeriod) {
    InertialInput input = Steady(t, 0.0, 0.0, 3.1);
    input.heading += random.Normal(0.05);
    filter.AddInertial(input);
  }
  EXPECT_TRUE(filter.is_aligned());
  EXPECT_NEAR(WrapAngle(filter.estimate()->yaw - 3.1), 0.0, 0.01);
}

TEST(AttitudeFilter, KeepsItsHeadingWhenTheCompassIsDisturbedLater) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 6.0, 0.0, 0.0, 0.5);
  for (double t = 6.0; t < 20.0; t += kPeriod) {
    InertialInput input = Steady(t, 0.0, 0.0, 0.5);
    input.heading = 1.5;
    filter.AddInertial(input);
  }
  EXPECT_NEAR(filter.estimate()->yaw, 0.5, 1e-6);
}

TEST(AttitudeFilter, FindsItsHeadingAgainAfterAGapInWhichTheVehicleTurned) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 20.0, 0.0, 0.0, 0.5);
  // What was held up comes first, all at once.
  for (int i = 0; i < 300; ++i) {
    filter.AddInertial(Steady(26.0 + 1e-4 * i, 0.0, 0.0, 0.5 + 2.0 * i / 300.0));
  }
  EXPECT_TRUE(filter.is_aligned());
  Feed(filter, 40.0, 0.0, 0.0, 2.5);
  EXPECT_NEAR(filter.estimate()->yaw, 2.5, 0.02);
}

TEST(AttitudeFilter, TurnsTheBodyRateIntoAYawRateThroughRollAndPitch) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 6.0, 0.2, 0.0, 0.0);
  double yaw = 0.0;
  for (double t = 6.0; t < 16.0; t += kPeriod) {
    const InertialInput input = Steady(t, 0.2, 0.0, yaw, 0.1);
    filter.AddFogRate(t, RadiansPerSecond(input.rate_B.z()));
    filter.AddInertial(input);
    yaw += 0.1 * kPeriod;
  }
  EXPECT_NEAR(filter.estimate()->yaw_rate, 0.1, 2e-3);
  EXPECT_NEAR(filter.estimate()->yaw, 1.0, 0.01);
}

TEST(AttitudeFilter, StaysLevelInALongTurnWhenItKnowsTheSpeed) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 6.0, 0.0, 0.0, 0.0);
  const Eigen::Vector3d v_B(0.5, 0.0, 0.0);
  filter.SetBodyVelocity(v_B);
  for (double t = 6.0; t < 60.0; t += kPeriod) {
    filter.AddInertial(Steady(t, 0.0, 0.0, 0.167 * t, 0.167, v_B));
  }
  EXPECT_NEAR(filter.estimate()->roll, 0.0, 1e-3);
}

TEST(AttitudeFilter, LearnsTheBiasOfTheGyros) {
  AttitudeFilter filter{AttitudeParams{}};
  for (double t = 0.0; t < 300.0; t += kPeriod) {
    InertialInput input = Steady(t, 0.0, 0.0, 0.0);
    input.rate_B.x() += 0.003;
    filter.AddInertial(input);
  }
  EXPECT_NEAR(filter.gyro_bias().x(), 0.003, 5e-4);
  EXPECT_NEAR(filter.estimate()->roll, 0.0, 2e-3);
}

TEST(AttitudeFilter, DoesNotTakeABumpForATilt) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 10.0, 0.0, 0.0, 0.0);
  for (double t = 10.0; t < 11.0; t += kPeriod) {
    InertialInput input = Steady(t, 0.0, 0.0, 0.0);
    input.force_B.y() += 5.0;
    filter.AddInertial(input);
  }
  EXPECT_NEAR(filter.estimate()->roll, 0.0, 1e-3);
}

TEST(AttitudeFilter, DropsSamplesThatAreNotNumbersOrComeFromThePast) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 1.0, 0.0, 0.0, 0.0);
  const double t = filter.estimate()->t;
  InertialInput broken = Steady(2.0, 0.0, 0.0, 0.0);
  broken.force_B.x() = std::nan("");
  filter.AddInertial(broken);
  filter.AddInertial(Steady(0.5, 1.0, 0.0, 0.0));
  EXPECT_EQ(filter.estimate()->t, t);
}

TEST(AttitudeFilter, RefusesAndCountsWhatGoesBackInTime) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 10.0, 0.0, 0.0, 0.5);
  EXPECT_FALSE(filter.AddInertial(Steady(9.0, 0.0, 0.0, 2.0, 5.0)));
  EXPECT_FALSE(filter.AddInertial(Steady(std::nan(""), 0.0, 0.0, 2.0)));
  EXPECT_EQ(filter.refused(), 2);
  EXPECT_NEAR(filter.estimate()->yaw, 0.5, 1e-6);
}

TEST(AttitudeFilter, ALeapOfTheClockThatOneSampleShowsStopsNothing) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 10.0, 0.0, 0.0, 0.5);
  EXPECT_FALSE(filter.AddInertial(Steady(3610.0, 0.0, 0.0, 0.5)));
  EXPECT_TRUE(filter.AddInertial(Steady(10.02, 0.0, 0.0, 0.5)));
}

TEST(AttitudeFilter, ALeapThatStaysIsBelieved) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 10.0, 0.0, 0.0, 0.5);
  for (int i = 0; i < 3; ++i) {
    static_cast<void>(filter.AddInertial(Steady(3610.0 + kPeriod * i, 0.0, 0.0, 0.5)));
  }
  EXPECT_NEAR(filter.estimate()->t, 3610.04, 1e-9);
}

TEST(AttitudeFilter, FindsItsHeadingAgainAfterItsClockWasSetBackWhileTheVehicleTurned) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 10.0, 0.0, 0.0, 0.5);
  for (double t = 9.0; t < 30.0; t += kPeriod) {  // it has turned to 0.9 in the second it missed
    static_cast<void>(filter.AddInertial(Steady(t, 0.0, 0.0, 0.9)));
  }
  EXPECT_NEAR(filter.estimate()->yaw, 0.9, 0.01);
  EXPECT_EQ(filter.refused(), 50);
}

/// A sample of which the line has made anything.
InertialInput Garbled(double t, Random& random) {
  InertialInput input{.t = t};
  for (int axis = 0; axis < 3; ++axis) {
    input.rate_B(axis) = random.Uniform(-4.0, 4.0);
    input.force_B(axis) = random.Uniform(-40.0, 40.0);
  }
  input.heading = random.Uniform(-3.0, 3.0);
  return input;
}

TEST(AttitudeFilter, KeepsItsAttitudeWhileEveryThirdSampleIsAnOutlier) {
  Random random(7);
  AttitudeFilter filter{AttitudeParams{}};
  int garbled = 0, mistaken = 0;
  for (double t = 0.0; t < 60.0; t += kPeriod) {
    const bool is_garbled = t > 0.1 && random.Uniform(0.0, 1.0) < 0.33;
    garbled += is_garbled ? 1 : 0;
    const bool is_taken =
        filter.AddInertial(is_garbled ? Garbled(t, random) : Steady(t, 0.1, -0.05, 1.0));
    mistaken += is_taken == is_garbled ? 1 : 0;
  }
  EXPECT_GT(garbled, 900);
  EXPECT_LE(mistaken, 2);  // one in some thousands is near enough by chance
  EXPECT_NEAR(filter.outliers(), garbled, 2.0);
  EXPECT_NEAR(filter.estimate()->roll, 0.1, 0.02);
  EXPECT_NEAR(filter.estimate()->pitch, -0.05, 0.02);
  EXPECT_NEAR(filter.estimate()->yaw, 1.0, 0.02);
}

TEST(AttitudeFilter, StartsAnewIfItsFirstSampleWasAnOutlier) {
  Random random(8);
  AttitudeFilter filter{AttitudeParams{}};
  filter.AddInertial(Garbled(0.0, random));
  Feed(filter, 1.0, 0.1, -0.05, 1.0);
  EXPECT_NEAR(filter.estimate()->roll, 0.1, 1e-3);
  EXPECT_NEAR(filter.estimate()->pitch, -0.05, 1e-3);
  EXPECT_NEAR(filter.estimate()->yaw, 1.0, 1e-3);
}

TEST(AttitudeFilter, BelievesABlowThatLasts) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 10.0, 0.0, 0.0, 0.0);
  for (double t = 10.0; t < 11.0; t += kPeriod) {
    filter.AddInertial(Steady(t, 0.0, 0.0, 0.0, 1.0));
  }
  EXPECT_NEAR(filter.estimate()->yaw_rate, 1.0, 1e-6);
}

TEST(AttitudeFilter, SaysWhichHeadingIsAnOutlierThoughTheMotionIsNone) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 10.0, 0.0, 0.0, 0.0);
  EXPECT_TRUE(filter.has_heading());
  EXPECT_TRUE(filter.AddInertial(Steady(10.0, 0.0, 0.0, 2.0)));
  EXPECT_FALSE(filter.has_heading());
  EXPECT_TRUE(filter.AddInertial(Steady(10.02, 0.0, 0.0, 0.0)));
  EXPECT_TRUE(filter.has_heading());
}

TEST(AttitudeFilter, TakesNoGyroRateOfAnotherTime) {
  AttitudeFilter filter{AttitudeParams{}};
  Feed(filter, 10.0, 0.0, 0.0, 0.5);
  filter.AddFogRate(3610.0, RadiansPerSecond(1.0));
  for (double t = 10.0; t < 12.0; t += kPeriod) {
    static_cast<void>(filter.AddInertial(Steady(t, 0.0, 0.0, 0.5)));
  }
  EXPECT_NEAR(filter.estimate()->yaw, 0.5, 1e-3);
}

}  // namespace
}  // namespace limpet

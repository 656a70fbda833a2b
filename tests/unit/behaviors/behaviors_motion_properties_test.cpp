// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "behaviors/BHV_ConstantDepth.hpp"
#include "behaviors/BHV_FollowPath.hpp"
#include "behaviors/BHV_HoldAltitude.hpp"
#include "behaviors/BHV_HoldStation.hpp"
#include "behaviors/BHV_OpRegion.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

VehicleState Above(double time, double down, double altitude) {
  VehicleState state;
  state.now = Seconds(time);
  state.nav.down = down;
  state.nav.altitude = altitude;
  return state;
}

TEST(HoldAltitude, AsksForTheSeabedLessItsAltitudeWhereverTheVehicleIs) {
  Random random(1, "altitude");
  for (int run = 0; run < 200; ++run) {
    BHV_HoldAltitude::Params params;
    params.altitude = Meters(random.Uniform(1.0, 8.0));
    BHV_HoldAltitude behavior(params);
    const double seabed = random.Uniform(9.0, 60.0), down = random.Uniform(0.0, seabed - 0.5);
    behavior.Start(Above(0.0, down, seabed - down));
    const MotionBid bid = behavior.Move(Above(0.0, down, seabed - down));
    EXPECT_NEAR(bid.depth->summit, seabed - params.altitude.value(), 1e-9);
    EXPECT_FALSE(bid.course || bid.speed) << "where to is not its business";
  }
}

TEST(HoldAltitude, AveragesASeabedThatAnObjectInterrupts) {
  BHV_HoldAltitude behavior({});
  behavior.Start(Above(0.0, 4.0, 4.0));
  double highest = 1e9;
  for (int i = 0; i <= 200; ++i) {
    const double time = 0.1 * i;
    // One beam meets an object of a metre for half a second.
    const double altitude = time > 5.0 && time <= 5.5 ? 3.0 : 4.0;
    highest = std::min(highest, behavior.Move(Above(time, 4.0, altitude)).depth->summit);
  }
  EXPECT_GT(highest, 4.0 - 0.25) << "half a second of two of smoothing is a fifth of the step";
  EXPECT_LT(highest, 4.0 - 0.15);
}

TEST(HoldAltitude, FollowsAStepOfTheSeabedWithItsTimeConstant) {
  BHV_HoldAltitude::Params params;
  params.smoothing = Seconds(3.0);
  BHV_HoldAltitude behavior(params);
  behavior.Start(Above(0.0, 2.0, 8.0));
  static_cast<void>(behavior.Move(Above(0.0, 2.0, 8.0)));
  double summit = 0.0;
  for (int i = 1; i <= 30; ++i) {
    summit = behavior.Move(Above(0.1 * i, 2.0, 18.0)).depth->summit;
  }
  EXPECT_NEAR(summit, 6.0 + 10.0 * (1.0 - std::exp(-1.0)), 1e-6);
}

TEST(HoldAltitude, DoesNotCareHowOftenItIsAsked) {
  Random random(2, "rates");
  for (int run = 0; run < 50; ++run) {
    BHV_HoldAltitude slow({}), fast({});
    slow.Start(Above(0.0, 3.0, 5.0));
    fast.Start(Above(0.0, 3.0, 5.0));
    static_cast<void>(slow.Move(Above(0.0, 3.0, 5.0)));
    static_cast<void>(fast.Move(Above(0.0, 3.0, 5.0)));
    const double altitude = random.Uniform(3.0, 9.0);
    for (int i = 1; i < 20; ++i)
      static_cast<void>(fast.Move(Above(0.1 * i, 3.0, altitude)));
    EXPECT_NEAR(slow.Move(Above(2.0, 3.0, altitude)).depth->summit,
                fast.Move(Above(2.0, 3.0, altitude)).depth->summit, 1e-9);
  }
}

TEST(HoldAltitude, ForgetsTheSeabedOfBeforeAnIdleSpell) {
  BHV_HoldAltitude behavior({});
  behavior.Start(Above(0.0, 3.0, 5.0));
  static_cast<void>(behavior.Move(Above(0.0, 3.0, 5.0)));
  VehicleState blind;
  blind.now = Seconds(1.0);
  behavior.Start(blind);
  EXPECT_FALSE(behavior.Move(blind).depth);
}

TEST(FollowPath, TurnsAsTheGuidanceSaysAtItsOwnSpeed) {
  Random random(3, "guidance");
  for (int run = 0; run < 100; ++run) {
    BHV_FollowPath::Params params;
    params.speed = MetersPerSecond(random.Uniform(0.1, 2.0));
    BHV_FollowPath behavior(params);
    VehicleState state;
    state.guidance =
        Guidance{.course = random.Uniform(-3.1, 3.1), .turn_rate = random.Uniform(-0.3, 0.3)};
    const MotionBid bid = behavior.Move(state);
    EXPECT_EQ(bid.course->summit, state.guidance->course);
    EXPECT_EQ(*bid.turn_rate, state.guidance->turn_rate);
    EXPECT_EQ(bid.speed->summit, params.speed.value());
    EXPECT_FALSE(bid.depth);
  }
}

TEST(ConstantDepth, FallsFromItsFlatTopToNothingOverItsBase) {
  BHV_ConstantDepth::Params params;
  params.depth = Meters(5.0);
  params.peakwidth = Meters(0.5);
  params.basewidth = Meters(2.0);
  params.summit_delta = 0.0;
  const Peak peak = *BHV_ConstantDepth(params).Move({}).depth;
  EXPECT_EQ(PeakValue(peak, 5.5 - peak.summit), 1.0);
  EXPECT_NEAR(PeakValue(peak, 6.5 - peak.summit), 0.5, 1e-12);
  EXPECT_NEAR(PeakValue(peak, 2.5 - peak.summit), 0.0, 1e-12);
}

/// A vehicle in a current, which goes where it is told as fast as it is told.
struct Drifter {
  VehicleState state;
  double north = 0.0, east = 0.0;
  void Tick(BHV_HoldStation& behavior, double current_north, double current_east) {
    const MotionBid bid = behavior.Move(state);
    const double yaw = bid.course->summit, speed = bid.speed->summit;
    const double v_north = speed * std::cos(yaw) + current_north;
    const double v_east = speed * std::sin(yaw) + current_east;
    state.nav.yaw = yaw;
    state.nav.u = v_north * std::cos(yaw) + v_east * std::sin(yaw);
    state.nav.v = -v_north * std::sin(yaw) + v_east * std::cos(yaw);
    north += 0.1 * v_north;
    east += 0.1 * v_east;
    state.now = state.now + Seconds(0.1);
  }
};

TEST(HoldStation, StaysNearWhereItBeganInAnyCurrentThatItCanStem) {
  Random random(4, "current");
  for (int run = 0; run < 40; ++run) {
    BHV_HoldStation behavior({});
    const double speed = random.Uniform(0.02, 0.2), set = random.Uniform(-3.1, 3.1);
    Drifter drifter;
    drifter.state.nav.yaw = random.Uniform(-3.1, 3.1);
    behavior.Start(drifter.state);
    double farthest = 0.0;
    for (int i = 0; i < 3000; ++i) {
      drifter.Tick(behavior, speed * std::cos(set), speed * std::sin(set));
      farthest = std::max(farthest, std::hypot(drifter.north, drifter.east));
    }
    EXPECT_LT(farthest, 1.3) << "radius 1 m, current " << speed;
  }
}

TEST(HoldStation, GoesBackNoFasterThanItMay) {
  Random random(5, "speed");
  BHV_HoldStation::Params params;
  params.speed = MetersPerSecond(0.25);
  BHV_HoldStation behavior(params);
  VehicleState state;
  behavior.Start(state);
  for (int i = 0; i < 2000; ++i) {
    state.now = state.now + Seconds(0.1);
    state.nav.u = random.Uniform(-1.0, 1.0);
    state.nav.v = random.Uniform(-1.0, 1.0);
    state.nav.yaw = random.Uniform(-3.1, 3.1);
    const MotionBid bid = behavior.Move(state);
    EXPECT_GE(bid.speed->summit, 0.0);
    EXPECT_LE(bid.speed->summit, 0.25);
  }
}

TEST(HoldStation, DoesNotBelieveOneVelocityForAWholeSilence) {
  BHV_HoldStation behavior({});
  VehicleState state;
  behavior.Start(state);
  state.nav.u = 0.5;
  state.now = Seconds(60.0);
  EXPECT_EQ(behavior.Move(state).speed->summit, 0.0) << "60 s at 0.5 m/s were 30 m";
}

TEST(OpRegion, PullsToTheMiddleOnlyWhereNoPathLeadsBack) {
  Random random(6, "outside");
  for (int run = 0; run < 100; ++run) {
    BHV_OpRegion behavior({});
    VehicleState state;
    state.area = SurveyArea{-10.0, 10.0, -20.0, 20.0, 2.0, 2.0};
    behavior.Start(state);
    static_cast<void>(behavior.Move(state));  // inside: in force from now on
    const double bearing = random.Uniform(-3.1, 3.1);
    state.nav.north = 40.0 * std::cos(bearing);
    state.nav.east = 40.0 * std::sin(bearing);
    const MotionBid bid = behavior.Move(state);
    ASSERT_TRUE(bid.warning && bid.course);
    EXPECT_NEAR(WrapAngle(bid.course->summit - bearing - std::numbers::pi), 0.0, 1e-9);
    state.guidance = Guidance{.purpose = "beam"};
    EXPECT_FALSE(behavior.Move(state).course);
    EXPECT_TRUE(behavior.Move(state).warning);
  }
}

TEST(OpRegion, RaisesNoAlarmWithinItsTolerance) {
  BHV_OpRegion::Params params;
  params.tolerance = Meters(1.5);
  BHV_OpRegion behavior(params);
  VehicleState state;
  state.area = SurveyArea{-10.0, 10.0, -10.0, 10.0, 2.0, 2.0};
  behavior.Start(state);
  static_cast<void>(behavior.Move(state));
  for (const double beyond : {0.1, 0.7, 1.4, 1.6, 5.0}) {
    state.nav.north = 12.0 + beyond;
    EXPECT_EQ(behavior.Move(state).warning.has_value(), beyond > 1.5) << beyond;
  }
}

}  // namespace
}  // namespace limpet

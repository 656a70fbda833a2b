// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "behaviors/BHV_HoldAltitude.hpp"
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

TEST(BhvHoldAltitude, AsksForTheSeabedLessItsAltitudeWhereverTheVehicleIs) {
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

TEST(BhvHoldAltitude, AveragesASeabedThatAnObjectInterrupts) {
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

TEST(BhvHoldAltitude, FollowsAStepOfTheSeabedWithItsTimeConstant) {
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

TEST(BhvHoldAltitude, DoesNotCareHowOftenItIsAsked) {
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

TEST(BhvHoldAltitude, ForgetsTheSeabedOfBeforeAnIdleSpell) {
  BHV_HoldAltitude behavior({});
  behavior.Start(Above(0.0, 3.0, 5.0));
  static_cast<void>(behavior.Move(Above(0.0, 3.0, 5.0)));
  VehicleState blind;
  blind.now = Seconds(1.0);
  behavior.Start(blind);
  EXPECT_FALSE(behavior.Move(blind).depth);
}

}  // namespace
}  // namespace limpet

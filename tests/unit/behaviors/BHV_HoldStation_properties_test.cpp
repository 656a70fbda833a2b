// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "behaviors/BHV_HoldStation.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

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

TEST(BhvHoldStation, StaysNearWhereItBeganInAnyCurrentThatItCanStem) {
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

TEST(BhvHoldStation, GoesBackNoFasterThanItMay) {
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

TEST(BhvHoldStation, DoesNotBelieveOneVelocityForAWholeSilence) {
  BHV_HoldStation behavior({});
  VehicleState state;
  behavior.Start(state);
  state.nav.u = 0.5;
  state.now = Seconds(60.0);
  EXPECT_EQ(behavior.Move(state).speed->summit, 0.0) << "60 s at 0.5 m/s were 30 m";
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
// Each control law alone: signs, limits and what it forgets.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/control/depth_controller.hpp"
#include "limpet/control/drift_estimate.hpp"
#include "limpet/control/heading_controller.hpp"
#include "limpet/control/speed_controller.hpp"
#include "limpet/control/sway_controller.hpp"

namespace limpet {
namespace {

constexpr double kLawStep = 0.1;

Hydrodynamics Hydro() { return DeriveHydrodynamics(VehicleParams{}); }

double YawMoment(double yaw, double desired) {
  HeadingController heading({}, Hydro());
  HeadingController::Input input;
  input.yaw = yaw;
  input.desired_yaw = desired;
  return heading.Update(input, kLawStep, false);
}

TEST(HeadingController, TurnsTheShortWayAcrossSouth) {
  EXPECT_GT(YawMoment(3.0, -3.0), 0.0);
  EXPECT_LT(YawMoment(-3.0, 3.0), 0.0);
}

TEST(HeadingController, AsksForNoMoreThanItsGreatestTurnRate) {
  EXPECT_DOUBLE_EQ(YawMoment(0.0, 1.0), YawMoment(0.0, 2.0));
}

TEST(HeadingController, OnAnArcFlownPerfectlyAsksForItsDragAlone) {
  HeadingController heading({}, Hydro());
  HeadingController::Input input;
  input.yaw_rate = input.desired_turn_rate = 0.167;
  EXPECT_NEAR(heading.Update(input, kLawStep, false), DragForce(Hydro(), 5, 0.167), 1e-12);
}

TEST(IntegralTerm, StandsStillWhileThrustersSaturateButMayUnwind) {
  IntegralTerm integral(1.0, 10.0);
  const double before = integral.Update(1.0, 1.0, false);
  EXPECT_EQ(integral.Update(1.0, 1.0, true), before);
  EXPECT_LT(integral.Update(-0.5, 1.0, true), before);
}

TEST(IntegralTerm, StaysWithinItsLimit) {
  IntegralTerm integral(1.0, 2.0);
  for (int i = 0; i < 10; ++i)
    (void)integral.Update(1.0, 1.0, false);
  EXPECT_EQ(integral.value(), 2.0);
}

TEST(SpeedController, FeedsForwardTheDragOfASteadySpeed) {
  SpeedController speed({}, Hydro());
  speed.Reset(0.5);
  EXPECT_NEAR(speed.Force(speed.Lack({0.5, 0.5}, kLawStep), 0.0), DragForce(Hydro(), 0, 0.5),
              1e-12);
}

TEST(SpeedController, RampsUpInsteadOfJumping) {
  SpeedController speed({}, Hydro());
  speed.Reset(0.0);
  EXPECT_NEAR(speed.Lack({0.0, 1.0}, kLawStep), 0.025, 1e-12);
}

TEST(SwayController, PushesAgainstSideslipAndIntoATurn) {
  const SwayController sway({}, Hydro());
  SwayController::Input input;
  input.v = 0.1;
  EXPECT_LT(sway.Force(input), 0.0);
  input = {};
  input.u = 0.5;
  input.turn_rate = 0.167;
  EXPECT_GT(sway.Force(input), 3.0);
}

TEST(SwayController, HoldsAgainstACurrentFromTheSide) {
  const SwayController sway({}, Hydro());
  SwayController::Input input;
  input.current_v = 0.1;
  EXPECT_NEAR(sway.Force(input), -DragForce(Hydro(), 1, 0.1), 1e-12);
}

TEST(DriftEstimate, LearnsACurrentOnOneCourseAndKnowsItOnAnother) {
  DriftEstimate drift({});
  Eigen::Vector2d current_B = Eigen::Vector2d::Zero();
  for (int i = 0; i < 20; ++i) {  // heading north, pushed to starboard
    current_B = drift.Update(0.0, {0.0, -0.05}, kLawStep, false);
  }
  EXPECT_GT(current_B.y(), 0.02);
  const Eigen::Vector2d turned_B =
      drift.Update(std::numbers::pi / 2.0, Eigen::Vector2d::Zero(), kLawStep, false);
  EXPECT_NEAR(turned_B.x(), current_B.y(), 1e-12);  // heading east it runs along
}

TEST(DriftEstimate, DoesNotWindUpWhileThrustersSaturate) {
  DriftEstimate drift({});
  EXPECT_EQ(drift.Update(0.0, {1.0, 1.0}, kLawStep, true).norm(), 0.0);
}

TEST(DepthController, LeavesTheVehicleToItsBuoyancyAtTheSurface) {
  DepthController depth({}, Hydro());
  EXPECT_EQ(depth.Update({.depth = 0.13, .depth_rate = 0.0, .desired_depth = 0.0}, kLawStep, false),
            0.0);
}

TEST(DepthController, HoldsTheNetBuoyancyDownAtDepth) {
  DepthController depth({}, Hydro());
  depth.Reset(3.0);
  EXPECT_NEAR(
      depth.Update({.depth = 3.0, .depth_rate = 0.0, .desired_depth = 3.0}, kLawStep, false),
      VehicleParams{}.net_buoyancy_n, 1e-9);
}

TEST(DepthController, AsksForNoLeapWhenTheWantedDepthJumps) {
  DepthController depth({}, Hydro());
  depth.Reset(3.0);
  const double force =
      depth.Update({.depth = 3.0, .depth_rate = 0.0, .desired_depth = 13.0}, kLawStep, false);
  EXPECT_LT(force, 20.0);
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/navigation/driven_speed.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const DriveParams kHull{.mass_B = {40.0, 60.0},
                        .linear_drag_B = {4.0, 10.0},
                        .quadratic_drag_B = {32.0, 100.0},
                        .command_lasts = Seconds(1.0)};

/// The same force and turn, commanded ten times a second until `end` [s].
DrivenSpeed Driven(const Eigen::Vector2d& force_B, double yaw_rate, double end) {
  DrivenSpeed driven(kHull);
  for (double t = 0.0; t < end; t += 0.1)
    driven.AddForce(t, force_B, yaw_rate);
  return driven;
}

TEST(DrivenSpeed, KnowsNothingBeforeACommand) {
  EXPECT_FALSE(DrivenSpeed(kHull).At(3.0).has_value());
}

TEST(DrivenSpeed, SettlesWhereDragBalancesThrust) {
  const double ahead = 4.0 * 0.5 + 32.0 * 0.25, abeam = -(10.0 * 0.2 + 100.0 * 0.04);
  const Eigen::Vector2d v_B = *Driven({ahead, abeam}, 0.0, 60.0).At(60.0);
  EXPECT_NEAR(v_B.x(), 0.5, 1e-3);
  EXPECT_NEAR(v_B.y(), -0.2, 1e-3);
}

TEST(DrivenSpeed, TakesTimeToGainSpeed) {
  const DrivenSpeed driven = Driven({10.0, 0.0}, 0.0, 20.0);
  EXPECT_NEAR(driven.At(0.5)->x(), 0.5 * 10.0 / 40.0, 0.01);
  EXPECT_LT(driven.At(1.0)->x(), 0.8 * driven.At(10.0)->x());
}

TEST(DrivenSpeed, IsThatOfTheForceWhichThrustersMakeOfACommand) {
  DriveParams with_thrusters = kHull;
  with_thrusters.full_thrust_B = FullThrust::Zero();
  with_thrusters.full_thrust_B->col(0) = Eigen::Vector2d(20.0, 4.0);
  with_thrusters.full_thrust_B->col(7) = Eigen::Vector2d(10.0, -4.0);
  DrivenSpeed commanded(with_thrusters), forced(kHull);
  commanded.AddCommand({.t = 0.0, .shares = {0.5, 0, 0, 0, 0, 0, 0, 3.0}}, 0.0);
  forced.AddForce(0.0, {20.0, -2.0}, 0.0);
  EXPECT_EQ(commanded.At(1.0), forced.At(1.0)) << "none pushes more than all";
  DrivenSpeed unknown(kHull);
  unknown.AddCommand({.t = 0.0, .shares = {1.0}}, 0.0);
  EXPECT_FALSE(unknown.At(1.0).has_value()) << "nobody says what they push";
}

TEST(DrivenSpeed, StopsWhenCommandsCease) {
  const DrivenSpeed driven = Driven({10.0, 0.0}, 0.0, 30.0);
  EXPECT_NEAR(driven.At(30.9)->x(), driven.At(29.9)->x(), 1e-3)
      << "the last command lasts a second";
  EXPECT_LT(driven.At(120.0)->x(), 0.05);
}

TEST(DrivenSpeed, ATurnCarriesTheSpeedAbeam) {
  // Without thrust and drag the momentum stays where it points in the world.
  DriveParams free_hull = kHull;
  free_hull.linear_drag_B.setZero();
  free_hull.quadratic_drag_B.setZero();
  free_hull.mass_B = {40.0, 40.0};
  free_hull.command_lasts = Seconds(100.0);
  DrivenSpeed driven(free_hull);
  driven.AddForce(0.0, {40.0, 0.0}, 0.0);
  for (double t = 1.0; t < 11.0; t += 0.1)
    driven.AddForce(t, {0.0, 0.0}, 0.1);
  const Eigen::Vector2d v_B = *driven.At(11.0);
  EXPECT_NEAR(v_B.x(), std::cos(1.0), 0.02);
  EXPECT_NEAR(v_B.y(), -std::sin(1.0), 0.02);
}

TEST(DrivenSpeed, ForgettingThePastChangesNothingOfThePresent) {
  DrivenSpeed driven = Driven({8.0, 2.0}, 0.1, 40.0);
  const Eigen::Vector2d before = *driven.At(40.0);
  driven.DropBefore(35.0);
  EXPECT_EQ(*driven.At(40.0), before);
}

TEST(DrivenSpeed, WhatIsNoNumberOrLateIsLeftOut) {
  DrivenSpeed driven = Driven({8.0, 0.0}, 0.0, 10.0);
  const Eigen::Vector2d before = *driven.At(10.0);
  driven.AddForce(5.0, {-30.0, 0.0}, 0.0);
  driven.AddForce(9.95, {std::nan(""), 0.0}, 0.0);
  EXPECT_EQ(*driven.At(10.0), before);
}

}  // namespace
}  // namespace limpet

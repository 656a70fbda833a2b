// SPDX-License-Identifier: MIT
#include "limpet/control/thrust_allocation.hpp"

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

Wrench Wanted(double surge, double sway, double heave, double pitch, double yaw) {
  Wrench wanted;
  wanted << surge, sway, heave, 0.0, pitch, yaw;
  return wanted;
}

TEST(ThrustAllocation, MakesExactlyTheWantedForcesWhileNothingSaturates) {
  const ThrustAllocation allocation{ThrusterLayout{}};
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    const Wrench wanted =
        Wanted(random.Uniform(-6.0, 6.0), random.Uniform(-6.0, 6.0), random.Uniform(-8.0, 8.0),
               random.Uniform(-1.0, 1.0), random.Uniform(-1.5, 1.5));
    const auto result = allocation.Allocate(wanted);
    EXPECT_FALSE(result.is_saturated);
    EXPECT_LT((result.achieved - wanted).norm(), 1e-9);
  }
}

TEST(ThrustAllocation, NeverAsksMoreThanAThrusterCanGive) {
  const ThrustAllocation allocation{ThrusterLayout{}};
  const auto result = allocation.Allocate(Wanted(500.0, -300.0, 200.0, 40.0, -90.0));
  EXPECT_LE(result.command.cwiseAbs().maxCoeff(), 1.0 + 1e-12);
  EXPECT_TRUE(result.is_saturated);
}

TEST(ThrustAllocation, KeepsYawAndHeaveWhenSurgeAsksForEverything) {
  const ThrustAllocation allocation{ThrusterLayout{}};
  const auto result = allocation.Allocate(Wanted(200.0, 0.0, 15.0, 0.0, 5.0));
  EXPECT_NEAR(result.achieved(5), 5.0, 1e-9);
  EXPECT_NEAR(result.achieved(2), 15.0, 1e-9);
  EXPECT_LT(result.achieved(0), 30.0);
}

TEST(ThrustAllocation, KeepsTheDirectionOfAHorizontalForceThatIsTooGreat) {
  const ThrustAllocation allocation{ThrusterLayout{}};
  const auto result = allocation.Allocate(Wanted(100.0, 50.0, 0.0, 0.0, 0.0));
  EXPECT_NEAR(result.achieved(1) / result.achieved(0), 0.5, 1e-9);
}

TEST(ThrustAllocation, SparesAnExpensiveThruster) {
  ThrusterVector price = ThrusterVector::Ones();
  price(0) = 100.0;
  const ThrustAllocation allocation{ThrusterLayout{}, price};
  const auto even = ThrustAllocation{ThrusterLayout{}}.Allocate(Wanted(10, 0, 0, 0, 2));
  const auto spared = allocation.Allocate(Wanted(10, 0, 0, 0, 2));
  EXPECT_LT(std::abs(spared.command(0)), std::abs(even.command(0)) + 1e-12);
  EXPECT_NEAR(spared.achieved(5), 2.0, 1e-9);
}

/// As on a BlueROV2: the vertical pair stands side by side.
ThrusterLayout WithoutPitch() {
  ThrusterLayout layout;
  layout.thrusters[4].p_B = {0.0, 0.1, 0.0};
  layout.thrusters[5].p_B = {0.0, -0.1, 0.0};
  return layout;
}

TEST(ThrustAllocation, MakesEverythingElseWhereNoThrusterPitches) {
  const ThrustAllocation allocation{WithoutPitch()};
  const auto result = allocation.Allocate(Wanted(5.0, -2.0, 3.0, 1.0, 0.5));
  EXPECT_NEAR(result.achieved(0), 5.0, 1e-9);
  EXPECT_NEAR(result.achieved(1), -2.0, 1e-9);
  EXPECT_NEAR(result.achieved(2), 3.0, 1e-9);
  EXPECT_NEAR(result.achieved(3), 0.0, 1e-9) << "both vertical thrusters push alike";
  EXPECT_NEAR(result.achieved(5), 0.5, 1e-9);
}

TEST(ThrusterLayout, KnowsWhatItCannotDo) {
  EXPECT_EQ(ThrusterLayout{}.ControlledAxes(), (std::vector<int>{0, 1, 2, 4, 5}));
  EXPECT_EQ(WithoutPitch().ControlledAxes(), (std::vector<int>{0, 1, 2, 5}));
  ThrusterLayout flat;
  flat.thrusters[4].axis_B = flat.thrusters[5].axis_B = {1.0, 0.0, 0.0};
  EXPECT_TRUE(flat.ControlledAxes().empty()) << "nothing pushes it down";
}

}  // namespace
}  // namespace limpet

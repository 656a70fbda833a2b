// SPDX-License-Identifier: MIT
#include "estimation/navigation/velocity_gate.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const Eigen::Vector3d kCruise(0.5, 0.0, 0.0);

TEST(VelocityGate, RefusesAJumpThatNoVehicleMakes) {
  VelocityGate gate{VelocityGateParams{}};
  EXPECT_TRUE(gate.Accepts(0.0, kCruise));
  EXPECT_FALSE(gate.Accepts(0.2, kCruise + Eigen::Vector3d(0.0, 1.0, 0.0)));
  EXPECT_TRUE(gate.Accepts(0.4, kCruise));
}

TEST(VelocityGate, TakesANewVelocityAfterADropoutOnceASecondSampleConfirmsIt) {
  VelocityGate gate{VelocityGateParams{}};
  EXPECT_TRUE(gate.Accepts(0.0, kCruise));
  EXPECT_FALSE(gate.Accepts(60.0, -kCruise));
  EXPECT_TRUE(gate.Accepts(60.2, -kCruise));
}

TEST(VelocityGate, TakesNoOutlierForTheTruthAtADropoutsEnd) {
  VelocityGate gate{VelocityGateParams{}};
  EXPECT_TRUE(gate.Accepts(0.0, kCruise));
  EXPECT_FALSE(gate.Accepts(60.0, kCruise + Eigen::Vector3d(1.8, 0.0, 0.0)));
  EXPECT_TRUE(gate.Accepts(60.2, kCruise));
}

TEST(VelocityGate, AWrongFirstSampleDoesNotLockItForEver) {
  VelocityGate gate{VelocityGateParams{}};
  EXPECT_TRUE(gate.Accepts(0.0, Eigen::Vector3d(3.0, 0.0, 0.0)));
  double t = 0.0;
  while (!gate.Accepts(t += 0.2, kCruise)) {
    ASSERT_LT(t, 30.0);
  }
  EXPECT_TRUE(gate.Accepts(t + 0.2, kCruise));
}

TEST(VelocityGate, RefusesWhatIsNoNumber) {
  VelocityGate gate{VelocityGateParams{}};
  EXPECT_FALSE(gate.Accepts(0.0, Eigen::Vector3d(std::nan(""), 0.0, 0.0)));
}

}  // namespace
}  // namespace limpet

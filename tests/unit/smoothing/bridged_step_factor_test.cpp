// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/bridged_step_factor.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/smoothing/step_factor_fixture.hpp"

namespace limpet {
namespace {

using BridgedStepFactorTest = StepFactorTest;

TEST_F(BridgedStepFactorTest, IsZeroWhenCurrentAndSpeedWereOffByTheError) {
  // Two seconds heading east: ahead is east, abeam is south.
  const NavVector from = (NavVector() << 0.0, 0.0, 0.0, M_PI_2, 0.0, 0.0).finished();
  const NavVector to = (NavVector() << 0.2, 1.0, 0.0, M_PI_2, 0.0, 0.0).finished();
  const Eigen::Vector3d error(0.1, -0.05, 0.2);  // current north, east, speed ahead
  const Eigen::Vector4d motion(1.0 + 2.0 * (-0.05 + 0.2), -0.2 - 2.0 * 0.1, 0.0, 0.0);
  const BridgedStepFactor factor(motion, Eigen::Vector4d::Ones(), 2.0);
  EXPECT_NEAR(factor.Evaluate(from, to, error).norm(), 0.0, 1e-12);
}

TEST_F(BridgedStepFactorTest, JacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(BridgedStepFactor({0.5, 0.1, 0.0, 0.5}, variance_, 1.2), {0.1, -0.2, 0.3});
}

}  // namespace
}  // namespace limpet

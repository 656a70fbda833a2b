// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/bridge_end_factor.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(BridgeEndFactor, IsZeroWhenTheEndShowsWhatTheBridgeWasOff) {
  const Eigen::Vector3d error(0.1, -0.05, 0.2);
  const double heading = M_PI_2;  // ahead is east, abeam is south
  const BridgeEndFactor factor({-0.05 + 0.2, -0.1}, {0.01, 0.04}, heading);
  EXPECT_NEAR(factor.Evaluate(error).norm(), 0.0, 1e-12);
}

TEST(BridgeEndFactor, JacobianMatchesCentralDifferences) {
  const BridgeEndFactor factor({0.1, 0.05}, {0.01, 0.04}, 0.7);
  const Eigen::Vector3d error(0.1, -0.05, 0.2);
  BridgeEndFactor::BorderJacobian J;
  static_cast<void>(factor.Evaluate(error, &J));
  constexpr double kStep = 1e-6;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Vector3d change = kStep * Eigen::Vector3d::Unit(i);
    const Eigen::Vector2d slope =
        (factor.Evaluate(error + change) - factor.Evaluate(error - change)) / (2.0 * kStep);
    EXPECT_NEAR((J.col(i) - slope).norm(), 0.0, 1e-6);
  }
}

}  // namespace
}  // namespace limpet

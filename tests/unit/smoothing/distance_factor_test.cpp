// SPDX-License-Identifier: MIT
#include "tests/support/distance_factor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/landmark_factor_fixture.hpp"

namespace limpet {
namespace {

using namespace literals;

using DistanceFactorTest = LandmarkFactorTest;

TEST_F(DistanceFactorTest, IsZeroAtTheTruth) {
  const DistanceFactor factor(Meters((p_W_ - x_.head<3>()).norm()), 0.1_m);
  EXPECT_NEAR(factor.Evaluate(x_, p_W_).norm(), 0.0, 1e-12);
}
TEST_F(DistanceFactorTest, JacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(DistanceFactor(3.0_m, 0.5_m));
}
TEST_F(DistanceFactorTest, HasNoDerivativeWhereBothCoincide) {
  DistanceFactor::BorderJacobian J;
  EXPECT_NEAR(DistanceFactor(3.0_m, 0.5_m).Evaluate(x_, x_.head<3>(), nullptr, &J)(0), -6.0, 1e-12);
  EXPECT_EQ(J.norm(), 0.0);
}

}  // namespace
}  // namespace limpet

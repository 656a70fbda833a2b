// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/depth_factor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/pose_factor_checks.hpp"

namespace limpet {
namespace {

using namespace literals;

TEST(DepthFactor, IsZeroAtTheTruth) {
  EXPECT_NEAR(DepthFactor(4.0_m, 0.1_m).Evaluate(SomePose()).norm(), 0.0, 1e-12);
}
TEST(DepthFactor, JacobianMatchesCentralDifferences) {
  ExpectJacobianMatches(DepthFactor(3.0_m, 0.1_m), SomePose());
}

}  // namespace
}  // namespace limpet

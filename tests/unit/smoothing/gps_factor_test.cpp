// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/gps_factor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/pose_factor_checks.hpp"

namespace limpet {
namespace {

using namespace literals;

TEST(GpsFactor, IsZeroAtTheTruth) {
  EXPECT_NEAR(GpsFactor({3.0, -2.0}, 0.5_m).Evaluate(SomePose()).norm(), 0.0, 1e-12);
}
TEST(GpsFactor, JacobianMatchesCentralDifferences) {
  ExpectJacobianMatches(GpsFactor({1.0, 1.0}, 0.5_m), SomePose());
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/roll_pitch_factor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/pose_factor_checks.hpp"

namespace limpet {
namespace {

using namespace literals;

TEST(RollPitchFactor, IsZeroAtTheTruth) {
  const RollPitchFactor factor(Radians(-0.2), Radians(0.1), 1.0_deg);
  EXPECT_NEAR(factor.Evaluate(SomePose()).norm(), 0.0, 1e-12);
}
TEST(RollPitchFactor, JacobianMatchesCentralDifferences) {
  ExpectJacobianMatches(RollPitchFactor(Radians(0.0), Radians(0.0), 1.0_deg), SomePose());
}

}  // namespace
}  // namespace limpet

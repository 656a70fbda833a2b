// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/pose_prior_factor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/pose_factor_checks.hpp"

namespace limpet {
namespace {

TEST(PosePriorFactor, IsZeroAtTheTruthAlsoAWholeTurnAway) {
  NavVector turned = SomePose();
  turned(kNavYaw) += 2.0 * M_PI;
  const PosePriorFactor factor(SomePose(), NavVector::Constant(0.5));
  EXPECT_NEAR(factor.Evaluate(turned).norm(), 0.0, 1e-9);
}
TEST(PosePriorFactor, JacobianMatchesCentralDifferences) {
  ExpectJacobianMatches(PosePriorFactor(NavVector::Zero(), NavVector::Constant(0.5)), SomePose());
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/birthplace_factor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/landmark_factor_fixture.hpp"

namespace limpet {
namespace {

using namespace literals;

using BirthplaceFactorTest = LandmarkFactorTest;

TEST_F(BirthplaceFactorTest, IsZeroWhereverPoseAndLandmarkAreTogether) {
  const BirthplaceFactor factor(p_W_ - x_.head<3>(), 3.0_m);
  NavVector moved = x_;
  moved.head<3>() += Eigen::Vector3d(5.0, -4.0, 1.0);
  const Eigen::Vector3d p_moved = p_W_ + Eigen::Vector3d(5.0, -4.0, 1.0);
  EXPECT_NEAR(factor.Evaluate(moved, p_moved).norm(), 0.0, 1e-12);
}
TEST_F(BirthplaceFactorTest, JacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(BirthplaceFactor({1.0, 2.0, 3.0}, 3.0_m));
}

}  // namespace
}  // namespace limpet

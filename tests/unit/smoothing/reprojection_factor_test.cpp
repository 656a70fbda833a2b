// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/reprojection_factor.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "tests/unit/smoothing/landmark_factor_fixture.hpp"

namespace limpet {
namespace {

using ReprojectionFactorTest = LandmarkFactorTest;

TEST_F(ReprojectionFactorTest, IsZeroAtTheTruth) {
  const Eigen::Vector3d p = InCamera();
  const Eigen::Vector2d pixel(camera_.cx + camera_.fx * p.x() / p.z(),
                              camera_.cy + camera_.fy * p.y() / p.z());
  const ReprojectionFactor factor(camera_, pixel, {2.0, 3.0});
  EXPECT_NEAR(factor.Evaluate(x_, p_W_).norm(), 0.0, 1e-9);
}
TEST_F(ReprojectionFactorTest, JacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(ReprojectionFactor(camera_, {300.0, 200.0}, {2.0, 3.0}));
}
TEST_F(ReprojectionFactorTest, IgnoresAnAxisThatTheBorderCuts) {
  const double unused = std::numeric_limits<double>::infinity();
  const ReprojectionFactor factor(camera_, {0.0, 200.0}, {unused, 3.0});
  ReprojectionFactor::Jacobian J;
  EXPECT_EQ(factor.Evaluate(x_, p_W_, &J)(0), 0.0);
  EXPECT_EQ(J.row(0).norm(), 0.0);
}
TEST_F(ReprojectionFactorTest, BehindTheCameraIsLargeAndFlat) {
  const ReprojectionFactor factor(camera_, {300.0, 200.0}, {2.0, 2.0});
  ReprojectionFactor::Jacobian J;
  EXPECT_GT(factor.Evaluate(x_, {3.0, -2.0, -5.0}, &J).norm(), 100.0);
  EXPECT_EQ(J.norm(), 0.0);
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/cut_axis_factor.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/smoothing/landmark_factor_fixture.hpp"

namespace limpet {
namespace {

using namespace literals;

using CutAxisFactorTest = LandmarkFactorTest;

constexpr double kBorder_px = 0.0, kFar_px = 480.0;

TEST_F(CutAxisFactorTest, IsZeroForTheTangentToTheSphereThatGoesOnAtTheBorder) {
  const Eigen::Vector3d p = InCamera();
  const double half = std::asin(0.5 / std::hypot(p.y(), p.z()));
  const double tangent = camera_.cy + camera_.fy * std::tan(std::atan2(p.y(), p.z()) - half);
  const CutAxisFactor inside(
      camera_, 0.5_m, {.axis = 1, .box = {.low = tangent, .high = tangent, .is_high_cut = true}});
  EXPECT_NEAR(inside.Evaluate(x_, p_W_).norm(), 0.0, 1e-9);
}
TEST_F(CutAxisFactorTest, PullsASphereThatEndsWithinTheImageToTheBorderThatCutIt) {
  const CutAxisFactor factor(
      camera_, 0.5_m, {.axis = 1, .box = {.low = 100.0, .high = kFar_px, .is_high_cut = true}});
  EXPECT_LT(factor.Evaluate(x_, p_W_)(1), -1.0);
  const CutAxisFactor as_seen(
      camera_, 0.5_m,
      {.axis = 1,
       .box = {.low = kBorder_px, .high = kFar_px, .is_low_cut = true, .is_high_cut = true}});
  EXPECT_GT(as_seen.Evaluate(x_, p_W_)(0), 1.0) << "also at the other";
}
TEST_F(CutAxisFactorTest, JacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(CutAxisFactor(camera_, 0.5_m, {.axis = 0, .sigma_px = 3.0}));
  ExpectJacobiansMatch(CutAxisFactor(camera_, 0.5_m, {.axis = 1, .sigma_px = 3.0}));
  ExpectJacobiansMatch(CutAxisFactor(
      camera_, 0.5_m, {.axis = 1, .box = {.high = kFar_px, .is_high_cut = true}, .sigma_px = 3.0}));
}
TEST_F(CutAxisFactorTest, IsLargeAndFlatInsideTheSphere) {
  const CutAxisFactor factor(camera_, 9.0_m,
                             {.axis = 0, .box = {.is_low_cut = true}, .sigma_px = 3.0});
  CutAxisFactor::Jacobian J;
  const CutAxisFactor::Residual r = factor.Evaluate(x_, p_W_, &J);
  EXPECT_EQ(r(0), 0.0) << "from within it goes on everywhere";
  EXPECT_GT(r(1), 100.0);
  EXPECT_EQ(J.norm(), 0.0);
}

}  // namespace
}  // namespace limpet

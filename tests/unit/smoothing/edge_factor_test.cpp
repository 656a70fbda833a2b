// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/edge_factor.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/smoothing/landmark_factor_fixture.hpp"

namespace limpet {
namespace {

using namespace literals;

using EdgeFactorTest = LandmarkFactorTest;

TEST_F(EdgeFactorTest, IsZeroForTheTangentToTheSphere) {
  const Eigen::Vector3d p = InCamera();
  const double half = std::asin(0.5 / std::hypot(p.y(), p.z()));
  const double tangent = camera_.cy + camera_.fy * std::tan(std::atan2(p.y(), p.z()) - half);
  const EdgeFactor factor(camera_, 0.5_m, {.axis = 1, .side = -1, .measured_px = tangent});
  EXPECT_NEAR(factor.Evaluate(x_, p_W_)(0), 0.0, 1e-9);
}
TEST_F(EdgeFactorTest, JacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(EdgeFactor(camera_, 0.5_m, {.axis = 0, .side = 1, .sigma_px = 3.0}));
  ExpectJacobiansMatch(EdgeFactor(camera_, 0.5_m, {.axis = 1, .side = -1, .sigma_px = 3.0}));
}
TEST_F(EdgeFactorTest, IsLargeAndFlatInsideTheSphere) {
  const EdgeFactor factor(camera_, 9.0_m, {.axis = 0, .side = 1, .sigma_px = 3.0});
  EdgeFactor::Jacobian J;
  EXPECT_GT(factor.Evaluate(x_, p_W_, &J)(0), 100.0);
  EXPECT_EQ(J.norm(), 0.0);
}

}  // namespace
}  // namespace limpet

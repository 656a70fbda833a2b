// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/border_prior_factor.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "tests/unit/smoothing/landmark_factor_fixture.hpp"
#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {
namespace {

using BorderPriorFactorTest = LandmarkFactorTest;

TEST_F(BorderPriorFactorTest, WeighsByItsCovariance) {
  Eigen::Matrix3d covariance;
  covariance << 0.5, 0.1, 0.0, 0.1, 0.4, 0.05, 0.0, 0.05, 0.3;
  const BorderPriorFactor factor({1.0, 2.0, 3.0}, covariance);
  EXPECT_NEAR(factor.Evaluate({1.0, 2.0, 3.0}).norm(), 0.0, 1e-12);
  const Eigen::Vector3d off(0.3, -0.2, 0.1);
  EXPECT_NEAR(factor.Evaluate(Eigen::Vector3d(1.0, 2.0, 3.0) + off).squaredNorm(),
              off.dot(covariance.inverse() * off), 1e-9);
}
TEST_F(BorderPriorFactorTest, JacobianMatchesCentralDifferences) {
  const BorderPriorFactor factor({1.0, 2.0, 3.0}, 0.2 * Eigen::Matrix3d::Identity());
  BorderPriorFactor::BorderJacobian J;
  const auto r = factor.Evaluate(p_W_, &J);
  EXPECT_GT(r.norm(), 0.0);
  const auto f = [&](const Eigen::Vector3d& p) { return Eigen::VectorXd(factor.Evaluate(p)); };
  EXPECT_LT((J - NumericJacobian(f, p_W_)).lpNorm<Eigen::Infinity>(), 1e-6);
}

}  // namespace
}  // namespace limpet

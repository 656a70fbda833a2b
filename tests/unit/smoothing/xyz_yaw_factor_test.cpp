// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/numeric_jacobian.hpp"
#include "tests/unit/smoothing/pose_factor_checks.hpp"

namespace limpet {
namespace {

class XyzYawFactorTest : public ::testing::Test {
 protected:
  const NavVector x_i_ = SomePose();
  const NavVector x_j_ = (NavVector() << 4.0, -1.5, 4.2, -3.0, 0.0, 0.1).finished();
  const Eigen::Vector4d variance_{0.01, 0.02, 0.04, 0.001};
};

TEST_F(XyzYawFactorTest, IsZeroForTheMotionSeenFromTheFirstPosesHeading) {
  const double c = std::cos(2.5), s = std::sin(2.5);
  const Eigen::Vector4d motion(c * 1.0 + s * 0.5, -s * 1.0 + c * 0.5, 0.2, 2.0 * M_PI - 5.5);
  EXPECT_NEAR(XyzYawFactor(motion, variance_).Evaluate(x_i_, x_j_).norm(), 0.0, 1e-9);
}
TEST_F(XyzYawFactorTest, JacobiansMatchCentralDifferences) {
  const XyzYawFactor factor({0.5, 0.1, 0.0, 0.5}, variance_);
  XyzYawFactor::Jacobian J_i, J_j;
  const auto r = factor.Evaluate(x_i_, x_j_, &J_i, &J_j);
  EXPECT_GT(r.norm(), 0.0);
  const auto of_i = [&](const NavVector& x) { return Eigen::VectorXd(factor.Evaluate(x, x_j_)); };
  const auto of_j = [&](const NavVector& x) { return Eigen::VectorXd(factor.Evaluate(x_i_, x)); };
  EXPECT_LT((J_i - NumericJacobian(of_i, x_i_)).lpNorm<Eigen::Infinity>(), 1e-5);
  EXPECT_LT((J_j - NumericJacobian(of_j, x_j_)).lpNorm<Eigen::Infinity>(), 1e-5);
}

}  // namespace
}  // namespace limpet

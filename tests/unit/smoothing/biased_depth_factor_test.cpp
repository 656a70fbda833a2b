// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/biased_depth_factor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/numeric_jacobian.hpp"
#include "tests/unit/smoothing/pose_factor_checks.hpp"

namespace limpet {
namespace {

using namespace literals;

const Eigen::Vector3d kDepthErrors(0.3, -0.1, 0.2), kShare(1.0, -0.5, 2.0);

TEST(BiasedDepthFactor, IsZeroAtTheTruth) {
  const BiasedDepthFactor factor(4.75_m, 0.1_m, kShare);
  EXPECT_NEAR(factor.Evaluate(SomePose(), kDepthErrors).norm(), 0.0, 1e-12);
}
TEST(BiasedDepthFactor, JacobianMatchesCentralDifferences) {
  const BiasedDepthFactor factor(3.0_m, 0.1_m, kShare);
  BiasedDepthFactor::Jacobian J_pose;
  BiasedDepthFactor::BorderJacobian J_errors;
  static_cast<void>(factor.Evaluate(SomePose(), kDepthErrors, &J_pose, &J_errors));
  const auto of_pose = [&](const NavVector& x) {
    return Eigen::VectorXd(factor.Evaluate(x, kDepthErrors));
  };
  const auto of_errors = [&](const Eigen::Vector3d& e) {
    return Eigen::VectorXd(factor.Evaluate(SomePose(), e));
  };
  EXPECT_LT((J_pose - NumericJacobian(of_pose, SomePose())).lpNorm<Eigen::Infinity>(), 1e-4);
  EXPECT_LT((J_errors - NumericJacobian(of_errors, kDepthErrors)).lpNorm<Eigen::Infinity>(), 1e-4);
}

}  // namespace
}  // namespace limpet

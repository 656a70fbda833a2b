// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/calibrated_step_factor.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/smoothing/numeric_jacobian.hpp"
#include "tests/unit/smoothing/step_factor_fixture.hpp"

namespace limpet {
namespace {

using CalibratedStepFactorTest = StepFactorTest;

TEST_F(CalibratedStepFactorTest, IsZeroWhenTheErrorsExplainTheMotion) {
  const NavVector from = NavVector::Zero();
  const NavVector to = (NavVector() << 2.0, 0.0, 0.0, 0.3, 0.0, 0.0).finished();
  // A velocity one percent too large, turned by 0.02 rad, and a gyro that runs at 0.001 rad/s.
  const Eigen::Vector4d measured(2.0 * 1.01, 2.0 * 0.02, 0.0, 0.3 + 0.004);
  const CalibratedStepFactor factor(measured, Eigen::Vector4d::Ones(), 4.0);
  EXPECT_LT(factor.Evaluate(from, to, {0.01, 0.02, 0.001}).norm(), 2e-3);
  EXPECT_GT(factor.Evaluate(from, to, Eigen::Vector3d::Zero()).norm(), 0.03);
}

TEST_F(CalibratedStepFactorTest, JacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(CalibratedStepFactor({0.5, 0.1, 0.0, 0.5}, variance_, 1.2),
                       {0.01, -0.02, 0.003});
}

TEST_F(CalibratedStepFactorTest, AMisplacedDvlSwingsInATurn) {
  // The DVL stays where it is while the vehicle turns about it: it sits 0.3 m ahead of the body's
  // origin, where the file says 0.
  const NavVector from = NavVector::Zero();
  NavVector to = NavVector::Zero();
  to(kNavYaw) = 0.5;
  to(kNavX) = 0.3 * (1.0 - std::cos(0.5));
  to(kNavY) = -0.3 * std::sin(0.5);
  const CalibratedStepFactor factor({0.0, 0.0, 0.0, 0.5 * 1.01}, Eigen::Vector4d::Ones(), 1.0);
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  EXPECT_LT(factor.Evaluate(from, to, none, Eigen::Vector3d(0.01, 0.3, 0.0)).norm(), 2e-3);
  EXPECT_GT(factor.Evaluate(from, to, none, none).norm(), 0.1);
}

TEST_F(CalibratedStepFactorTest, MountJacobiansMatchCentralDifferences) {
  const CalibratedStepFactor factor({0.5, 0.1, 0.0, 0.5}, variance_, 1.2);
  const Eigen::Vector3d errors(0.01, -0.02, 0.003), mount(0.002, 0.05, -0.04);
  CalibratedStepFactor::Jacobians J;
  static_cast<void>(factor.Evaluate(x_i_, x_j_, errors, mount, &J));
  const auto of_i = [&](const NavVector& x) {
    return Eigen::VectorXd(factor.Evaluate(x, x_j_, errors, mount));
  };
  const auto of_j = [&](const NavVector& x) {
    return Eigen::VectorXd(factor.Evaluate(x_i_, x, errors, mount));
  };
  const auto of_mount = [&](const Eigen::Vector3d& m) {
    return Eigen::VectorXd(factor.Evaluate(x_i_, x_j_, errors, m));
  };
  const auto of_errors = [&](const Eigen::Vector3d& e) {
    return Eigen::VectorXd(factor.Evaluate(x_i_, x_j_, e, mount));
  };
  EXPECT_LT((J.previous - NumericJacobian(of_i, x_i_)).lpNorm<Eigen::Infinity>(), 1e-5);
  EXPECT_LT((J.pose - NumericJacobian(of_j, x_j_)).lpNorm<Eigen::Infinity>(), 1e-5);
  EXPECT_LT((J.border[0] - NumericJacobian(of_errors, errors)).lpNorm<Eigen::Infinity>(), 1e-5);
  EXPECT_LT((J.border[1] - NumericJacobian(of_mount, mount)).lpNorm<Eigen::Infinity>(), 1e-5);
}

}  // namespace
}  // namespace limpet

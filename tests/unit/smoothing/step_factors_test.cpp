// SPDX-License-Identifier: MIT
// Steps of the dead reckoning whose sensors' errors are estimated too.
#include <cmath>

#include <gtest/gtest.h>

#include "estimation/smoothing/factors/bridge_end_factor.hpp"
#include "estimation/smoothing/factors/bridged_step_factor.hpp"
#include "estimation/smoothing/factors/calibrated_step_factor.hpp"
#include "estimation/smoothing/factors/slow_errors_factor.hpp"
#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {
namespace {

class StepFactorTest : public ::testing::Test {
 protected:
  template <class Factor>
  void ExpectJacobiansMatch(const Factor& factor, const Eigen::Vector3d& errors) const {
    typename Factor::Jacobian J_i, J_j;
    typename Factor::BorderJacobian J_errors;
    EXPECT_GT(factor.Evaluate(x_i_, x_j_, errors, &J_i, &J_j, &J_errors).norm(), 0.0);
    const auto of_i = [&](const NavVector& x) {
      return Eigen::VectorXd(factor.Evaluate(x, x_j_, errors));
    };
    const auto of_j = [&](const NavVector& x) {
      return Eigen::VectorXd(factor.Evaluate(x_i_, x, errors));
    };
    const auto of_errors = [&](const Eigen::Vector3d& e) {
      return Eigen::VectorXd(factor.Evaluate(x_i_, x_j_, e));
    };
    EXPECT_LT((J_i - NumericJacobian(of_i, x_i_)).template lpNorm<Eigen::Infinity>(), 1e-5);
    EXPECT_LT((J_j - NumericJacobian(of_j, x_j_)).template lpNorm<Eigen::Infinity>(), 1e-5);
    EXPECT_LT((J_errors - NumericJacobian(of_errors, errors)).template lpNorm<Eigen::Infinity>(),
              1e-5);
  }
  const NavVector x_i_ = (NavVector() << 3.0, -2.0, 4.0, 0.7, 0.1, -0.2).finished();
  const NavVector x_j_ = (NavVector() << 4.0, -1.5, 4.2, 0.9, 0.0, 0.1).finished();
  const Eigen::Vector4d variance_{0.01, 0.02, 0.04, 0.001};
};

TEST_F(StepFactorTest, CalibratedIsZeroWhenTheErrorsExplainTheMotion) {
  const NavVector from = NavVector::Zero();
  const NavVector to = (NavVector() << 2.0, 0.0, 0.0, 0.3, 0.0, 0.0).finished();
  // A velocity one percent too large, turned by 0.02 rad, and a gyro that runs at 0.001 rad/s.
  const Eigen::Vector4d measured(2.0 * 1.01, 2.0 * 0.02, 0.0, 0.3 + 0.004);
  const CalibratedStepFactor factor(measured, Eigen::Vector4d::Ones(), 4.0);
  EXPECT_LT(factor.Evaluate(from, to, {0.01, 0.02, 0.001}).norm(), 2e-3);
  EXPECT_GT(factor.Evaluate(from, to, Eigen::Vector3d::Zero()).norm(), 0.03);
}

TEST_F(StepFactorTest, CalibratedJacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(CalibratedStepFactor({0.5, 0.1, 0.0, 0.5}, variance_, 1.2),
                       {0.01, -0.02, 0.003});
}

TEST_F(StepFactorTest, AMisplacedDvlSwingsInATurn) {
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

TEST_F(StepFactorTest, MountJacobiansMatchCentralDifferences) {
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

TEST_F(StepFactorTest, BridgedIsZeroWhenCurrentAndSpeedWereOffByTheError) {
  // Two seconds heading east: ahead is east, abeam is south.
  const NavVector from = (NavVector() << 0.0, 0.0, 0.0, M_PI_2, 0.0, 0.0).finished();
  const NavVector to = (NavVector() << 0.2, 1.0, 0.0, M_PI_2, 0.0, 0.0).finished();
  const Eigen::Vector3d error(0.1, -0.05, 0.2);  // current north, east, speed ahead
  const Eigen::Vector4d motion(1.0 + 2.0 * (-0.05 + 0.2), -0.2 - 2.0 * 0.1, 0.0, 0.0);
  const BridgedStepFactor factor(motion, Eigen::Vector4d::Ones(), 2.0);
  EXPECT_NEAR(factor.Evaluate(from, to, error).norm(), 0.0, 1e-12);
}

TEST_F(StepFactorTest, BridgedJacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(BridgedStepFactor({0.5, 0.1, 0.0, 0.5}, variance_, 1.2), {0.1, -0.2, 0.3});
}

TEST(BridgeEndFactor, IsZeroWhenTheEndShowsWhatTheBridgeWasOff) {
  const Eigen::Vector3d error(0.1, -0.05, 0.2);
  const double heading = M_PI_2;  // ahead is east, abeam is south
  const BridgeEndFactor factor({-0.05 + 0.2, -0.1}, {0.01, 0.04}, heading);
  EXPECT_NEAR(factor.Evaluate(error).norm(), 0.0, 1e-12);
}

TEST(BridgeEndFactor, JacobianMatchesCentralDifferences) {
  const BridgeEndFactor factor({0.1, 0.05}, {0.01, 0.04}, 0.7);
  const Eigen::Vector3d error(0.1, -0.05, 0.2);
  BridgeEndFactor::BorderJacobian J;
  static_cast<void>(factor.Evaluate(error, &J));
  constexpr double kStep = 1e-6;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Vector3d change = kStep * Eigen::Vector3d::Unit(i);
    const Eigen::Vector2d slope =
        (factor.Evaluate(error + change) - factor.Evaluate(error - change)) / (2.0 * kStep);
    EXPECT_NEAR((J.col(i) - slope).norm(), 0.0, 1e-6);
  }
}

TEST(SlowErrorsFactor, IsZeroWhenTheErrorsFade) {
  const SlowErrorsFactor factor({1.0, 1.0, 0.5}, {0.1, 0.1, 0.1});
  EXPECT_NEAR(factor.Evaluate({0.2, 0.3, 0.4}, {0.2, 0.3, 0.2}).norm(), 0.0, 1e-12);
}

TEST(SlowErrorsFactor, JacobiansMatchCentralDifferences) {
  const SlowErrorsFactor factor({1.0, 0.9, 0.5}, {0.1, 0.2, 0.3});
  const Eigen::Vector3d a(0.2, 0.3, 0.4), b(0.1, 0.0, -0.2);
  Eigen::Matrix3d J_a, J_b;
  EXPECT_GT(factor.Evaluate(a, b, &J_a, &J_b).norm(), 0.0);
  const auto of_a = [&](const Eigen::Vector3d& v) {
    return Eigen::VectorXd(factor.Evaluate(v, b));
  };
  const auto of_b = [&](const Eigen::Vector3d& v) {
    return Eigen::VectorXd(factor.Evaluate(a, v));
  };
  EXPECT_LT((J_a - NumericJacobian(of_a, a)).lpNorm<Eigen::Infinity>(), 1e-6);
  EXPECT_LT((J_b - NumericJacobian(of_b, b)).lpNorm<Eigen::Infinity>(), 1e-6);
}

}  // namespace
}  // namespace limpet

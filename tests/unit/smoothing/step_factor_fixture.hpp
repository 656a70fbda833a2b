// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include "estimation/smoothing/factors/calibrated_step_factor.hpp"
#include "estimation/smoothing/nav_vector.hpp"
#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {

/// Steps of the dead reckoning whose sensors' errors are estimated too.
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

}  // namespace limpet

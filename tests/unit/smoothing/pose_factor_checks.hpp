// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include "estimation/smoothing/nav_vector.hpp"
#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {

/// Where factors of one pose are looked at.
inline NavVector SomePose() { return (NavVector() << 3.0, -2.0, 4.0, 2.5, 0.1, -0.2).finished(); }

/// The derivative by the pose is that of central differences.
template <class F>
void ExpectJacobianMatches(const F& factor, const NavVector& x) {
  typename F::Jacobian J;
  const auto ignored = factor.Evaluate(x, &J);
  static_cast<void>(ignored);
  const auto f = [&](const NavVector& at) { return Eigen::VectorXd(factor.Evaluate(at)); };
  EXPECT_LT((J - NumericJacobian(f, x)).template lpNorm<Eigen::Infinity>(), 1e-4);
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limpet {

/// Central differences of `f` at `x`.
template <class F, class Vector>
[[nodiscard]] Eigen::MatrixXd NumericJacobian(F f, const Vector& x) {
  constexpr double kStep = 1e-6;
  const Eigen::VectorXd r = f(x);
  Eigen::MatrixXd J(r.size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Vector low = x, high = x;
    low(i) -= kStep;
    high(i) += kStep;
    J.col(i) = (f(high) - f(low)) / (2.0 * kStep);
  }
  return J;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/same_place_factor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {
namespace {

using namespace literals;

TEST(SamePlaceFactor, IsZeroForTwoLandmarksAtOnePlace) {
  EXPECT_EQ(SamePlaceFactor(0.05_m).Evaluate({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}).norm(), 0.0);
}
TEST(SamePlaceFactor, JacobiansMatchCentralDifferences) {
  const SamePlaceFactor factor(0.05_m);
  const Eigen::Vector3d a(1.0, 2.0, 3.0), b(1.2, 1.9, 3.1);
  SamePlaceFactor::BorderJacobian J_a, J_b;
  EXPECT_NEAR(factor.Evaluate(a, b, &J_a, &J_b).norm(), (a - b).norm() / 0.05, 1e-9);
  const auto of_a = [&](const Eigen::Vector3d& p) {
    return Eigen::VectorXd(factor.Evaluate(p, b));
  };
  const auto of_b = [&](const Eigen::Vector3d& p) {
    return Eigen::VectorXd(factor.Evaluate(a, p));
  };
  EXPECT_LT((J_a - NumericJacobian(of_a, a)).lpNorm<Eigen::Infinity>(), 1e-6);
  EXPECT_LT((J_b - NumericJacobian(of_b, b)).lpNorm<Eigen::Infinity>(), 1e-6);
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/position_factor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/numeric_jacobian.hpp"
#include "tests/unit/smoothing/place_and_offset.hpp"

namespace limpet {
namespace {

TEST(PositionFactor, DerivesByPlaceAndByWhatAllFixesAreOffBy) {
  const PositionFactor factor({3.0, -3.5, 5.5}, {0.5, 0.8, 1.0});
  PositionFactor::Jacobian J;
  PositionFactor::BorderJacobian J_off;
  static_cast<void>(factor.Evaluate(kPlace, kOff, &J, &J_off));
  const auto by_place = [&](const NavVector& x) { return factor.Evaluate(x, kOff); };
  const auto by_off = [&](const Eigen::Vector3d& off) { return factor.Evaluate(kPlace, off); };
  EXPECT_LT((J - NumericJacobian(by_place, kPlace)).lpNorm<Eigen::Infinity>(), 1e-6);
  EXPECT_LT((J_off - NumericJacobian(by_off, kOff)).lpNorm<Eigen::Infinity>(), 1e-6);
}

TEST(PositionFactor, IsMetByAFixThatIsOffAsAllAre) {
  const PositionFactor factor(kPlace.head<3>() + kOff, {0.5, 0.8, 1.0});
  EXPECT_LT(factor.Evaluate(kPlace, kOff).norm(), 1e-12);
}

}  // namespace
}  // namespace limpet

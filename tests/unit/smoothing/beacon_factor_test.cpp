// SPDX-License-Identifier: MIT
#include "estimation/smoothing/factors/beacon_factor.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/numeric_jacobian.hpp"
#include "tests/unit/smoothing/place_and_offset.hpp"

namespace limpet {
namespace {

TEST(BeaconFactor, DerivesByPlaceHeadingAndWhereTheBeaconReallyIs) {
  const BeaconFactor factor({15.0, 40.0, 12.0}, {0.5, 0.2, -0.3}, Meters(40.0), Meters(0.5));
  BeaconFactor::Jacobian J;
  BeaconFactor::BorderJacobian J_off;
  static_cast<void>(factor.Evaluate(kPlace, kOff, &J, &J_off));
  const auto by_place = [&](const NavVector& x) { return factor.Evaluate(x, kOff); };
  const auto by_off = [&](const Eigen::Vector3d& off) { return factor.Evaluate(kPlace, off); };
  EXPECT_LT((J - NumericJacobian(by_place, kPlace)).leftCols<4>().lpNorm<Eigen::Infinity>(), 1e-6);
  EXPECT_LT((J_off - NumericJacobian(by_off, kOff)).lpNorm<Eigen::Infinity>(), 1e-6);
}

TEST(BeaconFactor, OfABeaconThatIsWhereItIsSaidToBeKnowsNoOffset) {
  const BeaconFactor factor({15.0, 40.0, 12.0}, Eigen::Vector3d::Zero(), Meters(40.0), Meters(0.5));
  EXPECT_DOUBLE_EQ(factor.Evaluate(kPlace)(0), factor.Evaluate(kPlace, {0.0, 0.0, 0.0})(0));
}

}  // namespace
}  // namespace limpet

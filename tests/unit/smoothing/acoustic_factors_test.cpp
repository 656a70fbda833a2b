// SPDX-License-Identifier: MIT
// Ranges to beacons and acoustic fixes, with what they are off by alike.
#include <gtest/gtest.h>

#include "estimation/smoothing/factors/beacon_factor.hpp"
#include "estimation/smoothing/factors/position_factor.hpp"
#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {
namespace {

const NavVector kPlace = (NavVector() << 3.0, -4.0, 5.0, 0.7, 0.0, 0.0).finished();
const Eigen::Vector3d kOff(0.4, -0.3, 0.2);

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

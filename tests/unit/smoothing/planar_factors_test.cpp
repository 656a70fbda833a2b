// SPDX-License-Identifier: MIT
// Factors of published planar sets: zero at the truth, Jacobians of central differences.
#include "tests/support/planar_factors.hpp"

#include <gtest/gtest.h>

#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {
namespace {

const NavVector kPlanarPose = (NavVector() << 3.0, -2.0, 0.3, 0.7, 0.1, -0.2).finished();
const Eigen::Vector3d kPlanarBlock(5.0, 1.5, 0.4);
const XyzYawFactor kPlanarEdge({0.5, 0.1, 0.0, 0.5}, {0.01, 0.02, 0.04, 0.001});

template <class F>
void ExpectPlanarJacobiansMatch(const F& factor) {
  typename F::Jacobian J_pose;
  typename F::BorderJacobian J_block;
  EXPECT_GT(factor.Evaluate(kPlanarPose, kPlanarBlock, &J_pose, &J_block).norm(), 0.0);
  const auto of_pose = [&](const NavVector& x) {
    return Eigen::VectorXd(factor.Evaluate(x, kPlanarBlock));
  };
  const auto of_block = [&](const Eigen::Vector3d& b) {
    return Eigen::VectorXd(factor.Evaluate(kPlanarPose, b));
  };
  EXPECT_LT((J_pose - NumericJacobian(of_pose, kPlanarPose)).template lpNorm<Eigen::Infinity>(),
            1e-4);
  EXPECT_LT((J_block - NumericJacobian(of_block, kPlanarBlock)).template lpNorm<Eigen::Infinity>(),
            1e-4);
}

TEST(PlaneFactor, JacobianMatchesCentralDifferences) {
  const PlaneFactor factor(0.1);
  PlaneFactor::Jacobian J;
  EXPECT_GT(factor.Evaluate(kPlanarPose, &J).norm(), 0.0);
  const auto f = [&](const NavVector& x) { return Eigen::VectorXd(factor.Evaluate(x)); };
  EXPECT_LT((J - NumericJacobian(f, kPlanarPose)).lpNorm<Eigen::Infinity>(), 1e-6);
}

TEST(BackwardFactor, IsTheStepSeenFromItsEnd) {
  const NavVector later = kPlanarPose + NavVector::Constant(0.1);
  const BackwardFactor backward(kPlanarEdge);
  XyzYawFactor::Jacobian J_i, J_j, J_later, J_earlier;
  const auto r = backward.Evaluate(kPlanarPose, later, &J_i, &J_j);
  EXPECT_EQ(r, kPlanarEdge.Evaluate(later, kPlanarPose, &J_later, &J_earlier));
  EXPECT_EQ(J_i, J_earlier);
  EXPECT_EQ(J_j, J_later);
}

TEST(PlaceFactor, IsZeroWhenTheBlockIsThePlaceOfThePose) {
  const PlaceFactor factor(0.001);
  EXPECT_NEAR(factor.Evaluate(kPlanarPose, {3.0, -2.0, 0.7 + 2.0 * M_PI}).norm(), 0.0, 1e-9);
}
TEST(PlaceFactor, JacobiansMatchCentralDifferences) {
  ExpectPlanarJacobiansMatch(PlaceFactor(0.1));
}

TEST(PlaceEdgeFactor, IsZeroWhenTheMotionIsMeasured) {
  NavVector place = NavVector::Zero();
  place(kNavX) = kPlanarBlock.x(), place(kNavY) = kPlanarBlock.y(),
  place(kNavYaw) = kPlanarBlock.z();
  NavVector pose = kPlanarPose;
  pose(kNavZ) = 0.0;
  const Eigen::Vector4d none = Eigen::Vector4d::Zero(), one = Eigen::Vector4d::Ones();
  const Eigen::Vector4d there = XyzYawFactor(none, one).Evaluate(pose, place);
  const Eigen::Vector4d back = XyzYawFactor(none, one).Evaluate(place, pose);
  const PlaceEdgeFactor to_place(XyzYawFactor(there, one), false);
  const PlaceEdgeFactor from_place(XyzYawFactor(back, one), true);
  EXPECT_NEAR(to_place.Evaluate(pose, kPlanarBlock).norm(), 0.0, 1e-12);
  EXPECT_NEAR(from_place.Evaluate(pose, kPlanarBlock).norm(), 0.0, 1e-12);
}
TEST(PlaceEdgeFactor, JacobiansMatchCentralDifferencesBothWays) {
  ExpectPlanarJacobiansMatch(PlaceEdgeFactor(kPlanarEdge, true));
  ExpectPlanarJacobiansMatch(PlaceEdgeFactor(kPlanarEdge, false));
}

TEST(BearingRangeFactor, IsZeroAtTheTruth) {
  const NavVector x = (NavVector() << 1.0, 1.0, 0.0, 0.5 * M_PI, 0.0, 0.0).finished();
  const BearingRangeFactor factor({-0.25 * M_PI, std::sqrt(2.0)}, {0.1, 0.1});
  EXPECT_NEAR(factor.Evaluate(x, {2.0, 2.0, 0.0}).norm(), 0.0, 1e-12);
}
TEST(BearingRangeFactor, JacobiansMatchCentralDifferences) {
  ExpectPlanarJacobiansMatch(BearingRangeFactor({0.2, 3.0}, {0.05, 0.2}));
}

TEST(ScaledDistanceFactor, IsZeroWhenTheScaleExplainsTheRange) {
  const NavVector x = NavVector::Zero();
  EXPECT_NEAR(ScaledDistanceFactor(5.5, 0.1).Evaluate(x, {3.0, 4.0, 0.1}).norm(), 0.0, 1e-12);
}
TEST(ScaledDistanceFactor, JacobiansMatchCentralDifferences) {
  ExpectPlanarJacobiansMatch(ScaledDistanceFactor(3.0, 0.5));
}

}  // namespace
}  // namespace limpet

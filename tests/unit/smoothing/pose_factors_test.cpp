// SPDX-License-Identifier: MIT
// Every factor is zero at the truth and has the Jacobian of central differences.
#include <gtest/gtest.h>

#include "estimation/smoothing/factors/biased_depth_factor.hpp"
#include "estimation/smoothing/factors/depth_factor.hpp"
#include "estimation/smoothing/factors/gps_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "estimation/smoothing/factors/roll_pitch_factor.hpp"
#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"
#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {
namespace {

using namespace literals;

NavVector SomePose() { return (NavVector() << 3.0, -2.0, 4.0, 2.5, 0.1, -0.2).finished(); }

template <class F>
void ExpectJacobianMatches(const F& factor, const NavVector& x) {
  typename F::Jacobian J;
  const auto ignored = factor.Evaluate(x, &J);
  static_cast<void>(ignored);
  const auto f = [&](const NavVector& at) { return Eigen::VectorXd(factor.Evaluate(at)); };
  EXPECT_LT((J - NumericJacobian(f, x)).template lpNorm<Eigen::Infinity>(), 1e-4);
}

TEST(DepthFactor, IsZeroAtTheTruth) {
  EXPECT_NEAR(DepthFactor(4.0_m, 0.1_m).Evaluate(SomePose()).norm(), 0.0, 1e-12);
}
TEST(DepthFactor, JacobianMatchesCentralDifferences) {
  ExpectJacobianMatches(DepthFactor(3.0_m, 0.1_m), SomePose());
}

const Eigen::Vector3d kDepthErrors(0.3, -0.1, 0.2), kShare(1.0, -0.5, 2.0);

TEST(BiasedDepthFactor, IsZeroAtTheTruth) {
  const BiasedDepthFactor factor(4.75_m, 0.1_m, kShare);
  EXPECT_NEAR(factor.Evaluate(SomePose(), kDepthErrors).norm(), 0.0, 1e-12);
}
TEST(BiasedDepthFactor, JacobianMatchesCentralDifferences) {
  const BiasedDepthFactor factor(3.0_m, 0.1_m, kShare);
  BiasedDepthFactor::Jacobian J_pose;
  BiasedDepthFactor::BorderJacobian J_errors;
  static_cast<void>(factor.Evaluate(SomePose(), kDepthErrors, &J_pose, &J_errors));
  const auto of_pose = [&](const NavVector& x) {
    return Eigen::VectorXd(factor.Evaluate(x, kDepthErrors));
  };
  const auto of_errors = [&](const Eigen::Vector3d& e) {
    return Eigen::VectorXd(factor.Evaluate(SomePose(), e));
  };
  EXPECT_LT((J_pose - NumericJacobian(of_pose, SomePose())).lpNorm<Eigen::Infinity>(), 1e-4);
  EXPECT_LT((J_errors - NumericJacobian(of_errors, kDepthErrors)).lpNorm<Eigen::Infinity>(), 1e-4);
}

TEST(GpsFactor, IsZeroAtTheTruth) {
  EXPECT_NEAR(GpsFactor({3.0, -2.0}, 0.5_m).Evaluate(SomePose()).norm(), 0.0, 1e-12);
}
TEST(GpsFactor, JacobianMatchesCentralDifferences) {
  ExpectJacobianMatches(GpsFactor({1.0, 1.0}, 0.5_m), SomePose());
}

TEST(RollPitchFactor, IsZeroAtTheTruth) {
  const RollPitchFactor factor(Radians(-0.2), Radians(0.1), 1.0_deg);
  EXPECT_NEAR(factor.Evaluate(SomePose()).norm(), 0.0, 1e-12);
}
TEST(RollPitchFactor, JacobianMatchesCentralDifferences) {
  ExpectJacobianMatches(RollPitchFactor(Radians(0.0), Radians(0.0), 1.0_deg), SomePose());
}

TEST(PosePriorFactor, IsZeroAtTheTruthAlsoAWholeTurnAway) {
  NavVector turned = SomePose();
  turned(kNavYaw) += 2.0 * M_PI;
  const PosePriorFactor factor(SomePose(), NavVector::Constant(0.5));
  EXPECT_NEAR(factor.Evaluate(turned).norm(), 0.0, 1e-9);
}
TEST(PosePriorFactor, JacobianMatchesCentralDifferences) {
  ExpectJacobianMatches(PosePriorFactor(NavVector::Zero(), NavVector::Constant(0.5)), SomePose());
}

class XyzYawFactorTest : public ::testing::Test {
 protected:
  const NavVector x_i_ = SomePose();
  const NavVector x_j_ = (NavVector() << 4.0, -1.5, 4.2, -3.0, 0.0, 0.1).finished();
  const Eigen::Vector4d variance_{0.01, 0.02, 0.04, 0.001};
};

TEST_F(XyzYawFactorTest, IsZeroForTheMotionSeenFromTheFirstPosesHeading) {
  const double c = std::cos(2.5), s = std::sin(2.5);
  const Eigen::Vector4d motion(c * 1.0 + s * 0.5, -s * 1.0 + c * 0.5, 0.2, 2.0 * M_PI - 5.5);
  EXPECT_NEAR(XyzYawFactor(motion, variance_).Evaluate(x_i_, x_j_).norm(), 0.0, 1e-9);
}
TEST_F(XyzYawFactorTest, JacobiansMatchCentralDifferences) {
  const XyzYawFactor factor({0.5, 0.1, 0.0, 0.5}, variance_);
  XyzYawFactor::Jacobian J_i, J_j;
  const auto r = factor.Evaluate(x_i_, x_j_, &J_i, &J_j);
  EXPECT_GT(r.norm(), 0.0);
  const auto of_i = [&](const NavVector& x) { return Eigen::VectorXd(factor.Evaluate(x, x_j_)); };
  const auto of_j = [&](const NavVector& x) { return Eigen::VectorXd(factor.Evaluate(x_i_, x)); };
  EXPECT_LT((J_i - NumericJacobian(of_i, x_i_)).lpNorm<Eigen::Infinity>(), 1e-5);
  EXPECT_LT((J_j - NumericJacobian(of_j, x_j_)).lpNorm<Eigen::Infinity>(), 1e-5);
}

}  // namespace
}  // namespace limpet

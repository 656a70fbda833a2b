// SPDX-License-Identifier: MIT
// Every factor is zero at the truth and has the Jacobian of central differences.
#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "estimation/smoothing/factors/birthplace_factor.hpp"
#include "estimation/smoothing/factors/border_prior_factor.hpp"
#include "estimation/smoothing/factors/distance_factor.hpp"
#include "estimation/smoothing/factors/edge_factor.hpp"
#include "estimation/smoothing/factors/range_factor.hpp"
#include "estimation/smoothing/factors/reprojection_factor.hpp"
#include "estimation/smoothing/factors/same_place_factor.hpp"
#include "estimation/smoothing/factors/seabed_factor.hpp"
#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {
namespace {

using namespace literals;

/// A tilted camera off the body's origin, over an object ahead and below.
class LandmarkFactorTest : public ::testing::Test {
 protected:
  static CameraModel Tilted() {
    CameraModel camera;
    const double c = std::cos(0.4), s = std::sin(0.4);
    camera.R_BC << 0.0, -c, s, 1.0, 0.0, 0.0, 0.0, s, c;
    camera.p_BC = {0.25, 0.1, 0.15};
    return camera;
  }
  template <class F>
  void ExpectJacobiansMatch(const F& factor) {
    typename F::Jacobian J_pose;
    typename F::BorderJacobian J_landmark;
    const auto r = factor.Evaluate(x_, p_W_, &J_pose, &J_landmark);
    EXPECT_GT(r.norm(), 0.0);
    const auto of_x = [&](const NavVector& x) { return Eigen::VectorXd(factor.Evaluate(x, p_W_)); };
    const auto of_p = [&](const Eigen::Vector3d& p) {
      return Eigen::VectorXd(factor.Evaluate(x_, p));
    };
    EXPECT_LT((J_pose - NumericJacobian(of_x, x_)).template lpNorm<Eigen::Infinity>(), 1e-4);
    EXPECT_LT((J_landmark - NumericJacobian(of_p, p_W_)).template lpNorm<Eigen::Infinity>(), 1e-4);
  }
  Eigen::Vector3d InCamera() const {
    const Pose X_WB = PoseOf(x_);
    const Eigen::Vector3d p_B = RotationOf(X_WB).transpose() * (p_W_ - X_WB.p_WB);
    return camera_.R_BC.transpose() * (p_B - camera_.p_BC);
  }

  const CameraModel camera_ = Tilted();
  const NavVector x_ = (NavVector() << 3.0, -2.0, 3.5, 2.5, 0.1, -0.2).finished();
  const Eigen::Vector3d p_W_{1.0, -1.5, 7.0};
};

TEST_F(LandmarkFactorTest, ReprojectionIsZeroAtTheTruth) {
  const Eigen::Vector3d p = InCamera();
  const Eigen::Vector2d pixel(camera_.cx + camera_.fx * p.x() / p.z(),
                              camera_.cy + camera_.fy * p.y() / p.z());
  const ReprojectionFactor factor(camera_, pixel, {2.0, 3.0});
  EXPECT_NEAR(factor.Evaluate(x_, p_W_).norm(), 0.0, 1e-9);
}
TEST_F(LandmarkFactorTest, ReprojectionJacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(ReprojectionFactor(camera_, {300.0, 200.0}, {2.0, 3.0}));
}
TEST_F(LandmarkFactorTest, ReprojectionIgnoresAnAxisThatTheBorderCuts) {
  const double unused = std::numeric_limits<double>::infinity();
  const ReprojectionFactor factor(camera_, {0.0, 200.0}, {unused, 3.0});
  ReprojectionFactor::Jacobian J;
  EXPECT_EQ(factor.Evaluate(x_, p_W_, &J)(0), 0.0);
  EXPECT_EQ(J.row(0).norm(), 0.0);
}
TEST_F(LandmarkFactorTest, ReprojectionBehindTheCameraIsLargeAndFlat) {
  const ReprojectionFactor factor(camera_, {300.0, 200.0}, {2.0, 2.0});
  ReprojectionFactor::Jacobian J;
  EXPECT_GT(factor.Evaluate(x_, {3.0, -2.0, -5.0}, &J).norm(), 100.0);
  EXPECT_EQ(J.norm(), 0.0);
}

TEST_F(LandmarkFactorTest, RangeIsZeroForTheBoxOfASphere) {
  // In the camera's xz plane the tangents to a circle of radius r enclose twice asin(r / distance).
  const Eigen::Vector3d p = InCamera();
  const double radius = 0.5;
  const auto range_of = [radius](double side, double depth) {
    const double middle = std::atan2(side, depth);
    const double half = std::asin(radius / std::hypot(side, depth));
    const double low = std::tan(middle - half), high = std::tan(middle + half);
    return radius / std::sin(0.5 * (std::atan(high) - std::atan(low)));
  };
  const double measured = 0.5 * (range_of(p.x(), p.z()) + range_of(p.y(), p.z()));
  EXPECT_NEAR(RangeFactor(camera_, Meters(measured), 0.1_m).Evaluate(x_, p_W_)(0), 0.0, 1e-9);
}
TEST_F(LandmarkFactorTest, RangeJacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(RangeFactor(camera_, 3.0_m, 0.1_m));
  ExpectJacobiansMatch(RangeFactor(camera_, 3.0_m, 0.1_m, {1.0, 0.0}));
  ExpectJacobiansMatch(RangeFactor(camera_, 3.0_m, 0.1_m, {0.0, 1.0}));
}

TEST_F(LandmarkFactorTest, EdgeIsZeroForTheTangentToTheSphere) {
  const Eigen::Vector3d p = InCamera();
  const double half = std::asin(0.5 / std::hypot(p.y(), p.z()));
  const double tangent = camera_.cy + camera_.fy * std::tan(std::atan2(p.y(), p.z()) - half);
  const EdgeFactor factor(camera_, 0.5_m, {.axis = 1, .side = -1, .measured_px = tangent});
  EXPECT_NEAR(factor.Evaluate(x_, p_W_)(0), 0.0, 1e-9);
}
TEST_F(LandmarkFactorTest, EdgeJacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(EdgeFactor(camera_, 0.5_m, {.axis = 0, .side = 1, .sigma_px = 3.0}));
  ExpectJacobiansMatch(EdgeFactor(camera_, 0.5_m, {.axis = 1, .side = -1, .sigma_px = 3.0}));
}
TEST_F(LandmarkFactorTest, EdgeIsLargeAndFlatInsideTheSphere) {
  const EdgeFactor factor(camera_, 9.0_m, {.axis = 0, .side = 1, .sigma_px = 3.0});
  EdgeFactor::Jacobian J;
  EXPECT_GT(factor.Evaluate(x_, p_W_, &J)(0), 100.0);
  EXPECT_EQ(J.norm(), 0.0);
}

TEST_F(LandmarkFactorTest, SeabedIsZeroForAnObjectAtTheExpectedHeight) {
  EXPECT_NEAR(SeabedFactor(4.5_m, 1.0_m, 0.7_m).Evaluate(x_, p_W_)(0), 0.0, 1e-12);
}
TEST_F(LandmarkFactorTest, SeabedJacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(SeabedFactor(3.0_m, 1.0_m, 0.7_m));
}

TEST_F(LandmarkFactorTest, PriorWeighsByItsCovariance) {
  Eigen::Matrix3d covariance;
  covariance << 0.5, 0.1, 0.0, 0.1, 0.4, 0.05, 0.0, 0.05, 0.3;
  const BorderPriorFactor factor({1.0, 2.0, 3.0}, covariance);
  EXPECT_NEAR(factor.Evaluate({1.0, 2.0, 3.0}).norm(), 0.0, 1e-12);
  const Eigen::Vector3d off(0.3, -0.2, 0.1);
  EXPECT_NEAR(factor.Evaluate(Eigen::Vector3d(1.0, 2.0, 3.0) + off).squaredNorm(),
              off.dot(covariance.inverse() * off), 1e-9);
}
TEST_F(LandmarkFactorTest, PriorJacobianMatchesCentralDifferences) {
  const BorderPriorFactor factor({1.0, 2.0, 3.0}, 0.2 * Eigen::Matrix3d::Identity());
  BorderPriorFactor::BorderJacobian J;
  const auto r = factor.Evaluate(p_W_, &J);
  EXPECT_GT(r.norm(), 0.0);
  const auto f = [&](const Eigen::Vector3d& p) { return Eigen::VectorXd(factor.Evaluate(p)); };
  EXPECT_LT((J - NumericJacobian(f, p_W_)).lpNorm<Eigen::Infinity>(), 1e-6);
}

TEST_F(LandmarkFactorTest, BirthplaceIsZeroWhereverPoseAndLandmarkAreTogether) {
  const BirthplaceFactor factor(p_W_ - x_.head<3>(), 3.0_m);
  NavVector moved = x_;
  moved.head<3>() += Eigen::Vector3d(5.0, -4.0, 1.0);
  const Eigen::Vector3d p_moved = p_W_ + Eigen::Vector3d(5.0, -4.0, 1.0);
  EXPECT_NEAR(factor.Evaluate(moved, p_moved).norm(), 0.0, 1e-12);
}
TEST_F(LandmarkFactorTest, BirthplaceJacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(BirthplaceFactor({1.0, 2.0, 3.0}, 3.0_m));
}

TEST_F(LandmarkFactorTest, DistanceIsZeroAtTheTruth) {
  const DistanceFactor factor(Meters((p_W_ - x_.head<3>()).norm()), 0.1_m);
  EXPECT_NEAR(factor.Evaluate(x_, p_W_).norm(), 0.0, 1e-12);
}
TEST_F(LandmarkFactorTest, DistanceJacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(DistanceFactor(3.0_m, 0.5_m));
}
TEST_F(LandmarkFactorTest, DistanceHasNoDerivativeWhereBothCoincide) {
  DistanceFactor::BorderJacobian J;
  EXPECT_NEAR(DistanceFactor(3.0_m, 0.5_m).Evaluate(x_, x_.head<3>(), nullptr, &J)(0), -6.0, 1e-12);
  EXPECT_EQ(J.norm(), 0.0);
}

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

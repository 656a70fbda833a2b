// SPDX-License-Identifier: MIT
#include "estimation/smoothing/camera_errors.hpp"

#include <array>
#include <cmath>
#include <type_traits>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "estimation/smoothing/factors/border_prior_factor.hpp"
#include "estimation/smoothing/factors/camera_errors_factor.hpp"
#include "estimation/smoothing/factors/cut_axis_factor.hpp"
#include "estimation/smoothing/factors/object_size_factor.hpp"
#include "estimation/smoothing/factors/range_factor.hpp"
#include "estimation/smoothing/factors/reprojection_factor.hpp"
#include "tests/unit/smoothing/numeric_jacobian.hpp"

namespace limpet {
namespace {

class CameraErrorsTest : public ::testing::Test {
 protected:
  CameraErrorsTest() { camera_.p_BC = {0.25, -0.05, 0.15}; }
  template <class F>
  void ExpectJacobiansMatch(const F& bare) const {
    const CameraErrorsFactor<F> factor(camera_, motion_, bare);
    typename CameraErrorsFactor<F>::Jacobians J;
    static_cast<void>(factor.Evaluate(x_, p_W_, errors_.tilt_B, errors_.lever_and_delay, &J));
    const auto expect = [](const auto& exact, const auto& numeric) {
      EXPECT_LT((exact - numeric).template lpNorm<Eigen::Infinity>(),
                1e-4 * (1.0 + exact.template lpNorm<Eigen::Infinity>()));
    };
    const auto at = [&](const NavVector& x, const Eigen::Vector3d& p_W, const Eigen::Vector3d& tilt,
                        const Eigen::Vector3d& shift) {
      return Eigen::VectorXd(factor.Evaluate(x, p_W, tilt, shift));
    };
    const auto &tilt = errors_.tilt_B, &shift = errors_.lever_and_delay;
    expect(J.pose,
           NumericJacobian([&](const NavVector& x) { return at(x, p_W_, tilt, shift); }, x_));
    expect(J.border[0],
           NumericJacobian([&](const Eigen::Vector3d& p) { return at(x_, p, tilt, shift); }, p_W_));
    expect(J.border[1],
           NumericJacobian([&](const Eigen::Vector3d& t) { return at(x_, p_W_, t, shift); }, tilt));
    expect(J.border[2],
           NumericJacobian([&](const Eigen::Vector3d& s) { return at(x_, p_W_, tilt, s); }, shift));
  }

  CameraModel camera_;
  const CameraErrors errors_{.tilt_B = {0.03, -0.05, 0.02}, .lever_and_delay = {0.05, -0.04, 0.2}};
  const BodyMotion motion_{.v_B = {0.5, 0.05, -0.02}, .omega_B = {0.0, 0.01, 0.2}};
  const NavVector x_ = (NavVector() << 3.0, -2.0, 4.0, 0.7, 0.1, -0.2).finished();
  const Eigen::Vector3d p_W_{3.6, -1.2, 7.0};
};

TEST_F(CameraErrorsTest, WithoutErrorsTheCameraIsAsItsFileSays) {
  const CameraModel same = WithErrors(camera_, {}, motion_);
  EXPECT_EQ(same.R_BC, camera_.R_BC);
  EXPECT_EQ(same.p_BC, camera_.p_BC);
}

TEST_F(CameraErrorsTest, ALateStampShowsWhatWasSeenFromWhereTheBodyWasThen) {
  // The body a moment before the stamp, as its motion says, with the camera that is not late.
  const double delay = 0.2;
  Pose now{{3.0, -2.0, 4.0}, 0.0, 0.0, 0.7};
  const BodyMotion motion{.v_B = {0.5, 0.0, 0.0}, .omega_B = {0.0, 0.0, 0.2}};
  Pose then = now;
  then.yaw -= delay * 0.2;
  const double middle = now.yaw - 0.5 * delay * 0.2;
  then.p_WB -= delay * 0.5 * Eigen::Vector3d(std::cos(middle), std::sin(middle), 0.0);
  const CameraModel late = WithErrors(camera_, {.lever_and_delay = {0.0, 0.0, delay}}, motion);
  EXPECT_LT((late.InCamera(now, p_W_) - camera_.InCamera(then, p_W_)).norm(), 3e-3);
}

TEST_F(CameraErrorsTest, ATiltTurnsThePictureAboutTheCameraNotTheBody) {
  const CameraModel tilted = WithErrors(camera_, {.tilt_B = {0.0, 0.1, 0.0}}, {});
  EXPECT_EQ(tilted.p_BC, camera_.p_BC);
  // Pitched up, a camera that looks down looks ahead.
  EXPECT_GT((tilted.R_BC * Eigen::Vector3d::UnitZ()).x(), 0.09);
}

TEST_F(CameraErrorsTest, JacobiansMatchCentralDifferences) {
  ExpectJacobiansMatch(ReprojectionFactor(camera_, {200.0, 210.0}, {2.0, 3.0}));
  ExpectJacobiansMatch(RangeFactor(camera_, Meters(2.5), Meters(0.3)));
  ExpectJacobiansMatch(CutAxisFactor(
      camera_, Meters(0.4), {.axis = 1, .box = {.low = 150.0, .high = 250.0}, .sigma_px = 3.0}));
}

TEST_F(CameraErrorsTest, ALookAtAnObjectOfUnknownSizeMatchesCentralDifferences) {
  const Eigen::Vector3d sizes(0.1, -0.3, 0.4);
  const auto expect_match = [&](const auto& bare) {
    using F = std::decay_t<decltype(bare)>;
    for (int index = 0; index < 3; ++index) {
      const ObjectSizeFactor<F> factor(camera_, motion_, bare, index, 0.05);
      typename ObjectSizeFactor<F>::Jacobians J;
      static_cast<void>(
          factor.Evaluate(x_, p_W_, errors_.tilt_B, errors_.lever_and_delay, sizes, &J));
      const auto &J_landmark = J.border.front(), &J_sizes = J.border.back();
      const auto by_sizes = [&](const Eigen::Vector3d& s) {
        return Eigen::VectorXd(
            factor.Evaluate(x_, p_W_, errors_.tilt_B, errors_.lever_and_delay, s));
      };
      const auto by_place = [&](const Eigen::Vector3d& p) {
        return Eigen::VectorXd(
            factor.Evaluate(x_, p, errors_.tilt_B, errors_.lever_and_delay, sizes));
      };
      const double scale = 1.0 + J_sizes.template lpNorm<Eigen::Infinity>();
      EXPECT_LT((J_sizes - NumericJacobian(by_sizes, sizes)).template lpNorm<Eigen::Infinity>(),
                1e-4 * scale);
      EXPECT_GT(std::abs(J_sizes(0, index)), 0.1);
      EXPECT_LT((J_landmark - NumericJacobian(by_place, p_W_)).template lpNorm<Eigen::Infinity>(),
                1e-4 * (1.0 + J_landmark.template lpNorm<Eigen::Infinity>()));
    }
  };
  expect_match(RangeFactor(camera_, Meters(2.5), Meters(0.3)));
  expect_match(CutAxisFactor(camera_, Meters(0.4),
                             {.axis = 1, .box = {.low = 150.0, .high = 250.0}, .sigma_px = 3.0}));
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "estimation/association/camera_mount.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "estimation/smoothing/arrow_smoother.hpp"
#include "estimation/smoothing/factors/border_prior_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"

namespace limpet {
namespace {

constexpr CameraMountParams kInDoubt{.tilt_sigma = 0.02, .lever_sigma = 0.05, .delay_sigma = 0.1};

class CameraMountTest : public ::testing::Test {
 protected:
  CameraMountTest() {
    smoother_.AddNode(NavVector::Zero(), std::nullopt);
    smoother_.AddTerm(0,
                      Term::OnPose(PosePriorFactor(NavVector::Zero(), NavVector::Constant(0.1))));
  }
  ArrowSmoother smoother_;
  const CameraModel camera_;
};

TEST_F(CameraMountTest, IsAsItsFileSaysBeforeItBegins) {
  const CameraMount mount(camera_, kInDoubt, smoother_);
  EXPECT_FALSE(mount.slots());
  EXPECT_EQ(mount.At({.v_B = {0.5, 0.0, 0.0}, .omega_B = {0.0, 0.0, 0.2}}).R_BC, camera_.R_BC);
  EXPECT_TRUE(mount.errors().tilt_B.isZero());
}

TEST_F(CameraMountTest, TakesNoVariablesWhereNothingIsInDoubtUnlessTheyAreNeeded) {
  CameraMount sure(camera_, {}, smoother_);
  sure.Begin();
  EXPECT_FALSE(sure.slots());
  sure.Begin(true);
  EXPECT_TRUE(sure.slots());
}

TEST_F(CameraMountTest, BeginsOnce) {
  CameraMount mount(camera_, kInDoubt, smoother_);
  mount.Begin();
  const CameraMount::Slots first = *mount.slots();
  mount.Begin();
  EXPECT_EQ(*mount.slots(), first);
  EXPECT_EQ(smoother_.graph().slot_count(), 2);
}

TEST_F(CameraMountTest, IsAtFirstAsUncertainAsTheFileSays) {
  CameraMount mount(camera_, kInDoubt, smoother_);
  mount.Begin();
  smoother_.Update();
  const auto [tilt, shift] = *mount.slots();
  const Eigen::MatrixXd P = smoother_.Covariance({tilt, shift}).bottomRightCorner<6, 6>();
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(std::sqrt(P(axis, axis)), kInDoubt.tilt_sigma, 1e-6);
  EXPECT_NEAR(std::sqrt(P(3, 3)), kInDoubt.lever_sigma, 1e-6);
  EXPECT_NEAR(std::sqrt(P(4, 4)), kInDoubt.lever_sigma, 1e-6);
  EXPECT_NEAR(std::sqrt(P(5, 5)), kInDoubt.delay_sigma, 1e-6);
}

TEST_F(CameraMountTest, FollowsWhatTheSmootherFinds) {
  CameraMount mount(camera_, kInDoubt, smoother_);
  mount.Begin();
  const Eigen::Vector3d found(0.01, -0.015, 0.005);
  smoother_.AddBorderTerm(
      (*mount.slots())[0],
      Term::OnBorder(BorderPriorFactor(found, 1e-10 * Eigen::Matrix3d::Identity()),
                     (*mount.slots())[0]));
  smoother_.Update();
  EXPECT_LT((mount.errors().tilt_B - found).norm(), 1e-5);
  const CameraModel expected = WithErrors(camera_, mount.errors(), {});
  EXPECT_TRUE(mount.At({}).R_BC.isApprox(expected.R_BC, 1e-12));
  EXPECT_FALSE(mount.At({}).R_BC.isApprox(camera_.R_BC, 1e-4));
  EXPECT_EQ(mount.camera().R_BC, camera_.R_BC) << "the file stays as it is";
}

}  // namespace
}  // namespace limpet

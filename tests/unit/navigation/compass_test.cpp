// SPDX-License-Identifier: MIT
#include "estimation/navigation/compass.hpp"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "estimation/smoothing/arrow_smoother.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kDegree = M_PI / 180.0;

/// A vehicle that turns by `turn` from one pose to the next, with a good gyro and this compass.
class CompassTest : public ::testing::Test {
 protected:
  void Run(int poses, double turn, const Eigen::Vector3d& deviation) {
    for (int i = 0; i < poses; ++i) {
      NavVector x = NavVector::Zero();
      x(kNavYaw) = true_yaw_ + off_;
      if (i == 0) {
        smoother_.AddNode(x, std::nullopt);
        NavVector sigma = NavVector::Constant(0.05);
        sigma(kNavYaw) = 0.5;
        smoother_.AddTerm(0, Term::OnPose(PosePriorFactor(x, sigma)));
        compass_.Begin();
      } else {
        const Eigen::Vector4d variance(1e-4, 1e-4, 1e-4, 1e-8);
        smoother_.AddNode(
            x, Term::OnStep(XyzYawFactor(Eigen::Vector4d(0.0, 0.0, 0.0, turn), variance)));
      }
      const double heading = true_yaw_ + deviation.x() + deviation.y() * std::sin(true_yaw_) +
                             deviation.z() * std::cos(true_yaw_) + random_.Normal(0.1 * kDegree);
      compass_.Use(5.0 * i, Radians(WrapAngle(heading)), i);
      smoother_.Update();
      true_yaw_ += turn;
    }
  }

  Random random_{11};
  ArrowSmoother smoother_;
  Compass compass_{{.sigma = Radians::FromTextUnit(0.75)}, smoother_};
  double true_yaw_ = 0.4;
  /// Where the attitude was aligned to a compass that is off: the chain begins there.
  double off_ = 0.03;
};

TEST_F(CompassTest, ASwingIsFoundAndTheHeadingBelievedLess) {
  Run(200, 0.3, kDegree * Eigen::Vector3d(1.0, 2.0, -1.5));
  const Compass::Deviation found = compass_.deviation().value();
  EXPECT_NEAR(found.value.y(), 2.0 * kDegree, 3.0 * found.sd.y());
  EXPECT_NEAR(found.value.z(), -1.5 * kDegree, 3.0 * found.sd.z());
  EXPECT_LT(found.sd.y(), 0.3 * kDegree);
  EXPECT_TRUE(found.is_too_large);
  EXPECT_GT(found.believed_sd, 1.2 * kDegree);
  // The constant part is not seen, and may be as large.
  EXPECT_GT(found.sd.x(), 1.1 * kDegree);
  const double yaw_off = smoother_.PoseAt(199)(kNavYaw) - (true_yaw_ - 0.3);
  const double sd = std::sqrt(smoother_.Covariance({})(kNavYaw, kNavYaw));
  EXPECT_NEAR(yaw_off, 0.0, 2.0 * sd);
}

TEST_F(CompassTest, ACompassAsItsSheetSaysIsBelievedAsMuch) {
  Run(200, 0.3, kDegree * Eigen::Vector3d(0.4, 0.2, -0.3));
  const Compass::Deviation found = compass_.deviation().value();
  EXPECT_FALSE(found.is_too_large);
  EXPECT_NEAR(found.believed_sd, 0.75 * kDegree, 0.01 * kDegree);
  EXPECT_NEAR(found.sd.x(), 0.75 * kDegree, 0.05 * kDegree);
}

TEST_F(CompassTest, WithoutATurnNothingTellsTheSwing) {
  Run(200, 0.0, kDegree * Eigen::Vector3d(1.0, 2.0, -1.5));
  EXPECT_FALSE(compass_.deviation()->is_too_large);
}

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/control/drift_estimate.hpp"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/unit/control/control_law.hpp"

namespace limpet {
namespace {

TEST(DriftEstimate, LearnsACurrentOnOneCourseAndKnowsItOnAnother) {
  DriftEstimate drift({});
  Eigen::Vector2d current_B = Eigen::Vector2d::Zero();
  for (int i = 0; i < 20; ++i) {  // heading north, pushed to starboard
    current_B = drift.Update(0.0, {0.0, -0.05}, kLawStep, false);
  }
  EXPECT_GT(current_B.y(), 0.02);
  const Eigen::Vector2d turned_B =
      drift.Update(std::numbers::pi / 2.0, Eigen::Vector2d::Zero(), kLawStep, false);
  EXPECT_NEAR(turned_B.x(), current_B.y(), 1e-12);  // heading east it runs along
}

TEST(DriftEstimate, DoesNotWindUpWhileThrustersSaturate) {
  DriftEstimate drift({});
  EXPECT_EQ(drift.Update(0.0, {1.0, 1.0}, kLawStep, true).norm(), 0.0);
}

TEST(DriftSymmetry, ACurrentLearnedOnOneCourseIsTheSameCurrentOnEveryOther) {
  Random random(4, "drift");
  for (int run = 0; run < 100; ++run) {
    DriftEstimate drift({});
    const double yaw = random.Uniform(-3.1, 3.1);
    Eigen::Vector2d current_B;
    for (int step = 0; step < 30; ++step) {
      current_B =
          drift.Update(yaw, {random.Uniform(-0.2, 0.2), random.Uniform(-0.2, 0.2)}, 0.1, false);
    }
    const Eigen::Vector2d current_W = Eigen::Rotation2Dd(yaw) * current_B;
    const double other = random.Uniform(-3.1, 3.1);
    const Eigen::Vector2d there = drift.Update(other, Eigen::Vector2d::Zero(), 0.1, false);
    EXPECT_LT((Eigen::Rotation2Dd(other) * there - current_W).norm(), 1e-9);
    EXPECT_LE(current_W.norm(), DriftEstimate::Gains{}.limit + 1e-9);
  }
}

}  // namespace
}  // namespace limpet

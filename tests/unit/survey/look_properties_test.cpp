// SPDX-License-Identifier: MIT
// What is planned as a look is counted as one: over random cameras, water, objects and heights.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/survey/look.hpp"

namespace limpet {
namespace {

LookModel DrawLookModel(Random& random) {
  LookModel model;
  model.camera =
      CameraModel::FromFieldOfView(640, 480,
                                   {.across = RadiansFromDegrees(random.Uniform(50.0, 95.0)),
                                    .along = RadiansFromDegrees(random.Uniform(40.0, 75.0))});
  model.detection.visibility = Meters(random.Uniform(3.0, 15.0));
  model.detection.best = random.Uniform(0.8, 0.99);
  model.object_radius = random.Uniform(0.2, 0.8);
  return model;
}

class LookProperties : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam()), "look"};
  const LookModel model_ = DrawLookModel(random_);
  [[nodiscard]] bool IsLookFrom(const Pose& X_WB, const Eigen::Vector3d& p_W) const {
    return ChanceToDetect(model_, X_WB, p_W) >= kLookChance;
  }
};

TEST_P(LookProperties, APlaceInItsWindowIsLookedAtFromAnyHeading) {
  for (int i = 0; i < 40; ++i) {
    const double drop = random_.Uniform(0.8, 4.0);
    const std::optional<LookWindow> window = LookWindowAbove(model_, {.drop = drop});
    if (!window) continue;
    const Pose X_WB{
        {random_.Normal(20.0), random_.Normal(20.0), 3.0}, 0.0, 0.0, random_.Uniform(-3.1, 3.1)};
    const Eigen::Vector3d p_B(random_.Uniform(-0.99, 0.99) * window->half_along,
                              random_.Uniform(-0.99, 0.99) * window->half_across, drop);
    EXPECT_TRUE(window->Contains(p_B.head<2>()));
    EXPECT_TRUE(IsLookFrom(X_WB, X_WB.p_WB + RotationOf(X_WB) * p_B));
  }
}

TEST_P(LookProperties, SlackIsTakenFromTheWindowButNeverMoreThanSixTenthsOfIt) {
  for (int i = 0; i < 20; ++i) {
    const double drop = random_.Uniform(0.8, 4.0), slack = random_.Uniform(0.0, 2.0);
    const auto wide = LookWindowAbove(model_, {.drop = drop});
    const auto narrow = LookWindowAbove(model_, {.drop = drop, .slack = slack});
    ASSERT_EQ(wide.has_value(), narrow.has_value());
    if (!wide) continue;
    EXPECT_NEAR(narrow->half_along, std::max(wide->half_along - slack, 0.4 * wide->half_along),
                1e-9);
    EXPECT_NEAR(narrow->half_across, std::max(wide->half_across - slack, 0.4 * wide->half_across),
                1e-9);
  }
}

TEST_P(LookProperties, ClearerWaterNeverMakesAWindowSmaller) {
  LookModel clearer = model_;
  clearer.detection.visibility = 1.5 * model_.detection.visibility;
  for (int i = 0; i < 20; ++i) {
    const double drop = random_.Uniform(0.8, 6.0);
    const auto before = LookWindowAbove(model_, {.drop = drop});
    const auto after = LookWindowAbove(clearer, {.drop = drop});
    if (!before) continue;
    ASSERT_TRUE(after);
    EXPECT_GE(after->half_across, before->half_across - 1e-6);
    EXPECT_GE(after->half_along, before->half_along - 1e-6);
  }
}

TEST_P(LookProperties, TheWindowHasTheShapeOfTheImage) {
  for (int i = 0; i < 10; ++i) {
    const auto window = LookWindowAbove(model_, {.drop = random_.Uniform(0.8, 3.0)});
    if (!window) continue;
    EXPECT_NEAR(window->half_along / window->half_across,
                model_.camera.half_along() / model_.camera.half_across(), 1e-6);
  }
}

TEST_P(LookProperties, NothingAboveTheCameraIsEverLookedAt) {
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(LookWindowAbove(model_, {.drop = random_.Uniform(-5.0, 0.0)}));
    EXPECT_EQ(ChanceToDetect(model_, Pose{}, {0.0, 0.0, random_.Uniform(-5.0, -0.1)}), 0.0);
  }
}

TEST_P(LookProperties, AFrameSaysTheSameOfAPlaceForOneWaterAndForAll) {
  const PerVisibility grid = VisibilityBelief::Grid();
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d p_W(random_.Normal(1.0), random_.Normal(1.0), random_.Uniform(1.0, 6.0));
    const PerVisibility all = ChancesToDetect(model_, Pose{}, p_W, grid);
    for (int k = 0; k < PerVisibility::kCount; k += 5) {
      LookModel in_it = model_;
      in_it.detection.visibility = Meters(grid(k));
      EXPECT_NEAR(all(k), ChanceToDetect(in_it, Pose{}, p_W), 1e-12);
    }
  }
}

TEST_P(LookProperties, ALargerObjectIsSeenFromFartherAway) {
  LookModel large = model_;
  large.object_radius = 2.0 * model_.object_radius;
  int better = 0;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d below(0.0, 0.0, random_.Uniform(1.5, 12.0));
    const double small = ChanceToDetect(model_, Pose{}, below);
    const double big = ChanceToDetect(large, Pose{}, below);
    EXPECT_GE(big, small - 1e-12);
    better += big > small + 1e-9 ? 1 : 0;
  }
  EXPECT_GT(better, 0);
}

TEST_P(LookProperties, TheModelIsTheSameBehindItsMessage) {
  const LookModel back = ToLookModel(ToMapLook(model_));
  EXPECT_EQ(back.object_radius, model_.object_radius);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d p_W(random_.Normal(1.5), random_.Normal(1.5), random_.Uniform(0.5, 8.0));
    EXPECT_NEAR(ChanceToDetect(back, Pose{}, p_W), ChanceToDetect(model_, Pose{}, p_W), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, LookProperties, ::testing::Range(1, 7));

}  // namespace
}  // namespace limpet

// SPDX-License-Identifier: MIT
// What any detector's chances obey, over random models, ranges and water.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/survey/detection_chance.hpp"

namespace limpet {
namespace {

DetectionModel DrawModel(Random& random) {
  DetectionModel model;
  model.best = random.Uniform(0.3, 0.999);
  model.visibility = Meters(random.Uniform(1.0, 20.0));
  model.half_range = random.Uniform(0.4, 2.0);
  model.fall_off = random.Uniform(0.01, 0.3);
  model.least_size_px = random.Uniform(3.0, 60.0);
  model.share_none = random.Uniform(0.0, 0.4);
  model.share_full = model.share_none + random.Uniform(0.1, 0.5);
  return model;
}

class DetectionChanceProperties : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam()), "detection model"};
  const DetectionModel model_ = DrawModel(random_);
  [[nodiscard]] double DrawRange() {
    return random_.Uniform(0.1, 3.0) * model_.half_range * model_.visibility.value();
  }
};

TEST_P(DetectionChanceProperties, AChanceIsNeverMoreThanTheBest) {
  for (int i = 0; i < 200; ++i) {
    const double chance =
        DetectionChance(model_, {.range = DrawRange(), .share = random_.Uniform(0.0, 1.0)});
    EXPECT_GE(chance, 0.0);
    EXPECT_LE(chance, model_.best);
  }
}

TEST_P(DetectionChanceProperties, MoreRangeNeverHelpsAndMoreOfTheObjectNeverHurts) {
  for (int i = 0; i < 100; ++i) {
    const double near = DrawRange(), far = near + random_.Uniform(0.0, 5.0);
    const double little = random_.Uniform(0.0, 1.0), much = random_.Uniform(little, 1.0);
    EXPECT_GE(DetectionChance(model_, {.range = near, .share = much}),
              DetectionChance(model_, {.range = far, .share = much}));
    EXPECT_GE(DetectionChance(model_, {.range = near, .share = much}),
              DetectionChance(model_, {.range = near, .share = little}));
  }
}

TEST_P(DetectionChanceProperties, AtTheHalfRangeHalfIsLeftAndTheFallIsSymmetricAboutIt) {
  const double half = HalfRange(model_);
  EXPECT_NEAR(DetectionChance(model_, {.range = half, .share = 1.0}), 0.5 * model_.best, 1e-12);
  for (int i = 0; i < 20; ++i) {
    const double off = random_.Uniform(0.0, half);
    EXPECT_NEAR(DetectionChance(model_, {.range = half - off, .share = 1.0}) +
                    DetectionChance(model_, {.range = half + off, .share = 1.0}),
                model_.best, 1e-9);
  }
}

TEST_P(DetectionChanceProperties, TwiceTheVisibilityShowsTwiceAsFar) {
  DetectionModel clearer = model_;
  clearer.visibility = 2.0 * model_.visibility;
  for (int i = 0; i < 50; ++i) {
    const double range = DrawRange(), share = random_.Uniform(0.0, 1.0);
    EXPECT_NEAR(DetectionChance(clearer, {.range = 2.0 * range, .share = share}),
                DetectionChance(model_, {.range = range, .share = share}), 1e-12);
  }
}

TEST_P(DetectionChanceProperties, TheBorderMattersBetweenItsTwoSharesOnly) {
  const double range = DrawRange(), open = DetectionChance(model_, {.range = range, .share = 1.0});
  EXPECT_EQ(DetectionChance(model_, {.range = range, .share = model_.share_none}), 0.0);
  EXPECT_EQ(DetectionChance(model_, {.range = range, .share = 0.5 * model_.share_none}), 0.0);
  EXPECT_NEAR(DetectionChance(model_, {.range = range, .share = model_.share_full}), open, 1e-12);
  const double middle = 0.5 * (model_.share_none + model_.share_full);
  EXPECT_NEAR(DetectionChance(model_, {.range = range, .share = middle}), 0.5 * open, 1e-9);
  // Between them it rises smoothly: slowly at first, and from three quarters on hardly any more.
  const double quarter = model_.share_none + 0.25 * (model_.share_full - model_.share_none);
  EXPECT_NEAR(DetectionChance(model_, {.range = range, .share = quarter}), 5.0 / 32.0 * open, 1e-9);
}

TEST_P(DetectionChanceProperties, TheChancesOfAllWatersAreThoseOfEachWater) {
  for (int i = 0; i < 20; ++i) {
    const double range = DrawRange(), share = random_.Uniform(0.0, 1.0);
    const PerVisibility all =
        DetectionChances(model_, {.range = range, .share = share}, VisibilityBelief::Grid());
    for (int k = 0; k < PerVisibility::kCount; ++k) {
      DetectionModel in_it = model_;
      in_it.visibility = Meters(VisibilityBelief::Grid()(k));
      EXPECT_NEAR(all(k), DetectionChance(in_it, {.range = range, .share = share}), 1e-12);
    }
  }
}

TEST_P(DetectionChanceProperties, SizeHelpsByHalfAtItsLeastAndNearlyWhollyAtTwice) {
  EXPECT_NEAR(SizeFactor(model_, model_.least_size_px), 0.5, 1e-12);
  EXPECT_GT(SizeFactor(model_, 2.0 * model_.least_size_px), 0.999);
  EXPECT_LT(SizeFactor(model_, 0.5 * model_.least_size_px), 0.01);
  for (int i = 0; i < 50; ++i) {
    const double size = random_.Uniform(0.0, 3.0) * model_.least_size_px;
    EXPECT_LE(SizeFactor(model_, size), SizeFactor(model_, size + random_.Uniform(0.0, 5.0)));
  }
}

TEST_P(DetectionChanceProperties, TheMeanVisibilityOfSureWaterIsThatOfTheWater) {
  for (int i = 0; i < 10; ++i) {
    const double visibility = 1.5 * std::pow(10.0, random_.Uniform(0.0, 1.0));
    // Between two steps of the grid it is known to a tenth.
    const VisibilityBelief sure(Meters(visibility), 1.1);
    EXPECT_NEAR(MeanVisibility(model_, sure).value() / visibility, 1.0, 0.12);
  }
}

TEST_P(DetectionChanceProperties, ClearerWaterHasAGreaterMeanVisibility) {
  double before = 0.0;
  for (const double visibility : {1.0, 2.0, 4.0, 8.0, 16.0}) {
    const double mean = MeanVisibility(model_, VisibilityBelief(Meters(visibility), 1.5)).value();
    EXPECT_GT(mean, 1.3 * before);
    before = mean;
  }
}

TEST_P(DetectionChanceProperties, AShareOfADiscIsThatOfAnyWayTheVehicleIsTurned) {
  const CameraModel camera;
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector3d p_B(random_.Uniform(-3.0, 3.0), random_.Uniform(-3.0, 3.0),
                              random_.Uniform(1.0, 6.0));
    const double radius = random_.Uniform(0.1, 1.0);
    const double level = VisibleShare(camera, Pose{}, p_B, radius);
    const Pose X_WB{{random_.Normal(10.0), random_.Normal(10.0), random_.Normal(3.0)},
                    random_.Uniform(-0.5, 0.5),
                    random_.Uniform(-0.5, 0.5),
                    random_.Uniform(-3.1, 3.1)};
    const Eigen::Vector3d p_W = X_WB.p_WB + RotationOf(X_WB) * p_B;
    EXPECT_NEAR(VisibleShare(camera, X_WB, p_W, radius), level, 0.05);
    EXPECT_GE(level, 0.0);
    EXPECT_LE(level, 1.0);
  }
}

TEST_P(DetectionChanceProperties, AnImageOfTwiceTheSizeNeverShowsLess) {
  const CameraModel camera;
  CameraModel wide = camera;  // the same lens before more pixels
  wide.width_px *= 2, wide.height_px *= 2;
  wide.cx *= 2.0, wide.cy *= 2.0;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d p_W(random_.Uniform(-4.0, 4.0), random_.Uniform(-5.0, 5.0),
                              random_.Uniform(1.0, 6.0));
    EXPECT_GE(VisibleShare(wide, Pose{}, p_W, 0.5), VisibleShare(camera, Pose{}, p_W, 0.5));
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, DetectionChanceProperties, ::testing::Range(1, 9));

}  // namespace
}  // namespace limpet

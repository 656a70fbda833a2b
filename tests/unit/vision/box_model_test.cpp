// SPDX-License-Identifier: MIT
#include "limpet/vision/box_model.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/detector_trial.hpp"

namespace limpet {
namespace {

const trial::Plan kPlan{.scenes = 8, .frames = 40, .seed = 5};

const trial::Result& Detected() {
  static const trial::Result result = trial::RunDetector(kPlan);
  return result;
}
const trial::Result& Modelled() {
  static const trial::Result result = trial::RunModel(kPlan);
  return result;
}

/// Share found of the looks with a visible fraction in [low, high) within the visibility.
double Recall(const trial::Result& result, double low, double high) {
  int looks = 0;
  int found = 0;
  for (const trial::Look& look : result.looks) {
    const double visible = look.image.visible_fraction;
    if (visible >= low && visible < high && look.range_share() < 1.0) {
      ++looks;
      found += look.found ? 1 : 0;
    }
  }
  EXPECT_GT(looks, 15);
  return static_cast<double>(found) / looks;
}

/// 80th percentile of the centre's error of whole balls, in pixels.
double CentreError(const trial::Result& result) {
  std::vector<double> errors;
  for (const trial::Look& look : result.looks) {
    if (look.found && look.image.visible_fraction > 0.99 && look.range_share() < 0.8) {
      errors.push_back(std::abs(look.found->u - look.image.visible.center_u()));
      errors.push_back(std::abs(look.found->v - look.image.visible.center_v()));
    }
  }
  std::ranges::sort(errors);
  return errors.at(errors.size() * 4 / 5);
}

TEST(BoxModel, FindsAsManyAsTheDetector) {
  EXPECT_NEAR(Recall(Modelled(), 0.6, 1.1), Recall(Detected(), 0.6, 1.1), 0.04);
  EXPECT_NEAR(Recall(Modelled(), 0.25, 0.6), Recall(Detected(), 0.25, 0.6), 0.15);
  EXPECT_NEAR(Recall(Modelled(), 0.0, 0.25), Recall(Detected(), 0.0, 0.25), 0.12);
}

TEST(BoxModel, IsAsPreciseAsTheDetector) {
  const double ratio = CentreError(Modelled()) / CentreError(Detected());
  EXPECT_GT(ratio, 0.6);
  EXPECT_LT(ratio, 1.7);
}

TEST(BoxModel, IsAsConfidentAsTheDetector) {
  const auto mean = [](const trial::Result& result) {
    double sum = 0.0;
    int count = 0;
    for (const trial::Look& look : result.looks) {
      if (look.found && look.range_share() < 1.0) {
        sum += look.found->confidence;
        ++count;
      }
    }
    return sum / count;
  };
  EXPECT_NEAR(mean(Modelled()), mean(Detected()), 0.03);
}

TEST(BoxModel, InventsBoxesAtTheGivenRate) {
  const BoxModel model(
      {.camera = {}, .visibility_m = 8.0, .false_boxes_per_image = 0.2, .constants = {}});
  Random random(9);
  int boxes = 0;
  for (int frame = 0; frame < 5000; ++frame) {
    boxes += static_cast<int>(model.Detect({}, {}, random).size());
  }
  EXPECT_NEAR(boxes / 5000.0, 0.2, 0.03);
}

TEST(BoxModel, EqualSeedsGiveEqualBoxes) {
  const BoxModel model(
      {.camera = {}, .visibility_m = 8.0, .false_boxes_per_image = 0.5, .constants = {}});
  const std::vector<Sphere> spheres{{{0.2, 0.3, 4.0}, 0.5, "yellow"}};
  Random one(4);
  Random two(4);
  for (int frame = 0; frame < 20; ++frame) {
    const std::vector<Box> a = model.Detect({}, spheres, one);
    const std::vector<Box> b = model.Detect({}, spheres, two);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].u, b[i].u);
      EXPECT_EQ(a[i].confidence, b[i].confidence);
    }
  }
}

TEST(BoxModel, FindsLessTheFartherAndTheMoreIsCut) {
  const BoxModel model({});
  const CameraModel camera;
  double last = 1.1;
  for (const double range : {4.0, 8.0, 10.0, 11.0, 12.0}) {
    const double p = model.DetectionProbability(*ImageOfSphere(camera, {0.0, 0.0, range}, 0.5));
    EXPECT_LE(p, last);
    last = p;
  }
  EXPECT_LT(last, 0.1);
}

}  // namespace
}  // namespace limpet

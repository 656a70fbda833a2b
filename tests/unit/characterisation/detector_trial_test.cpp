// SPDX-License-Identifier: MIT
#include "limpet/characterisation/detector_trial.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace limpet {
namespace {

/// Finds nothing; or says the same box in every picture.
class BlindDetector final : public Detector {
 public:
  explicit BlindDetector(std::vector<Box> always) : always_(std::move(always)) {}
  std::vector<Box> Detect(const ImageView&) override { return always_; }

 private:
  std::vector<Box> always_;
};

TrialPlan SmallPlan() {
  TrialPlan plan;
  plan.worlds = 2, plan.pictures_per_world = 5, plan.seed = 3;
  return plan;
}

TEST(DetectorTrial, LooksAtBallsAndAtOtherThings) {
  BlindDetector blind({});
  TrialPlan plan = SmallPlan();
  plan.worlds = 4, plan.pictures_per_world = 8;
  const TrialResult trial = RunTrial(plan, blind, {});
  EXPECT_EQ(trial.pictures, 32);
  EXPECT_EQ(trial.false_boxes, 0);
  const auto balls = std::ranges::count(trial.looks, SolidKind::kSphere, &TrialLook::kind);
  EXPECT_GT(balls, 10);
  EXPECT_LT(balls, static_cast<std::ptrdiff_t>(trial.looks.size()));
  for (const TrialLook& look : trial.looks) {
    EXPECT_FALSE(look.found);
    EXPECT_GT(look.size_px, 0.0);
    EXPECT_LE(look.visible_fraction, 1.0);
    EXPECT_GE(look.visibility_m, 2.5);
  }
}

TEST(DetectorTrial, CountsABoxOfNothingAsFalse) {
  BlindDetector dreamer(
      {{.u = 3.0, .v = 3.0, .w = 4.0, .h = 4.0, .confidence = 0.9, .color = "red"}});
  const TrialResult trial = RunTrial(SmallPlan(), dreamer, {});
  EXPECT_GE(trial.false_boxes, 8);
  EXPECT_LE(trial.false_boxes, trial.pictures);
}

TEST(DetectorTrial, OfEqualPlansIsEqualAndTellsHowFarItIs) {
  BlindDetector blind({});
  std::vector<int> done;
  const TrialResult once =
      RunTrial(SmallPlan(), blind, [&done](int worlds) { done.push_back(worlds); });
  const TrialResult again = RunTrial(SmallPlan(), blind, {});
  EXPECT_EQ(done, (std::vector<int>{1, 2}));
  ASSERT_EQ(once.looks.size(), again.looks.size());
  for (std::size_t i = 0; i < once.looks.size(); ++i) {
    EXPECT_EQ(once.looks[i].range, again.looks[i].range);
    EXPECT_EQ(once.looks[i].visible_fraction, again.looks[i].visible_fraction);
  }
}

}  // namespace
}  // namespace limpet

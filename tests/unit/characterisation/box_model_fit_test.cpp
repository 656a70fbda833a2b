// SPDX-License-Identifier: MIT
#include "limpet/characterisation/box_model_fit.hpp"

#include <gtest/gtest.h>

#include "tests/unit/characterisation/drawn_trial.hpp"

namespace limpet {
namespace {

/// A detector unlike the one that the defaults describe.
constexpr BoxModelConstants kOther{.peak = 0.9,
                                   .faint_at = 0.8,
                                   .faint_width = 0.12,
                                   .cut_at = 0.45,
                                   .cut_width = 0.05,
                                   .least_radius_px = 12.0,
                                   .centre_sd_px = 0.8,
                                   .size_sd_px = 1.5,
                                   .size_bias_px = 2.0,
                                   .sd_growth_faint = 1.0,
                                   .sd_growth_cut = 2.0,
                                   .confidence = 0.8,
                                   .confidence_loss_faint = 0.3,
                                   .confidence_loss_cut = 0.2,
                                   .confidence_sd = 0.05,
                                   .confusion_whole = 0.1};

TEST(FitBoxModel, FindsWhatADetectorWasDrawnFrom) {
  const BoxModelConstants fitted = FitBoxModel(DrawTrial(kOther, 20000, 3));
  EXPECT_NEAR(fitted.peak, kOther.peak, 0.03);
  EXPECT_NEAR(fitted.faint_at, kOther.faint_at, 0.04);
  EXPECT_NEAR(fitted.faint_width, kOther.faint_width, 0.04);
  EXPECT_NEAR(fitted.cut_at, kOther.cut_at, 0.03);
  EXPECT_NEAR(fitted.least_radius_px, kOther.least_radius_px, 1.0);
  EXPECT_NEAR(fitted.centre_sd_px, kOther.centre_sd_px, 0.25);
  EXPECT_NEAR(fitted.size_bias_px, kOther.size_bias_px, 0.2);
  EXPECT_NEAR(fitted.confidence, kOther.confidence, 0.05);
  EXPECT_NEAR(fitted.confusion_whole, kOther.confusion_whole, 0.03);
}

TEST(FitBoxModel, OfFewLooksIsWithinItsBounds) {
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    const TrialResult trial = DrawTrial(kOther, 40, seed);
    const BoxModelConstants fitted = FitBoxModel(trial);
    EXPECT_GE(fitted.peak, 0.0);
    EXPECT_LE(fitted.peak, 1.0);
    EXPECT_GE(fitted.sd_growth_cut, 0.0);
    EXPECT_TRUE(std::isfinite(fitted.sd_growth_faint));
    EXPECT_TRUE(std::isfinite(fitted.confidence_loss_cut));
  }
}

TEST(DetectionSheet, PromisesLessThanWasMeasured) {
  const TrialResult trial = DrawTrial(kOther, 5000, 4);
  const BoxModelConstants fitted = FitBoxModel(trial);
  const DetectionModel believed = SheetOf(fitted, trial).detection;
  EXPECT_LT(believed.best, fitted.peak);
  EXPECT_LT(believed.half_range, fitted.faint_at);
  EXPECT_GT(believed.false_per_image, static_cast<double>(trial.false_boxes) / trial.pictures);
  EXPECT_LT(believed.share_none, believed.share_full);
}

TEST(DetectionSheet, ADetectorThatConfusesColoursLetsThemDiffer) {
  BoxModelConstants sure;
  BoxModelConstants unsure;
  sure.confusion_whole = 0.001;
  unsure.confusion_whole = 0.3;
  const TrialResult trial = DrawTrial({}, 500, 6);
  constexpr double kGate = 9.0;  // squared sigmas of a match, pNav's default
  EXPECT_LT(SheetOf(unsure, trial).color_penalty, 2.0);
  EXPECT_GT(SheetOf(sure, trial).color_penalty, 5.0);
  EXPECT_LT(SheetOf(sure, trial).color_penalty, kGate)
      << "two boxes in a hundred are wrong at least";
  EXPECT_LT(SheetOf(sure, trial).wrong_color, SheetOf(unsure, trial).wrong_color);
}

TEST(DetectionSheet, OfADetectorThatInventedNothingStillExpectsSome) {
  TrialResult trial = DrawTrial(kOther, 2000, 5);
  trial.false_boxes = 0;
  EXPECT_GT(SheetOf(FitBoxModel(trial), trial).detection.false_per_image, 0.0);
}

}  // namespace
}  // namespace limpet

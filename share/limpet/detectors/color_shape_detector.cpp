// SPDX-License-Identifier: MIT
#include "limpet/detectors/color_shape_detector.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "limpet/detectors/ramp.hpp"
#include "limpet/objects/pixel_rect.hpp"
#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/image_mat.hpp"
#include "limpet/vision/paint_classifier.hpp"

namespace limpet {
namespace {

/// The boxes without repeats: of those that share more than half of the smaller one, the most
/// confident.
std::vector<Box> WithoutRepeats(const std::vector<Box>& boxes) {
  std::vector<Box> kept;
  for (const Box& box : boxes) {
    const bool repeats = std::ranges::any_of(kept, [&box](const Box& other) {
      const double least = std::min(RectOf(box).area(), RectOf(other).area());
      return Intersection(RectOf(box), RectOf(other)).area() > 0.5 * least;
    });
    if (!repeats) {
      kept.push_back(box);
    }
  }
  return kept;
}

/// A cut ball may show its dim side only, where a paint may look like nothing: there the light it
/// has decides. Between warm paints, what no shade changes does.
std::optional<PaintClass> Classify(const Contrast& contrast, bool is_cut) {
  std::optional<PaintClass> paint = ClassifyPaint(contrast.inside - contrast.outside);
  if (!is_cut) return paint;
  if (!paint) paint = ClassifyPaint(contrast.lit - contrast.outside);
  if (!paint || !IsWarm(*paint)) return paint;
  const std::optional<PaintClass> warm = ClassifyWarmInShade(contrast.inside, contrast.outside);
  return warm && warm->color != paint->color ? warm : paint;
}

}  // namespace

ColorShapeDetector::ColorShapeDetector(const Params& params) : params_(params) {
  // The work on one image is too small to share among threads; and other processes want the cores.
  cv::setNumThreads(0);
}

bool ColorShapeDetector::Assess(const Blob& blob, Candidate& candidate) const {
  const cv::Mat& small_image = outlines_.small();
  const int factor = outlines_.factor();
  const cv::Point low = blob.bounds.tl(), high = blob.bounds.br();
  const bool touches_border =
      low.x <= 0 || low.y <= 0 || high.x >= small_image.cols || high.y >= small_image.rows;
  const double fullness = blob.fullness;
  if (fullness < (touches_border ? 0.78 : 0.86) ||
      blob.Elongation() > (touches_border ? 4.0 : 2.0)) {
    return false;
  }
  const Ellipse small = Ellipse::OfMoments(blob.center, blob.covariance);
  const std::optional<Contrast> contrast =
      MeasureContrast(ViewOf(small_image), small, BallOutlines::kSmallNoise);
  if (!contrast || contrast->separation < 3.0 || contrast->support < 0.6) {
    return false;
  }
  candidate.quality =
      fullness * contrast->support * contrast->separation / (contrast->separation + 4.0);
  candidate.ellipse = {small.center * factor, small.axes * factor};
  const double f = factor;
  candidate.rect = {low.x * f, low.y * f, high.x * f, high.y * f};
  return true;
}

void ColorShapeDetector::CollectCandidates() {
  const cv::Mat& small = outlines_.small();
  const double radius = params_.least_radius_px / outlines_.factor();
  const double least_area = std::max(6.0, 2.0 * radius * radius);
  const double most_area = 0.6 * static_cast<double>(small.total());
  colors_.Fill(small, BallOutlines::kSmallNoise);
  blobs_.clear();
  for (const cv::Mat& plane : colors_.planes()) {
    for (const int level : colors_.LevelsOf(plane)) {
      finder_.Find(plane, level, least_area, blobs_);
    }
  }
  candidates_.clear();
  for (const Blob& blob : blobs_) {
    Candidate candidate;
    if (blob.area <= most_area && Assess(blob, candidate)) {
      candidates_.push_back(candidate);
    }
  }
}

std::optional<Box> ColorShapeDetector::Verify(const ImageView& image,
                                              const Candidate& candidate) const {
  const std::optional<BallOutline> finding = outlines_.Find(candidate.ellipse);
  if (!finding) {
    return std::nullopt;
  }
  const auto& [outline, contrast, factor] = *finding;
  const PixelRect rect = outline.ellipse.VisiblePart(image.width_px, image.height_px);
  const bool is_cut = outline.IsCut();
  const std::optional<PaintClass> paint = Classify(contrast, is_cut);
  if (!paint || outline.sides < 0.2 || outline.ellipse.MeanRadius() < params_.least_radius_px ||
      rect.area() <= 0.0) {
    return std::nullopt;
  }
  const double color = Ramp(contrast.separation, {1.0, 6.0}) * Ramp(contrast.support, {0.5, 0.95});
  return Box{.u = rect.center_u(),
             .v = rect.center_v(),
             .w = rect.width(),
             .h = rect.height(),
             .confidence = std::sqrt(std::sqrt(finding->Roundness(image) * color) *
                                     Ramp(paint->certainty, {-0.5, 1.0})),
             .color = paint->color};
}

std::vector<Box> ColorShapeDetector::Detect(const ImageView& image) {
  if (std::min(image.width_px, image.height_px) < kLeastImageSide) {
    return {};
  }
  outlines_.Take(image);
  CollectCandidates();
  std::ranges::stable_sort(candidates_, std::ranges::greater(), &Candidate::quality);
  std::vector<Candidate> chosen;
  std::vector<Box> boxes;
  for (const Candidate& candidate : candidates_) {
    const bool is_known = std::ranges::any_of(chosen, [&candidate](const Candidate& other) {
      return Overlap(candidate.rect, other.rect) > 0.35;
    });
    if (is_known) {
      continue;
    }
    chosen.push_back(candidate);
    const std::optional<Box> box = Verify(image, candidate);
    if (box && box->confidence >= params_.least_confidence) {
      boxes.push_back(*box);
    }
  }
  std::ranges::stable_sort(boxes, std::ranges::greater(), &Box::confidence);
  return WithoutRepeats(boxes);
}

LIMPET_REGISTER_DETECTOR(ColorShapeDetector, "color_shape");

}  // namespace limpet

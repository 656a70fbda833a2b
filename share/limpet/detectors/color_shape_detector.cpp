// SPDX-License-Identifier: MIT
#include "limpet/detectors/color_shape_detector.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/paint_classifier.hpp"

namespace limpet {
namespace {

constexpr int kSmallWidth = 160;     ///< of the reduced image, about
constexpr double kSmallNoise = 0.8;  ///< least standard deviation of its colours [levels]
constexpr double kFullNoise = 2.5;

/// OpenCV takes no const pixels: for what only reads them.
cv::Mat MatOf(const ImageView& image) {
  auto* pixels =
      const_cast<std::uint8_t*>(image.bgr);  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  return {image.height_px, image.width_px, CV_8UC3, pixels};
}

ImageView ViewOf(const cv::Mat& pixels) {
  return {pixels.ptr<std::uint8_t>(), pixels.cols, pixels.rows};
}

/// Means over `factor` x `factor` pixels; a remainder at the right and bottom is left out.
void Reduce(const cv::Mat& image, int factor, cv::Mat& reduced) {
  const cv::Size size(image.cols / factor, image.rows / factor);
  const cv::Rect whole(0, 0, size.width * factor, size.height * factor);
  cv::resize(image(whole), reduced, size, 0.0, 0.0, cv::INTER_AREA);
}

/// Of boxes that share more than half of the smaller one, the most confident.
std::vector<Box> WithoutRepeats(const std::vector<Box>& boxes) {
  const auto rect = [](const Box& box) {
    return PixelRect{box.u - 0.5 * box.w, box.v - 0.5 * box.h, box.u + 0.5 * box.w,
                     box.v + 0.5 * box.h};
  };
  std::vector<Box> kept;
  for (const Box& box : boxes) {
    const bool repeats = std::ranges::any_of(kept, [&box, &rect](const Box& other) {
      const double least = std::min(rect(box).area(), rect(other).area());
      return Intersection(rect(box), rect(other)).area() > 0.5 * least;
    });
    if (!repeats) {
      kept.push_back(box);
    }
  }
  return kept;
}

/// A cut ball may show its dim side only, where orange looks red or like nothing: there the light
/// it has decides.
std::optional<PaintClass> Classify(const Contrast& contrast, bool is_cut) {
  std::optional<PaintClass> paint = ClassifyPaint(contrast.inside - contrast.outside);
  if (is_cut && (!paint || paint->color == "red")) {
    const std::optional<PaintClass> lit = ClassifyPaint(contrast.lit - contrast.outside);
    return lit ? lit : paint;
  }
  return paint;
}

/// A ball's image is stretched away from the centre of the image by perspective: up to here.
double MostElongation(const Eigen::Vector2d& center, const ImageView& image) {
  const Eigen::Vector2d middle(0.5 * image.width_px, 0.5 * image.height_px);
  return 1.3 + 0.45 * (center - middle).squaredNorm() / middle.squaredNorm();
}

std::optional<Contrast> Settled(const ImageView& image,
                                const std::optional<RefinedOutline>& outline, double noise) {
  return outline ? MeasureContrast(image, outline->ellipse, noise) : std::nullopt;
}

/// Whether the refined outline is clearly larger or smaller than the guess.
bool HasMoved(const Ellipse& guess, const Ellipse& refined) {
  constexpr double kClearly = 0.04;
  return std::abs(guess.MeanRadius() / refined.MeanRadius() - 1.0) > kClearly;
}

/// Rises from 0 at `low` to 1 at `high`.
double Ramp(double value, double low, double high) {
  return std::clamp((value - low) / (high - low), 0.0, 1.0);
}

}  // namespace

ColorShapeDetector::ColorShapeDetector(const Params& params) : params_(params) {
  // The work on one image is too small to share among threads; and other processes want the cores.
  cv::setNumThreads(0);
}

void ColorShapeDetector::Shrink(const ImageView& image) {
  factor_ = std::max(1, (image.width_px + kSmallWidth / 2) / kSmallWidth);
  Reduce(MatOf(image), std::max(1, factor_ / 2), half_);
  // Not from the half: what it rounds off, faint colours need.
  Reduce(MatOf(image), factor_, small_);
}

bool ColorShapeDetector::Assess(const Blob& blob, Candidate& candidate) const {
  const bool touches_border =
      blob.left <= 0 || blob.top <= 0 || blob.right >= small_.cols || blob.bottom >= small_.rows;
  const double fullness = blob.fullness;
  if (fullness < (touches_border ? 0.78 : 0.86) ||
      blob.Elongation() > (touches_border ? 4.0 : 2.0)) {
    return false;
  }
  const Ellipse small = Ellipse::OfMoments(blob.center, blob.covariance);
  const std::optional<Contrast> contrast = MeasureContrast(ViewOf(small_), small, kSmallNoise);
  if (!contrast || contrast->separation < 3.0 || contrast->support < 0.6) {
    return false;
  }
  candidate.quality =
      fullness * contrast->support * contrast->separation / (contrast->separation + 4.0);
  candidate.ellipse = {small.center * factor_, small.axes * factor_};
  const double f = factor_;
  candidate.rect = {blob.left * f, blob.top * f, blob.right * f, blob.bottom * f};
  return true;
}

void ColorShapeDetector::CollectCandidates() {
  const double radius = params_.least_radius_px / factor_;
  const double least_area = std::max(6.0, 2.0 * radius * radius);
  const double most_area = 0.6 * static_cast<double>(small_.total());
  colors_.Fill(small_, kSmallNoise);
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

/// At the finest resolution at which the colour stands out from the noise: faint outlines need the
/// mean of more pixels.
std::optional<ColorShapeDetector::Finding> ColorShapeDetector::Refine(const ImageView& image,
                                                                      const Ellipse& guess) const {
  constexpr double kClear = 5.0;
  const int half = std::max(1, factor_ / 2);
  struct Scaled {
    ImageView view;
    int factor;
    double noise;
  };
  const std::array<Scaled, 3> pyramid{{{image, 1, kFullNoise},
                                       {ViewOf(half_), half, 0.6 * kFullNoise},
                                       {ViewOf(small_), factor_, kSmallNoise}}};
  for (const Scaled& scaled : pyramid) {
    const double f = scaled.factor;
    const Ellipse ellipse{guess.center / f, guess.axes / f};
    const std::optional<Contrast> contrast = MeasureContrast(scaled.view, ellipse, scaled.noise);
    const bool is_last = scaled.factor == factor_;
    if (!contrast || (!is_last && (contrast->separation < kClear))) {
      continue;
    }
    std::optional<RefinedOutline> outline = RefineOutline(scaled.view, ellipse, *contrast);
    std::optional<Contrast> settled = Settled(scaled.view, outline, scaled.noise);
    // What was measured about a poor guess misplaces edges; short arcs cannot tell, they drift.
    if (settled && !outline->IsCut() && HasMoved(ellipse, outline->ellipse)) {
      outline = RefineOutline(scaled.view, outline->ellipse, *settled);
      settled = Settled(scaled.view, outline, scaled.noise);
    }
    if (!outline || !settled) {
      return std::nullopt;
    }
    outline->ellipse = {outline->ellipse.center * f, outline->ellipse.axes * f};
    return Finding{*outline, *settled, scaled.factor};
  }
  return std::nullopt;
}

std::optional<Box> ColorShapeDetector::Verify(const ImageView& image,
                                              const Candidate& candidate) const {
  const std::optional<Finding> finding = Refine(image, candidate.ellipse);
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
  const double allowed = finding->AllowedWobble();
  const double wobble = outline.roughness * outline.ellipse.MeanRadius();
  const double stretch = is_cut ? 2.0 : MostElongation(outline.ellipse.center, image);
  const double shape = Ramp(outline.support, 0.4, 0.9) *
                       Ramp(stretch - outline.ellipse.Elongation(), 0.0, 0.1) *
                       Ramp(allowed - wobble, 0.0, 0.5 * allowed);
  const double color = Ramp(contrast.separation, 1.0, 6.0) * Ramp(contrast.support, 0.5, 0.95);
  return Box{.u = rect.center_u(),
             .v = rect.center_v(),
             .w = rect.width(),
             .h = rect.height(),
             .confidence = std::sqrt(std::sqrt(shape * color) * Ramp(paint->certainty, -0.5, 1.0)),
             .color = paint->color};
}

std::vector<Box> ColorShapeDetector::Detect(const ImageView& image) {
  constexpr int kLeastSide = 32;
  if (image.width_px < kLeastSide || image.height_px < kLeastSide) {
    return {};
  }
  Shrink(image);
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

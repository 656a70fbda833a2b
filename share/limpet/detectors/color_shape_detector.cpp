// SPDX-License-Identifier: MIT
#include "limpet/detectors/color_shape_detector.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/paint_classifier.hpp"

namespace limpet {
namespace {

constexpr int kSmallWidth = 160;     ///< of the reduced image, about
constexpr double kSmallNoise = 0.8;  ///< least standard deviation of its colours [levels]
constexpr double kFullNoise = 2.5;

/// Value below which `share` of the plane's pixels lie; every third pixel is asked.
std::int16_t Quantile(const Plane& plane, double share) {
  std::vector<std::int16_t> sample;
  sample.reserve(plane.values.size() / 3 + 1);
  for (std::size_t i = 0; i < plane.values.size(); i += 3) {
    sample.push_back(plane.values[i]);
  }
  const auto middle =
      sample.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sample.size() - 1));
  std::ranges::nth_element(sample, middle);
  return *middle;
}

/// Levels from just above the background's spread to the brightest pixel.
std::vector<int> LevelsOf(const Plane& plane) {
  constexpr double kFirst = 2.0;  // in spreads above the median
  constexpr double kGrowth = 1.25;
  const double median = Quantile(plane, 0.5);
  // The darker half: objects do not widen it.
  const double spread = std::max(median - Quantile(plane, 0.16), 4.0);
  const int brightest = *std::ranges::max_element(plane.values);
  std::vector<int> levels;
  for (double step = kFirst * spread; median + step < brightest; step *= kGrowth) {
    levels.push_back(static_cast<int>(median + step));
  }
  return levels;
}

/// Squared distance of every pixel's colour from the scene's usual colours.
class UsualColors {
 public:
  explicit UsualColors(const Image& image) {
    const auto pixels =
        static_cast<std::size_t>(image.width_px) * static_cast<std::size_t>(image.height_px);
    // Three rounds: each forgets what the one before found unusual.
    for (double limit : {1e9, 9.0, 9.0}) {
      double count = 0.0;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
      for (std::size_t i = 0; i < pixels; i += 7) {
        const Eigen::Vector3d color = ColorOf(&image.bgr[3 * i]);
        if (Distance2(color) < limit) {
          count += 1.0;
          sum += color;
          squares += color * color.transpose();
        }
      }
      if (count < 30.0) {
        return;
      }
      mean_ = sum / count;
      const Eigen::Matrix3d covariance = squares / count - mean_ * mean_.transpose() +
                                         kSmallNoise * kSmallNoise * Eigen::Matrix3d::Identity();
      whiten_ = covariance.llt().matrixL().solve(Eigen::Matrix3d::Identity().eval());
    }
  }
  [[nodiscard]] static Eigen::Vector3d ColorOf(const std::uint8_t* bgr) {
    return {static_cast<double>(bgr[0]), static_cast<double>(bgr[1]), static_cast<double>(bgr[2])};
  }
  [[nodiscard]] double Distance2(const Eigen::Vector3d& color) const {
    return (whiten_ * (color - mean_)).squaredNorm();
  }

 private:
  Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d whiten_ = Eigen::Matrix3d::Zero();
};

/// Means over `factor` x `factor` pixels; a remainder at the right and bottom is left out.
void Reduce(const ImageView& image, int factor, Image& reduced) {
  reduced.width_px = image.width_px / factor;
  reduced.height_px = image.height_px / factor;
  reduced.bgr.resize(3 * static_cast<std::size_t>(reduced.width_px) *
                     static_cast<std::size_t>(reduced.height_px));
  // OpenCV takes no const pixels, but resize leaves its source alone.
  const cv::Mat full(
      image.height_px, image.width_px, CV_8UC3,
      const_cast<std::uint8_t*>(image.bgr));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  cv::Mat target(reduced.height_px, reduced.width_px, CV_8UC3, reduced.bgr.data());
  const cv::Rect whole(0, 0, reduced.width_px * factor, reduced.height_px * factor);
  cv::resize(full(whole), target, target.size(), 0.0, 0.0, cv::INTER_AREA);
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

/// Rises from 0 at `low` to 1 at `high`.
double Ramp(double value, double low, double high) {
  return std::clamp((value - low) / (high - low), 0.0, 1.0);
}

}  // namespace

void ColorShapeDetector::Shrink(const ImageView& image) {
  factor_ = std::max(1, (image.width_px + kSmallWidth / 2) / kSmallWidth);
  Reduce(image, std::max(1, factor_ / 2), half_);
  Reduce(image, factor_, small_);
}

/// Four planes: yellowness, redness and greenness (differences over the sum, so that shading drops
/// out), and distance from the scene's usual colours.
void ColorShapeDetector::FillPlanes() {
  const std::size_t pixels = small_.bgr.size() / 3;
  planes_.resize(4);
  for (Plane& plane : planes_) {
    plane.width = small_.width_px;
    plane.height = small_.height_px;
    plane.values.resize(pixels);
  }
  const UsualColors usual(small_);
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint8_t* bgr = &small_.bgr[3 * i];
    const float blue = bgr[0];
    const float green = bgr[1];
    const float red = bgr[2];
    const float scale = 2048.0F / (blue + green + red + 48.0F);
    planes_[0].values[i] = static_cast<std::int16_t>((0.5F * (red + green) - blue) * scale);
    planes_[1].values[i] = static_cast<std::int16_t>((red - green) * scale);
    planes_[2].values[i] = static_cast<std::int16_t>((green - 0.5F * (red + blue)) * scale);
    planes_[3].values[i] = static_cast<std::int16_t>(
        std::min(16.0 * std::sqrt(usual.Distance2(UsualColors::ColorOf(bgr))), 30000.0));
  }
}

bool ColorShapeDetector::Assess(const Blob& blob, Candidate& candidate) const {
  const bool touches_border = blob.left <= 0 || blob.top <= 0 || blob.right >= small_.width_px ||
                              blob.bottom >= small_.height_px;
  const double fullness = blob.Fullness();
  if (fullness < (touches_border ? 0.78 : 0.86) ||
      blob.Elongation() > (touches_border ? 4.0 : 2.0)) {
    return false;
  }
  const Ellipse small = Ellipse::OfMoments(blob.center, blob.covariance);
  const std::optional<Contrast> contrast = MeasureContrast(small_.view(), small, kSmallNoise);
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

void ColorShapeDetector::CollectCandidates(const Plane& plane,
                                           std::vector<Candidate>& candidates) const {
  const double radius = params_.least_radius_px / factor_;
  const double least_area = std::max(6.0, 2.0 * radius * radius);
  const double most_area = 0.6 * small_.width_px * small_.height_px;
  std::vector<Blob> blobs;
  for (const int level : LevelsOf(plane)) {
    FindBlobs(plane, level, least_area, blobs);
  }
  for (const Blob& blob : blobs) {
    Candidate candidate;
    if (blob.area <= most_area && Assess(blob, candidate)) {
      candidates.push_back(candidate);
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
                                       {half_.view(), half, 0.6 * kFullNoise},
                                       {small_.view(), factor_, kSmallNoise}}};
  for (const Scaled& scaled : pyramid) {
    const double f = scaled.factor;
    const Ellipse ellipse{guess.center / f, guess.axes / f};
    const std::optional<Contrast> contrast = MeasureContrast(scaled.view, ellipse, scaled.noise);
    const bool is_last = scaled.factor == factor_;
    if (!contrast || (!is_last && (contrast->separation < kClear))) {
      continue;
    }
    std::optional<RefinedOutline> outline = RefineOutline(scaled.view, ellipse, *contrast);
    if (!outline) {
      return std::nullopt;
    }
    const std::optional<Contrast> settled =
        MeasureContrast(scaled.view, outline->ellipse, scaled.noise);
    if (!settled) {
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
  const bool is_cut = outline.sides < 0.8;
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
  FillPlanes();
  std::vector<Candidate> candidates;
  for (const Plane& plane : planes_) {
    CollectCandidates(plane, candidates);
  }
  std::ranges::stable_sort(candidates, std::ranges::greater(), &Candidate::quality);
  std::vector<Candidate> chosen;
  std::vector<Box> boxes;
  for (const Candidate& candidate : candidates) {
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

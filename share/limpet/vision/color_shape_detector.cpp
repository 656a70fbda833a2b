// SPDX-License-Identifier: MIT
#include "limpet/vision/color_shape_detector.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

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

}  // namespace

void ColorShapeDetector::Shrink(const ImageView& image) {
  factor_ = std::max(1, (image.width_px + kSmallWidth / 2) / kSmallWidth);
  small_.width_px = image.width_px / factor_;
  small_.height_px = image.height_px / factor_;
  small_.bgr.resize(3 * static_cast<std::size_t>(small_.width_px) *
                    static_cast<std::size_t>(small_.height_px));
  // OpenCV takes no const pixels, but resize leaves its source alone.
  const cv::Mat full(
      image.height_px, image.width_px, CV_8UC3,
      const_cast<std::uint8_t*>(image.bgr));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  cv::Mat reduced(small_.height_px, small_.width_px, CV_8UC3, small_.bgr.data());
  const cv::Rect whole(0, 0, small_.width_px * factor_, small_.height_px * factor_);
  cv::resize(full(whole), reduced, reduced.size(), 0.0, 0.0, cv::INTER_AREA);
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
  const double radius = settings_.least_radius_px / factor_;
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

bool ColorShapeDetector::Verify(const ImageView& image, const Candidate& candidate,
                                Box& box) const {
  const std::optional<Contrast> first = MeasureContrast(image, candidate.ellipse, kFullNoise);
  if (!first) {
    return false;
  }
  const std::optional<RefinedOutline> outline = RefineOutline(image, candidate.ellipse, *first);
  if (!outline || outline->support < 0.5 || outline->sides < 0.25 ||
      outline->ellipse.Elongation() > 1.9 ||
      outline->ellipse.MeanRadius() < settings_.least_radius_px) {
    return false;
  }
  const std::optional<Contrast> contrast = MeasureContrast(image, outline->ellipse, kFullNoise);
  if (!contrast) {
    return false;
  }
  const std::optional<PaintClass> paint = ClassifyPaint(*contrast);
  if (!paint) {
    return false;
  }
  const PixelRect rect = outline->ellipse.VisiblePart(image.width_px, image.height_px);
  if (rect.area() <= 0.0) {
    return false;
  }
  box = {.u = rect.center_u(),
         .v = rect.center_v(),
         .w = rect.width(),
         .h = rect.height(),
         .confidence = contrast->support * outline->support,
         .color = paint->color};
  if (getenv("DBG")) {
    const Eigen::Vector3d d = contrast->inside - contrast->outside;
    printf(
        "cand q %.2f rect %.0f %.0f %.0f %.0f | sup %.2f sides %.2f rough %.3f elong %.2f r %.1f | "
        "sep %.1f csup %.2f | dB %.0f dG %.0f dR %.0f | out %.0f %.0f %.0f\n",
        candidate.quality, rect.left, rect.top, rect.width(), rect.height(), outline->support,
        outline->sides, outline->roughness, outline->ellipse.Elongation(),
        outline->ellipse.MeanRadius(), contrast->separation, contrast->support, d(0), d(1), d(2),
        contrast->outside(0), contrast->outside(1), contrast->outside(2));
  }
  return box.confidence >= settings_.least_confidence;
}

std::vector<Box> ColorShapeDetector::Detect(const ImageView& image) {
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
    Box box;
    if (Verify(image, candidate, box)) {
      boxes.push_back(box);
    }
  }
  std::ranges::stable_sort(boxes, std::ranges::greater(), &Box::confidence);
  return boxes;
}

}  // namespace limpet

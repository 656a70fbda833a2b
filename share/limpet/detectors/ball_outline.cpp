// SPDX-License-Identifier: MIT
#include "limpet/detectors/ball_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>
#include <opencv2/imgproc.hpp>

#include "limpet/detectors/ramp.hpp"
#include "limpet/vision/image_mat.hpp"

namespace limpet {
namespace {

constexpr int kSmallWidth = 160;  ///< of the reduced image, about
constexpr double kFullNoise = 2.5;

/// Means over `factor` x `factor` pixels; a remainder at the right and bottom is left out.
void Reduce(const cv::Mat& image, int factor, cv::Mat& reduced) {
  const cv::Size size(image.cols / factor, image.rows / factor);
  const cv::Rect whole(0, 0, size.width * factor, size.height * factor);
  cv::resize(image(whole), reduced, size, 0.0, 0.0, cv::INTER_AREA);
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

}  // namespace

double BallOutline::Roundness(const ImageView& image) const {
  const double radius = outline.ellipse.MeanRadius();
  // Distance of edges from the ellipse [px] at which nothing speaks for a ball any more.
  const double allowed = std::min(0.10 * radius, 1.3 + 0.4 * factor + 0.01 * radius);
  const double wobble = outline.roughness * radius;
  const double stretch = outline.IsCut() ? 2.0 : MostElongation(outline.ellipse.center, image);
  return Ramp(outline.support, {0.4, 0.9}) *
         Ramp(stretch - outline.ellipse.Elongation(), {0.0, 0.1}) *
         Ramp(allowed - wobble, {0.0, 0.5 * allowed});
}

void BallOutlines::Take(const ImageView& image) {
  image_ = image;
  factor_ = std::max(1, (image.width_px + kSmallWidth / 2) / kSmallWidth);
  Reduce(MatOf(image), std::max(1, factor_ / 2), half_);
  // Not from the half: what it rounds off, faint colours need.
  Reduce(MatOf(image), factor_, small_);
}

std::optional<BallOutline> BallOutlines::Find(const Ellipse& guess) const {
  constexpr double kClear = 5.0;
  const int half = std::max(1, factor_ / 2);
  struct Scaled {
    ImageView view;
    int factor;
    double noise;
  };
  const std::array<Scaled, 3> pyramid{{{image_, 1, kFullNoise},
                                       {ViewOf(half_), half, 0.6 * kFullNoise},
                                       {ViewOf(small_), factor_, kSmallNoise}}};
  for (const Scaled& scaled : pyramid) {
    const double f = scaled.factor;
    const Ellipse ellipse{guess.center / f, guess.axes / f};
    const std::optional<Contrast> contrast = MeasureContrast(scaled.view, ellipse, scaled.noise);
    const bool is_last = scaled.factor == factor_;
    if (!contrast || (!is_last && (contrast->separation < kClear))) continue;
    std::optional<RefinedOutline> outline = RefineOutline(scaled.view, ellipse, *contrast);
    std::optional<Contrast> settled = Settled(scaled.view, outline, scaled.noise);
    // What was measured about a poor guess misplaces edges; short arcs cannot tell, they drift.
    if (settled && !outline->IsCut() && HasMoved(ellipse, outline->ellipse)) {
      outline = RefineOutline(scaled.view, outline->ellipse, *settled);
      settled = Settled(scaled.view, outline, scaled.noise);
    }
    if (!outline || !settled) return std::nullopt;
    outline->ellipse = {outline->ellipse.center * f, outline->ellipse.axes * f};
    return BallOutline{.outline = *outline, .contrast = *settled, .factor = scaled.factor};
  }
  return std::nullopt;
}

}  // namespace limpet

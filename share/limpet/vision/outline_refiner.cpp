// SPDX-License-Identifier: MIT
#include "limpet/vision/outline_refiner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace limpet {
namespace {

constexpr int kDirections = 48;

using Direction = Eigen::Vector2d;  ///< of length one
const std::array<Direction, kDirections>& Directions() {
  static const std::array<Direction, kDirections> all = [] {
    std::array<Direction, kDirections> directions;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kDirections;
      directions[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
    }
    return directions;
  }();
  return all;
}

bool IsInside(const ImageView& image, const Eigen::Vector2d& p) {
  return p.x() >= 0.0 && p.y() >= 0.0 && p.x() < image.width_px && p.y() < image.height_px;
}

Eigen::Vector3d ColorAt(const ImageView& image, const Eigen::Vector2d& p) {
  const std::uint8_t* pixel = image.pixel(static_cast<int>(p.x()), static_cast<int>(p.y()));
  return {static_cast<double>(pixel[0]), static_cast<double>(pixel[1]),
          static_cast<double>(pixel[2])};
}

/// Colours and where they were seen, in radii from the centre.
struct SampleSet {
  std::array<Eigen::Vector3d, kDirections> colors;
  std::array<Eigen::Vector2d, kDirections> places;
  std::size_t size = 0;

  [[nodiscard]] Eigen::Vector3d Color() const { return Mean(colors); }
  /// Mean of the brighter half.
  [[nodiscard]] Eigen::Vector3d LitColor() const {
    std::array<Eigen::Vector3d, kDirections> sorted = colors;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(size / 2);
    std::nth_element(
        sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(size),
        [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.sum() > b.sum(); });
    const Eigen::Vector3d sum =
        std::accumulate(sorted.begin(), middle, Eigen::Vector3d(Eigen::Vector3d::Zero()));
    return sum / static_cast<double>(size / 2);
  }
  [[nodiscard]] Eigen::Vector2d Place() const { return Mean(places); }
  [[nodiscard]] Eigen::Matrix3d Covariance() const {
    const Eigen::Vector3d mean = Color();
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < size; ++i) {
      sum += (colors[i] - mean) * (colors[i] - mean).transpose();
    }
    return sum / static_cast<double>(size);
  }

 private:
  template <class V>
  [[nodiscard]] V Mean(const std::array<V, kDirections>& all) const {
    V sum = V::Zero();
    for (std::size_t i = 0; i < size; ++i) {
      sum += all[i];
    }
    return sum / static_cast<double>(size);
  }
};

/// Every second direction of two rings, as far as they lie inside the image.
SampleSet SampleRings(const ImageView& image, const Ellipse& ellipse,
                      const std::array<double, 2>& scales) {
  SampleSet samples;
  for (std::size_t i = 0; i < kDirections; i += 2) {
    const Direction& direction = Directions()[i];
    for (const double scale : scales) {
      const Eigen::Vector2d p = ellipse.At(direction, scale);
      if (IsInside(image, p)) {
        samples.colors[samples.size] = ColorAt(image, p);
        samples.places[samples.size++] = scale * direction;
      }
    }
  }
  return samples;
}

/// Change of colour per radius; short arcs, which cannot tell, give less.
using Trend = Eigen::Matrix<double, 3, 2>;
Trend TrendOf(const SampleSet& samples) {
  const Eigen::Vector3d color = samples.Color();
  const Eigen::Vector2d place = samples.Place();
  Eigen::Matrix2d normal = 0.1 * static_cast<double>(samples.size) * Eigen::Matrix2d::Identity();
  Trend right = Trend::Zero();
  for (std::size_t i = 0; i < samples.size; ++i) {
    const Eigen::Vector2d offset = samples.places[i] - place;
    normal += offset * offset.transpose();
    right += (samples.colors[i] - color) * offset.transpose();
  }
  return right * normal.inverse();
}

/// Where on one ray from the centre, in radii, the projected colour falls half way from the inside
/// to the outside of this very ray. Nothing at the image's border or without an edge.
class RayEdge {
 public:
  RayEdge(const ImageView& image, const Ellipse& guess, const Contrast& contrast)
      : image_(&image), guess_(&guess), contrast_(&contrast) {
    radius_ = guess.MeanRadius();
    steps_ = std::clamp(static_cast<int>(radius_ * (kLast - kFirst)), 12, 64);
    step_ = (kLast - kFirst) / steps_;
    profile_.resize(static_cast<std::size_t>(steps_));
    full_ = contrast.weights.dot(contrast.inside - contrast.outside);
  }

  [[nodiscard]] bool LeavesImage(const Direction& direction) const {
    return !IsInside(*image_, guess_->At(direction, 1.0));
  }

  [[nodiscard]] std::optional<double> Find(const Direction& direction) {
    int count = 0;
    for (; count < steps_; ++count) {
      const Eigen::Vector2d p = guess_->At(direction, kFirst + (count + 0.5) * step_);
      if (!IsInside(*image_, p)) {
        break;
      }
      profile_[static_cast<std::size_t>(count)] =
          contrast_->weights.dot(ColorAt(*image_, p) - contrast_->outside) / full_;
    }
    return EdgeOf(count);
  }

 private:
  static constexpr double kFirst = 0.55;
  static constexpr double kLast = 1.55;

  /// The split of the profile into two levels with the least squared error; its edge must be steep
  /// enough to be one.
  [[nodiscard]] std::optional<double> EdgeOf(int count) const {
    if (count < steps_ / 2) {
      return std::nullopt;
    }
    const double total = std::accumulate(profile_.begin(), profile_.begin() + count, 0.0);
    const int margin = std::max(2, count / 10);
    double best = 0.0;
    int best_split = 0;
    double inner = std::accumulate(profile_.begin(), profile_.begin() + margin - 1, 0.0);
    for (int split = margin; split <= count - margin; ++split) {
      inner += profile_[static_cast<std::size_t>(split - 1)];
      const double drop = inner / split - (total - inner) / (count - split);
      // Between-class variance, as in Otsu's threshold.
      const double score = drop > 0.0 ? drop * drop * split * (count - split) : 0.0;
      if (score > best) {
        best = score;
        best_split = split;
      }
    }
    if (best <= 0.0) {
      return std::nullopt;
    }
    const double drop = std::sqrt(best / best_split / (count - best_split));
    constexpr double kLeastDrop = 0.35;
    if (drop < kLeastDrop) {
      return std::nullopt;
    }
    return Sharpen(best_split, count);
  }

  /// Moves the split to where the profile crosses the mean of its two sides near it.
  [[nodiscard]] double Sharpen(int split, int count) const {
    const int reach = std::clamp(steps_ / 8, 2, 8);
    const int begin = std::max(0, split - reach);
    const int end = std::min(count, split + reach);
    const auto mean = [this](int from, int to) {
      return std::accumulate(profile_.begin() + from, profile_.begin() + to, 0.0) /
             std::max(to - from, 1);
    };
    const double high = mean(begin, std::max(split - 1, begin + 1));
    const double low = mean(std::min(split + 1, end - 1), end);
    if (high - low < 0.1) {
      return kFirst + split * step_;
    }
    // The area under the normalised profile is the edge's place: averages the noise of all samples.
    double above = 0.0;
    for (int i = begin; i < end; ++i) {
      above += std::clamp((profile_[static_cast<std::size_t>(i)] - low) / (high - low), -0.5, 1.5);
    }
    return kFirst + (begin + above) * step_;
  }

  const ImageView* image_;
  const Ellipse* guess_;
  const Contrast* contrast_;
  double radius_;
  int steps_;
  double step_;
  double full_;
  std::vector<double> profile_;
};

struct Edges {
  std::vector<Eigen::Vector2d> points;
  int inside = 0;  ///< directions whose edge should be inside the image
};

Edges FindEdges(const ImageView& image, const Ellipse& guess, const Contrast& contrast) {
  Edges edges;
  RayEdge ray(image, guess, contrast);
  for (const Direction& direction : Directions()) {
    if (!ray.LeavesImage(direction)) {
      ++edges.inside;
    }
    if (const std::optional<double> scale = ray.Find(direction)) {
      edges.points.push_back(guess.At(direction, *scale));
    }
  }
  return edges;
}

/// Fits, drops what lies off the ellipse, and fits again.
std::optional<Ellipse> FitTrimmed(std::vector<Eigen::Vector2d>& points, const Ellipse& guess) {
  std::optional<Ellipse> ellipse = guess;
  for (const double tolerance : {0.25, 0.12, 0.08}) {
    ellipse = FitEllipse(points, *ellipse);
    if (!ellipse) {
      return std::nullopt;
    }
    const double allowed = std::max(tolerance, 1.5 / ellipse->MeanRadius());
    std::erase_if(points, [&ellipse, allowed](const Eigen::Vector2d& point) {
      return std::abs(ellipse->Scale(point) - 1.0) > allowed;
    });
  }
  return FitEllipse(points, *ellipse);
}

}  // namespace

std::optional<Contrast> MeasureContrast(const ImageView& image, const Ellipse& ellipse,
                                        double noise) {
  const SampleSet inside = SampleRings(image, ellipse, {0.3, 0.75});
  SampleSet outside = SampleRings(image, ellipse, {1.25, 1.45});
  if (inside.size < 12 || outside.size < kDirections / 4) {
    return std::nullopt;
  }
  // Vignette and haze change the water's colour across the object: compare with the colour that
  // the ring's trend has at the inside samples.
  const Trend trend = TrendOf(outside);
  for (std::size_t i = 0; i < outside.size; ++i) {
    outside.colors[i] += trend * (inside.Place() - outside.places[i]);
  }
  const Eigen::Vector3d difference = inside.Color() - outside.Color();
  const Eigen::Matrix3d spread = 0.5 * (inside.Covariance() + outside.Covariance()) +
                                 noise * noise * Eigen::Matrix3d::Identity();
  Contrast contrast;
  contrast.inside = inside.Color();
  contrast.lit = inside.LitColor();
  contrast.outside = outside.Color();
  contrast.weights = spread.llt().solve(difference);
  const double full = contrast.weights.dot(difference);
  contrast.separation = std::sqrt(std::max(full, 0.0));
  int different = 0;
  for (std::size_t i = 0; i < outside.size; ++i) {
    different += contrast.weights.dot(contrast.inside - outside.colors[i]) > 0.5 * full ? 1 : 0;
  }
  contrast.support = static_cast<double>(different) / static_cast<double>(outside.size);
  return contrast;
}

std::optional<RefinedOutline> RefineOutline(const ImageView& image, const Ellipse& guess,
                                            const Contrast& contrast) {
  RefinedOutline outline{.ellipse = guess};
  for (int round = 0; round < 2; ++round) {
    Edges edges = FindEdges(image, outline.ellipse, contrast);
    const std::optional<Ellipse> fitted = FitTrimmed(edges.points, outline.ellipse);
    if (!fitted || edges.inside == 0) {
      return std::nullopt;
    }
    outline.ellipse = *fitted;
    const auto count = static_cast<double>(edges.points.size());
    outline.support = std::min(count / edges.inside, 1.0);
    outline.sides = count / kDirections;
    double squares = 0.0;
    for (const Eigen::Vector2d& point : edges.points) {
      const double off = fitted->Scale(point) - 1.0;
      squares += off * off;
    }
    outline.roughness = count > 0.0 ? std::sqrt(squares / count) : 1.0;
  }
  return outline;
}

}  // namespace limpet

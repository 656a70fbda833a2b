// SPDX-License-Identifier: MIT
#include "training/detector/studio_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "limpet/objects/color_table.hpp"

namespace limpet {
namespace {

constexpr int kSubpixelBits = 4;

cv::Point Fixed(const cv::Point2f& point, const cv::Rect& area) {
  constexpr float kScale = 1 << kSubpixelBits;
  return {cvRound((point.x - static_cast<float>(area.x)) * kScale),
          cvRound((point.y - static_cast<float>(area.y)) * kScale)};
}

/// The area around the points and `margin` more, within the canvas.
cv::Rect AreaOf(std::span<const cv::Point2f> points, double margin) {
  float left = 1e9F;
  float right = -1e9F;
  float top = 1e9F;
  float bottom = -1e9F;
  for (const cv::Point2f& point : points) {
    left = std::min(left, point.x);
    right = std::max(right, point.x);
    top = std::min(top, point.y);
    bottom = std::max(bottom, point.y);
  }
  const auto more = static_cast<float>(margin + 1.0);
  const cv::Point first(cvFloor(left - more), cvFloor(top - more));
  const cv::Point last(cvCeil(right + more), cvCeil(bottom + more));
  return cv::Rect(first, last) & cv::Rect(0, 0, StudioCanvas::kWidth, StudioCanvas::kHeight);
}

}  // namespace

double DrawLog(double low, double high, Random& random) {
  return low * std::pow(high / low, random.Uniform(0.0, 1.0));
}

cv::Point2f DrawPlace(Random& random) {
  return {static_cast<float>(random.Uniform(0.0, StudioCanvas::kWidth)),
          static_cast<float>(random.Uniform(0.0, StudioCanvas::kHeight))};
}

cv::Vec3f DrawPaint(std::string_view name, Random& random) {
  const Albedo paint = AlbedoOf(name).value();
  cv::Vec3f color(paint[0], paint[1], paint[2]);
  const auto white = static_cast<float>(random.Chance(0.5) ? 0.0 : random.Uniform(0.0, 0.35));
  const auto shade = static_cast<float>(random.Uniform(0.7, 1.15));
  for (int c = 0; c < 3; ++c) {
    const auto own = static_cast<float>(std::exp(random.Normal(0.12)));
    color[c] = std::min(shade * ((1.0F - white) * color[c] * own + white * 0.8F), 1.0F);
  }
  return color;
}

cv::Vec3f DrawAnyColor(Random& random) {
  const auto value = static_cast<float>(DrawLog(0.02, 0.9, random));
  const double spread = random.Chance(0.5) ? 0.25 : 1.0;
  cv::Vec3f color;
  for (int c = 0; c < 3; ++c)
    color[c] = std::min(value * static_cast<float>(std::exp(random.Normal(spread))), 1.0F);
  // Natural things are browner than blue.
  if (spread < 0.5) color[0] *= static_cast<float>(random.Uniform(0.4, 1.0));
  return color;
}

cv::Mat1f DrawNoise(const NoiseGrain& grain, Random& random) {
  cv::Mat1f sum(StudioCanvas::kHeight, StudioCanvas::kWidth, 0.0F);
  double weight = 1.0;
  double total = 0.0;
  for (int octave = 0; octave < grain.octaves; ++octave) {
    const double scale = std::pow(2.0, octave);
    const cv::Size size(std::clamp(cvCeil(grain.across * scale), 2, StudioCanvas::kWidth),
                        std::clamp(cvCeil(grain.down * scale), 2, StudioCanvas::kHeight));
    cv::Mat1f cells(size);
    for (float& value : cells)
      value = static_cast<float>(random.Uniform(-1.0, 1.0));
    cv::Mat1f smooth;
    cv::resize(cells, smooth, sum.size(), 0.0, 0.0, cv::INTER_CUBIC);
    cv::scaleAdd(smooth, weight, sum, sum);
    total += weight * weight;
    weight *= grain.decay;
  }
  sum *= 1.5 / std::sqrt(total);
  return sum;
}

void PaintMask(StudioCanvas& canvas, const cv::Mat1b& mask, const cv::Rect& area,
               const StudioSurface& surface, Random& random) {
  if (area.empty()) return;
  cv::Mat1f texture;
  if (surface.mottle > 0.0F) {
    const double cells = DrawLog(4.0, 60.0, random);
    texture = DrawNoise({cells, cells, 2, 0.6}, random)(area);
  }
  for (int row = 0; row < area.height; ++row) {
    const std::uint8_t* cover = mask[row];
    auto* light = canvas.light[area.y + row] + area.x;
    for (int column = 0; column < area.width; ++column) {
      if (cover[column] == 0) continue;
      const float share = static_cast<float>(cover[column]) / 255.0F;
      const float shade =
          texture.empty() ? 1.0F : std::max(0.1F, 1.0F + surface.mottle * texture(row, column));
      const cv::Vec3f seen = surface.clarity * canvas.brightness * shade * surface.color +
                             (1.0F - surface.clarity) * canvas.water;
      light[column] += share * (seen - light[column]);
    }
  }
}

void PaintPolygon(StudioCanvas& canvas, std::span<const cv::Point2f> corners,
                  const StudioSurface& surface, Random& random) {
  const cv::Rect area = AreaOf(corners, 1.0);
  if (area.empty()) return;
  std::vector<cv::Point> fixed;
  for (const cv::Point2f& corner : corners)
    fixed.push_back(Fixed(corner, area));
  cv::Mat1b mask(area.size(), std::uint8_t{0});
  cv::fillPoly(mask, std::vector<std::vector<cv::Point>>{fixed}, cv::Scalar(255), cv::LINE_AA,
               kSubpixelBits);
  PaintMask(canvas, mask, area, surface, random);
}

void PaintStroke(StudioCanvas& canvas, std::span<const cv::Point2f> points, double width,
                 const StudioSurface& surface, Random& random) {
  const cv::Rect area = AreaOf(points, width);
  if (area.empty()) return;
  std::vector<cv::Point> fixed;
  for (const cv::Point2f& point : points)
    fixed.push_back(Fixed(point, area));
  cv::Mat1b mask(area.size(), std::uint8_t{0});
  cv::polylines(mask, fixed, false, cv::Scalar(255), std::max(1, cvRound(width)), cv::LINE_AA,
                kSubpixelBits);
  PaintMask(canvas, mask, area, surface, random);
}

}  // namespace limpet

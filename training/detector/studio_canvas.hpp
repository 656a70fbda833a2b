// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include <opencv2/core.hpp>

#include "limpet/core/random.hpp"

namespace limpet {

/// A picture in the making: linear light, blue, green, red, 1 for a white surface in the sun; and
/// what the water looks like that things fade into.
struct StudioCanvas {
  static constexpr int kWidth = 640;
  static constexpr int kHeight = 480;
  cv::Mat3f light = cv::Mat3f(kHeight, kWidth);
  cv::Vec3f water{0.2F, 0.3F, 0.1F};
  cv::Vec2f towards_light{0.0F, -1.0F};  ///< in the picture
  float brightness = 0.8F;               ///< of light on things
};

/// A number drawn between `low` and `high`, likelier to be small.
[[nodiscard]] double DrawLog(double low, double high, Random& random);
[[nodiscard]] cv::Point2f DrawPlace(Random& random);
/// A paint as it may be made, aged and lit: that of `name` in the table with another shade.
[[nodiscard]] cv::Vec3f DrawPaint(std::string_view name, Random& random);
/// Any colour; half of them are natural: grey, brown, olive.
[[nodiscard]] cv::Vec3f DrawAnyColor(Random& random);

/// How fine noise is.
struct NoiseGrain {
  double across = 2.0, down = 2.0;  ///< cells of the coarsest octave
  int octaves = 1;                  ///< each further one is twice as fine
  double decay = 0.5;               ///< and by this as strong
};

/// Smooth noise with mean 0 and values mostly in -1 .. 1, as large as the canvas.
[[nodiscard]] cv::Mat1f DrawNoise(const NoiseGrain& grain, Random& random);

/// How a flat thing looks.
struct StudioSurface {
  cv::Vec3f color;
  float clarity = 1.0F;  ///< share of its colour that water lets through
  float mottle = 0.0F;   ///< contrast of its texture
};

/// Where `mask` (0 to 255, as large as `area`) covers, the surface replaces what was there.
void PaintMask(StudioCanvas& canvas, const cv::Mat1b& mask, const cv::Rect& area,
               const StudioSurface& surface, Random& random);
/// A filled polygon with soft edges.
void PaintPolygon(StudioCanvas& canvas, std::span<const cv::Point2f> corners,
                  const StudioSurface& surface, Random& random);
/// A stroke through `points`, `width` pixels wide.
void PaintStroke(StudioCanvas& canvas, std::span<const cv::Point2f> points, double width,
                 const StudioSurface& surface, Random& random);

}  // namespace limpet

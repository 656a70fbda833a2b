// SPDX-License-Identifier: MIT
#include "training/detector/studio_backdrop.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace limpet {
namespace {

cv::Vec3f DrawWater(Random& random) {
  // Blue, green, red of clear, green, brown and grey water.
  constexpr std::array<std::array<float, 3>, 5> kWaters{{{0.75F, 0.42F, 0.10F},
                                                         {0.45F, 0.50F, 0.18F},
                                                         {0.32F, 0.50F, 0.22F},
                                                         {0.16F, 0.34F, 0.30F},
                                                         {0.40F, 0.42F, 0.36F}}};
  const auto& water = kWaters.at(random.Index(kWaters.size()));
  const auto value = static_cast<float>(DrawLog(0.1, 1.0, random));
  cv::Vec3f color;
  for (int c = 0; c < 3; ++c) {
    color[c] = value * water.at(static_cast<std::size_t>(c)) *
               static_cast<float>(std::exp(random.Normal(0.25)));
  }
  return color;
}

/// Paints water from a colour above to one below, with slow clouds of light.
void PaintWater(StudioCanvas& canvas, Random& random) {
  const bool looks_ahead = random.Chance(0.7);
  const auto above = static_cast<float>(looks_ahead ? DrawLog(0.8, 3.0, random) : 1.0);
  const auto below = static_cast<float>(looks_ahead ? DrawLog(0.3, 1.1, random) : 1.0);
  const auto warmth = static_cast<float>(looks_ahead ? random.Uniform(0.0, 0.5) : 0.0);
  const auto curve = static_cast<float>(random.Uniform(0.6, 2.5));
  const double down = random.Uniform(1.5, 4.0), across = random.Uniform(1.5, 4.0);
  const cv::Mat1f clouds = DrawNoise({across, down, 2, 0.5}, random);
  const auto cloudy = static_cast<float>(random.Uniform(0.0, 0.35));
  for (int row = 0; row < canvas.light.rows; ++row) {
    const float height =
        std::pow(1.0F - static_cast<float>(row) / static_cast<float>(canvas.light.rows), curve);
    const float level = below + (above - below) * height;
    cv::Vec3f color = level * canvas.water;
    color[2] += warmth * height * canvas.water[1];  // near the surface, red is not lost yet
    for (int column = 0; column < canvas.light.cols; ++column)
      canvas.light(row, column) = std::max(0.05F, 1.0F + cloudy * clouds(row, column)) * color;
  }
}

/// The surface from below: torn bright patches, drawn out along the waves, thickest at the top.
void PaintSurface(StudioCanvas& canvas, Random& random) {
  const auto reach = random.Uniform(0.15, 0.8) * canvas.light.rows;
  const double rough = random.Uniform(0.5, 0.8);
  const double down = random.Uniform(6.0, 40.0), across = random.Uniform(3.0, 12.0);
  const cv::Mat1f waves = DrawNoise({across, down, 4, rough}, random);
  const auto level = static_cast<float>(random.Uniform(0.3, 0.9));
  const auto strength = static_cast<float>(random.Uniform(0.3, 2.0));
  cv::Vec3f color(0.6F, 0.9F, 1.0F);
  for (int c = 0; c < 3; ++c)
    color[c] *= static_cast<float>(std::exp(random.Normal(0.25)));
  for (int row = 0; row < static_cast<int>(reach); ++row) {
    const float fade = strength * (1.0F - static_cast<float>(row / reach));
    for (int column = 0; column < canvas.light.cols; ++column) {
      const float over = std::clamp(4.0F * (waves(row, column) - level), 0.0F, 1.0F);
      canvas.light(row, column) += fade * over * color;
    }
  }
}

/// Ground of two colours with patches, stones and weed, `clarity` of it through the water.
void PaintGround(StudioCanvas& canvas, Random& random) {
  const bool from_above = random.Chance(0.6);
  const int first = from_above ? 0 : cvRound(canvas.light.rows * random.Uniform(0.4, 0.9));
  const double cells = DrawLog(2.0, 30.0, random);
  const double squeeze = from_above ? 1.0 : random.Uniform(2.0, 5.0);
  const cv::Mat1f form = DrawNoise({cells, cells * squeeze, 5, random.Uniform(0.5, 0.9)}, random);
  const cv::Mat1f grain = DrawNoise({160.0, 120.0 * squeeze, 2, 0.8}, random);
  const cv::Vec3f one = DrawAnyColor(random);
  const cv::Vec3f other = random.Chance(0.5) ? DrawAnyColor(random)
                                             : one * static_cast<float>(random.Uniform(0.2, 0.8));
  const auto sharpness = static_cast<float>(DrawLog(0.4, 6.0, random));
  const auto roughness = static_cast<float>(random.Uniform(0.0, 0.35));
  const auto clarity = static_cast<float>(random.Uniform(0.15, 1.0));
  const double down = DrawLog(2.0, 25.0, random), across = DrawLog(2.0, 25.0, random);
  const cv::Mat1f light = DrawNoise({across, down, 2, 0.6}, random);
  const auto dapple = static_cast<float>(random.Uniform(0.0, 0.6));
  for (int row = first; row < canvas.light.rows; ++row) {
    const float near = from_above ? 1.0F
                                  : static_cast<float>(row - first) /
                                        static_cast<float>(canvas.light.rows - first);
    for (int column = 0; column < canvas.light.cols; ++column) {
      const float share = 0.5F + 0.5F * std::tanh(sharpness * form(row, column));
      const float shade = std::max(0.05F, 1.0F + roughness * grain(row, column)) *
                          std::max(0.1F, 1.0F + dapple * light(row, column));
      const cv::Vec3f ground = canvas.brightness * shade * (one + share * (other - one));
      cv::Vec3f& pixel = canvas.light(row, column);
      pixel += clarity * near * (ground - pixel);
    }
  }
}

/// Bright lines where waves gather the sun's light.
void PaintCaustics(StudioCanvas& canvas, Random& random) {
  const double cells = DrawLog(3.0, 25.0, random);
  const cv::Mat1f field = DrawNoise({cells, cells * random.Uniform(0.5, 2.0), 2, 0.5}, random);
  const auto width = static_cast<float>(random.Uniform(0.05, 0.3));
  const auto strength = static_cast<float>(random.Uniform(0.1, 0.9));
  for (int row = 0; row < canvas.light.rows; ++row) {
    for (int column = 0; column < canvas.light.cols; ++column) {
      const float off = field(row, column) / width;
      canvas.light(row, column) *= 1.0F + strength / (1.0F + off * off);
    }
  }
}

/// Joints of tiles or the seams of a liner, in perspective.
void PaintJoints(StudioCanvas& canvas, Random& random) {
  const StudioSurface joint{.color = DrawAnyColor(random),
                            .clarity = static_cast<float>(random.Uniform(0.1, 0.8))};
  const double step = DrawLog(25.0, 150.0, random);
  const double lean = random.Uniform(-0.5, 0.5);
  const double width = random.Uniform(1.0, 4.0);
  for (double at = -400.0; at < 1040.0; at += step) {
    const std::array down{cv::Point2f(static_cast<float>(at), 0.0F),
                          cv::Point2f(static_cast<float>(at + 480.0 * lean), 480.0F)};
    const std::array across{cv::Point2f(0.0F, static_cast<float>(at)),
                            cv::Point2f(640.0F, static_cast<float>(at - 640.0 * lean))};
    PaintStroke(canvas, down, width, joint, random);
    PaintStroke(canvas, across, width, joint, random);
  }
}

}  // namespace

StudioCanvas DrawBackdrop(Random& random) {
  StudioCanvas canvas;
  canvas.water = DrawWater(random);
  canvas.brightness = static_cast<float>(
      std::max({canvas.water[0], canvas.water[1], canvas.water[2]}) * DrawLog(0.8, 4.0, random));
  const auto angle = static_cast<float>(random.Normal(0.7));
  canvas.towards_light = {std::sin(angle), -std::cos(angle)};
  PaintWater(canvas, random);
  if (random.Chance(0.55)) PaintGround(canvas, random);
  if (random.Chance(0.15)) PaintJoints(canvas, random);
  if (random.Chance(0.35)) PaintCaustics(canvas, random);
  if (random.Chance(0.4)) PaintSurface(canvas, random);
  return canvas;
}

}  // namespace limpet

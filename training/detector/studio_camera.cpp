// SPDX-License-Identifier: MIT
#include "training/detector/studio_camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "limpet/core/smooth_step.hpp"

namespace limpet {
namespace {

/// Light that water scatters on its way: a veil over everything, and a glow around what is bright.
void Scatter(StudioCanvas& canvas, Random& random) {
  if (random.Chance(0.4)) {
    const auto veil = static_cast<float>(random.Uniform(0.0, 0.6));
    for (cv::Vec3f& pixel : canvas.light)
      pixel += veil * (canvas.water - pixel);
  }
  if (random.Chance(0.5)) {
    cv::Mat3f small;
    cv::resize(canvas.light, small, {}, 0.125, 0.125, cv::INTER_AREA);
    cv::GaussianBlur(small, small, {}, random.Uniform(1.0, 5.0));
    cv::Mat3f glow;
    cv::resize(small, glow, canvas.light.size(), 0.0, 0.0, cv::INTER_LINEAR);
    const double share = random.Uniform(0.0, 0.35);
    cv::addWeighted(canvas.light, 1.0 - share, glow, share, 0.0, canvas.light);
  }
}

/// Darker corners, as a curve or as the rim of a round port.
void Vignette(cv::Mat3f& light, Random& random) {
  const auto loss = static_cast<float>(random.Uniform(0.0, 0.6));
  const bool has_rim = random.Chance(0.15);
  const double rim = random.Uniform(0.8, 1.1) * 400.0;
  const double off_x = random.Normal(25.0);
  const double off_y = random.Normal(25.0);
  for (int row = 0; row < light.rows; ++row) {
    for (int column = 0; column < light.cols; ++column) {
      const double radius = std::hypot(column - 320.0 - off_x, row - 240.0 - off_y);
      const auto share = static_cast<float>(radius * radius / (400.0 * 400.0));
      light(row, column) *= std::max(0.05F, 1.0F - loss * share);
      if (has_rim)
        light(row, column) *= static_cast<float>(std::clamp(0.25 * (rim - radius), 0.04, 1.0));
    }
  }
}

void Blur(cv::Mat3f& light, Random& random) {
  if (random.Chance(0.7)) {
    const double sigma = random.Chance(0.15) ? random.Uniform(1.5, 3.0) : random.Uniform(0.3, 1.5);
    cv::GaussianBlur(light, light, {}, sigma);
  }
  if (random.Chance(0.12)) {  // shaken
    const int length = 3 + static_cast<int>(random.Index(10));
    const double angle = random.Uniform(0.0, std::numbers::pi);
    cv::Mat1f kernel(length, length, 0.0F);
    const cv::Point2d middle(0.5 * (length - 1), 0.5 * (length - 1));
    const cv::Point2d reach(middle.x * std::cos(angle), middle.y * std::sin(angle));
    cv::line(kernel, middle - reach, middle + reach, cv::Scalar(1.0));
    kernel /= cv::sum(kernel)[0];
    cv::filter2D(light, light, -1, kernel);
  }
}

/// Light to levels of 0 to 255, not yet whole: exposure, white balance, tone and saturation.
void Develop(cv::Mat3f& light, Random& random) {
  const cv::Scalar mean = cv::mean(light);
  const double level = std::max({mean[0], mean[1], mean[2], 1e-3});
  // Some cameras meter the dark ground and burn out the rest.
  const double metered =
      random.Chance(0.12) ? DrawLog(0.75, 2.5, random) : DrawLog(0.08, 0.75, random);
  const double exposure = metered / level;
  const double balance = random.Chance(0.5) ? random.Uniform(0.0, 1.0) : 0.0;
  cv::Vec3f gain;
  for (int c = 0; c < 3; ++c) {
    const double neutral = std::clamp(level / std::max(mean[c], 1e-3), 0.2, 5.0);
    gain[c] =
        static_cast<float>(exposure * std::pow(neutral, balance) * std::exp(random.Normal(0.1)));
  }
  if (random.Chance(0.1)) gain[2] *= static_cast<float>(random.Uniform(0.25, 0.8));
  const auto gamma = static_cast<float>(1.0 / random.Uniform(1.7, 2.5));
  const auto contrast = static_cast<float>(random.Uniform(0.0, 0.7));
  const auto saturation = static_cast<float>(random.Uniform(0.7, 1.6));
  for (cv::Vec3f& pixel : light) {
    float grey = 0.0F;
    for (int c = 0; c < 3; ++c) {
      const float signal = std::pow(std::clamp(pixel[c] * gain[c], 0.0F, 1.0F), gamma);
      // An S around the middle.
      pixel[c] = signal + contrast * (SmoothStep(signal) - signal);
      grey += pixel[c] / 3.0F;
    }
    for (int c = 0; c < 3; ++c)
      pixel[c] = 255.0F * (grey + saturation * (pixel[c] - grey));
  }
}

/// White noise of the sensor; grain that a decoder made coarser; colour noise.
void AddNoise(cv::Mat3f& levels, Random& random) {
  const double sigma = random.Chance(0.2) ? random.Uniform(6.0, 16.0) : random.Uniform(0.5, 6.0);
  const double grain = random.Chance(0.5) ? 0.0 : random.Uniform(0.5, 1.2);
  const auto color = static_cast<float>(random.Uniform(0.3, 1.0));
  cv::Mat3f noise(levels.size());
  cv::RNG draws(random.Bits());
  draws.fill(noise, cv::RNG::NORMAL, 0.0, sigma);
  if (grain > 0.0) {
    cv::GaussianBlur(noise, noise, {}, grain);
    noise *= 1.0 + 2.0 * grain;
  }
  for (int row = 0; row < levels.rows; ++row) {
    for (int column = 0; column < levels.cols; ++column) {
      const cv::Vec3f& own = noise(row, column);
      const float shared = own[1];
      for (int c = 0; c < 3; ++c)
        levels(row, column)[c] += shared + color * (own[c] - shared);
    }
  }
}

cv::Mat3b Compressed(const cv::Mat3b& picture, Random& random) {
  const int quality = static_cast<int>(random.Uniform(12.0, 95.0));
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
  cv::Mat decoded = cv::imdecode(bytes, cv::IMREAD_COLOR);
  return decoded;
}

}  // namespace

cv::Mat3b TakePicture(StudioCanvas canvas, Random& random) {
  Scatter(canvas, random);
  Vignette(canvas.light, random);
  Blur(canvas.light, random);
  Develop(canvas.light, random);
  AddNoise(canvas.light, random);
  cv::Mat3b picture;
  canvas.light.convertTo(picture, CV_8UC3);
  return random.Chance(0.5) ? Compressed(picture, random) : picture;
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/imaging/sensor.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/random.hpp"
#include "limpet/core/smooth_step.hpp"

namespace limpet {
namespace {

constexpr int kWhite = 4095;  ///< signal that saturates
constexpr std::size_t kNoiseDraws = 1U << 16U;
constexpr float kMiddleGray = 0.19F;  ///< where automatic exposure puts the mean luminance
/// So many times longer may the shutter stay open than under a clear noon sky (1/500 s to 1/60 s).
constexpr float kLongestExposure = 8.0F;
constexpr float kMostGain = 400.0F;
/// Share of the other two channels in each: filters of a sensor overlap.
constexpr float kCrosstalk = 0.02F;
// Luminance of linear light.
constexpr float kBlue = 0.0722F;
constexpr float kGreen = 0.7152F;
constexpr float kRed = 0.2126F;
const Eigen::Array3f kLuminance(kBlue, kGreen, kRed);

/// 8-bit levels of linear signals: gamma of sRGB, then an S-curve around the middle.
std::vector<std::uint8_t> SignalCurve(double contrast) {
  std::vector<std::uint8_t> curve(kWhite + 1);
  for (int i = 0; i <= kWhite; ++i) {
    const double x = static_cast<double>(i) / kWhite;
    const double coded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    const double curved = coded + contrast * (SmoothStep(coded) - coded);
    curve[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(255.0 * curved));
  }
  return curve;
}

/// Light of a channel with crosstalk, from its own light and the sum of all three.
template <class Own, class All>
auto WithCrosstalk(const Own& own, const All& all) {
  return (1.0F - 3.0F * kCrosstalk) * own + kCrosstalk * all;
}

Eigen::Array3f MeanOf(const LinearImage& light) {
  constexpr int kEvery = 4;  // rows and columns: enough for a mean
  Eigen::Array3f mean;
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    int count = 0;
    for (int row = kEvery / 2; row < light.height_px; row += kEvery) {
      const float* values = light.row(c, row);
      for (int column = kEvery / 2; column < light.width_px; column += kEvery, ++count) {
        sum += values[column];
      }
    }
    mean(static_cast<Eigen::Index>(c)) = static_cast<float>(sum / std::max(count, 1));
  }
  return WithCrosstalk(mean, mean.sum()).max(1e-7F);
}

}  // namespace

Sensor::Sensor(const ImageParams::Sensor& params, int width_px, std::uint64_t seed)
    : params_(params),
      seed_(seed),
      curve_(SignalCurve(params.contrast)),
      noise_(kNoiseDraws + static_cast<std::size_t>(width_px)),
      signal_(3 * static_cast<std::size_t>(width_px)),
      levels_(signal_.size()),
      sum_(static_cast<std::size_t>(width_px)) {
  Random random(seed, "sensor noise");
  for (float& draw : noise_)
    draw = static_cast<float>(random.Normal(1.0));
}

Sensor::Settings Sensor::Meter(const LinearImage& light) const {
  const Eigen::Array3f mean = MeanOf(light);
  const float luminance = (kLuminance * mean).sum();
  // Grey world: what is left of the cast is what the share leaves; red has limits on any camera.
  const auto share = static_cast<float>(params_.white_balance);
  const Eigen::Array3f balance = (luminance / mean).pow(share).min(6.0F).max(0.4F);
  const float after = (kLuminance * mean * balance).sum();
  const float gain = std::min(kMiddleGray / after, kMostGain);
  const auto chosen = gain * static_cast<float>(std::exp2(params_.exposure));
  return {.gain = chosen * balance, .amplification = std::max(chosen / kLongestExposure, 1.0F)};
}

void Sensor::Develop(const LinearImage& light, const Settings& settings, std::uint32_t frame,
                     Image& image) {
  using Row = Eigen::Map<const Eigen::ArrayXf>;
  const Eigen::Index width = light.width_px;
  Random draws(seed_ + frame, "noise of a frame");
  for (int row = 0; row < light.height_px; ++row) {
    const auto light_of = [&](std::size_t channel) { return Row(light.row(channel, row), width); };
    Eigen::Map<Eigen::ArrayXf> all(sum_.data(), width);
    all = light_of(0) + light_of(1) + light_of(2);
    for (std::size_t c = 0; c < 3; ++c) {
      const float gain = settings.gain(static_cast<Eigen::Index>(c));
      // Per channel: a signal x came of x well / a electrons, a being all that is not exposure.
      const float relative = gain / settings.gain(1) * settings.amplification;
      const float shot = relative / static_cast<float>(params_.full_well);
      const float read = shot * static_cast<float>(params_.read_noise);
      const float read2 = read * read;
      const Row noise(noise_.data() + draws.Index(kNoiseDraws), width);
      Eigen::Map<Eigen::ArrayXf> to(signal_.data() + c * static_cast<std::size_t>(width), width);
      to = WithCrosstalk(gain * light_of(c), gain * all);
      to += noise * (shot * to + read2).sqrt();
    }
    Code(image.bgr.data() + 3 * static_cast<std::ptrdiff_t>(width) * row);
  }
}

/// Saturation and tone curve of a row of signals.
void Sensor::Code(std::uint8_t* bgr) {
  const std::size_t width = levels_.size() / 3;
  const float* blue = signal_.data();
  const float* green = blue + width;
  const float* red = green + width;
  const auto own = static_cast<float>(params_.saturation * kWhite);
  const auto shared = static_cast<float>((1.0 - params_.saturation) * kWhite);
  for (std::size_t c = 0; c < 3; ++c) {
    const float* signal = signal_.data() + c * width;
    std::int32_t* level = levels_.data() + c * width;
    for (std::size_t i = 0; i < width; ++i) {
      const float gray = kBlue * blue[i] + kGreen * green[i] + kRed * red[i];
      const float vivid = own * signal[i] + shared * gray;
      level[i] =
          static_cast<std::int32_t>(std::min(std::max(vivid, 0.0F), static_cast<float>(kWhite)));
    }
  }
  for (std::size_t i = 0; i < width; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      bgr[3 * i + c] = curve_[static_cast<std::size_t>(levels_[c * width + i])];
    }
  }
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/imaging/jpeg.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace limpet {
namespace {

constexpr int kBlockSide = 8;
struct alignas(16) JpegBlock : std::array<float, 64> {};

// ITU-T T.81, tables K.1 and K.2.
constexpr std::array<int, 64> kLuminanceTable{
    16, 11, 10, 16, 24,  40,  51,  61,  12, 12, 14, 19, 26,  58,  60,  55,
    14, 13, 16, 24, 40,  57,  69,  56,  14, 17, 22, 29, 51,  87,  80,  62,
    18, 22, 37, 56, 68,  109, 103, 77,  24, 35, 55, 64, 81,  104, 113, 92,
    49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99};
constexpr std::array<int, 64> kColorTable{
    17, 18, 24, 47, 99, 99, 99, 99, 18, 21, 26, 66, 99, 99, 99, 99, 24, 26, 56, 99, 99, 99,
    99, 99, 47, 66, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99,
    99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99};

/// Steps at a quality, by the usual scale: 50 is the table itself, 100 steps of one.
std::array<float, 64> StepsOf(const std::array<int, 64>& table, int quality) {
  const int percent = quality < 50 ? 5000 / std::max(quality, 1) : 200 - 2 * quality;
  std::array<float, 64> steps{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i] = static_cast<float>(std::clamp((table[i] * percent + 50) / 100, 1, 255));
  }
  return steps;
}

/// Rows of the orthonormal cosine transform, and its transpose.
struct Cosines {
  JpegBlock forward, backward;
  Cosines() {
    for (std::size_t k = 0; k < kBlockSide; ++k) {
      for (std::size_t i = 0; i < kBlockSide; ++i) {
        const double angle = (2.0 * static_cast<double>(i) + 1.0) * static_cast<double>(k) *
                             std::numbers::pi / (2.0 * kBlockSide);
        const double value = (k == 0 ? std::sqrt(0.125) : 0.5) * std::cos(angle);
        forward[kBlockSide * k + i] = static_cast<float>(value);
        backward[kBlockSide * i + k] = static_cast<float>(value);
      }
    }
  }
};

/// Matrix product a b. Rows are eight numbers: two registers.
inline void Multiply(const float* a, const float* b, float* product) {
  using Eight = Eigen::Array<float, kBlockSide, 1>;
  using Row = Eigen::Map<const Eight, Eigen::Aligned16>;
  for (std::size_t row = 0; row < kBlockSide; ++row, a += kBlockSide) {
    Eight sum = a[0] * Row(b);
    sum += a[1] * Row(b + 8);
    sum += a[2] * Row(b + 16);
    sum += a[3] * Row(b + 24);
    sum += a[4] * Row(b + 32);
    sum += a[5] * Row(b + 40);
    sum += a[6] * Row(b + 48);
    sum += a[7] * Row(b + 56);
    Eigen::Map<Eight, Eigen::Aligned16>(product + kBlockSide * row) = sum;
  }
}

/// Quantises one block of bytes in place.
void Quantise(std::uint8_t* pixels, std::size_t stride, const JpegBlock& steps,
              const JpegBlock& inverse_steps) {
  static const Cosines kCosines;
  JpegBlock block;
  JpegBlock half;
  for (std::size_t row = 0; row < kBlockSide; ++row) {
    for (std::size_t i = 0; i < kBlockSide; ++i) {
      block[kBlockSide * row + i] = static_cast<float>(pixels[stride * row + i]) - 128.0F;
    }
  }
  Multiply(kCosines.forward.data(), block.data(), half.data());
  Multiply(half.data(), kCosines.backward.data(), block.data());
  // Adding and taking away 1.5 * 2^23 rounds to whole numbers.
  constexpr float kRounder = 12582912.0F;
  using All = Eigen::Map<Eigen::Array<float, 64, 1>, Eigen::Aligned16>;
  using Known = Eigen::Map<const Eigen::Array<float, 64, 1>, Eigen::Aligned16>;
  All(block.data()) = ((All(block.data()) * Known(inverse_steps.data()) + kRounder) - kRounder) *
                      Known(steps.data());
  Multiply(kCosines.backward.data(), block.data(), half.data());
  Multiply(half.data(), kCosines.forward.data(), block.data());
  for (std::size_t row = 0; row < kBlockSide; ++row) {
    for (std::size_t i = 0; i < kBlockSide; ++i) {
      const float level = block[kBlockSide * row + i] + 128.5F;
      pixels[stride * row + i] =
          static_cast<std::uint8_t>(static_cast<int>(std::min(std::max(level, 0.0F), 255.0F)));
    }
  }
}

/// `padded`: of whole blocks.
void QuantisePlane(cv::Mat& padded, const std::array<float, 64>& values) {
  JpegBlock steps;
  std::ranges::copy(values, steps.begin());
  JpegBlock inverse_steps;
  std::ranges::transform(steps, inverse_steps.begin(), [](float step) { return 1.0F / step; });
  for (int row = 0; row < padded.rows; row += kBlockSide) {
    for (int column = 0; column < padded.cols; column += kBlockSide) {
      Quantise(padded.ptr(row) + column, padded.step[0], steps, inverse_steps);
    }
  }
}

/// Repeats the last row and column up to whole blocks.
void Pad(const cv::Mat& plane, cv::Mat& padded) {
  cv::copyMakeBorder(plane, padded, 0, -plane.rows & (kBlockSide - 1), 0,
                     -plane.cols & (kBlockSide - 1), cv::BORDER_REPLICATE);
}

}  // namespace

/// Kept from picture to picture.
struct Jpeg::Scratch {
  cv::Mat mixed, half;
  std::vector<cv::Mat> planes, padded = std::vector<cv::Mat>(3);
};

Jpeg::Jpeg(int quality)
    : scratch_(std::make_unique<Scratch>()),
      quality_(quality),
      luminance_steps_(StepsOf(kLuminanceTable, quality)),
      color_steps_(StepsOf(kColorTable, quality)) {}
Jpeg::~Jpeg() = default;
Jpeg::Jpeg(Jpeg&&) noexcept = default;
Jpeg& Jpeg::operator=(Jpeg&&) noexcept = default;

void Jpeg::Compress(Image& image) {
  if (quality_ < 1) return;
  auto& [mixed, half, planes, padded] = *scratch_;
  cv::Mat pixels(image.height_px, image.width_px, CV_8UC3, image.bgr.data());
  cv::cvtColor(pixels, mixed, cv::COLOR_BGR2YCrCb);
  cv::split(mixed, planes);
  const cv::Size halved((image.width_px + 1) / 2, (image.height_px + 1) / 2);
  for (std::size_t c = 0; c < planes.size(); ++c) {
    const bool is_color = c > 0;
    if (is_color) cv::resize(planes[c], half, halved, 0.0, 0.0, cv::INTER_AREA);
    const cv::Mat& plane = is_color ? half : planes[c];
    Pad(plane, padded[c]);
    QuantisePlane(padded[c], is_color ? color_steps_ : luminance_steps_);
    const cv::Mat inside = padded[c](cv::Rect({0, 0}, plane.size()));
    if (is_color) {
      cv::resize(inside, planes[c], pixels.size(), 0.0, 0.0, cv::INTER_LINEAR);
    } else {
      inside.copyTo(planes[c]);
    }
  }
  cv::merge(planes, mixed);
  cv::cvtColor(mixed, pixels, cv::COLOR_YCrCb2BGR);
}

}  // namespace limpet

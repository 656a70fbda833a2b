// SPDX-License-Identifier: MIT
#include "limpet/vision/ground_contrast.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "limpet/core/statistics.hpp"
#include "limpet/vision/image_mat.hpp"

namespace limpet {
namespace {

constexpr int kLeastSide = 64;     // [px]
constexpr int kPixelsAcross = 40;  // pixels across the small picture in which contrast is taken
constexpr double kCoarse = 1.5;    // of those: slower changes are light and lens, not ground
constexpr int kBorder = 2;         // of those: at the border nothing is known of what is slow
constexpr double kSigmaOfMedian = 1.4826;  // of a Gaussian
constexpr double kDarkest = 1e-4;          // linear light

/// Linear light of an 8-bit sRGB value; cameras and files are taken to be so.
cv::Mat LinearOf(ImageView picture) {
  static const cv::Mat table = [] {
    cv::Mat values(1, 256, CV_32F);
    for (int i = 0; i < 256; ++i) {
      const double x = i / 255.0;
      values.at<float>(i) =
          static_cast<float>(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
    }
    return values;
  }();
  cv::Mat linear;
  cv::LUT(MatOf(picture), table, linear);
  return linear;
}

/// Standard deviation of one pixel's noise in green, from what three neighbours differ by beyond a
/// slope.
double PixelNoise(const cv::Mat& linear) {
  std::vector<float> bends;
  for (int row = 0; row < linear.rows; row += 4) {
    const auto* pixels = linear.ptr<cv::Vec3f>(row);
    for (int column = 1; column + 1 < linear.cols; column += 3) {
      bends.push_back(
          std::abs(pixels[column - 1][1] - 2.0F * pixels[column][1] + pixels[column + 1][1]));
    }
  }
  return kSigmaOfMedian * static_cast<double>(UpperMedian(std::move(bends))) / std::sqrt(6.0);
}

/// Robust spread over the mean of one channel, slower changes left out.
double SpreadOverMean(const cv::Mat& channel) {
  cv::Mat slow;
  cv::GaussianBlur(channel, slow, {}, kCoarse, kCoarse, cv::BORDER_REPLICATE);
  std::vector<float> steps, light;
  for (int row = kBorder; row + kBorder < channel.rows; ++row) {
    for (int column = kBorder; column + kBorder < channel.cols; ++column) {
      const auto value = channel.at<float>(row, column);
      light.push_back(value);
      steps.push_back(std::abs(value - slow.at<float>(row, column)));
    }
  }
  const double step = UpperMedian(std::move(steps)), usual = UpperMedian(std::move(light));
  return kSigmaOfMedian * step / std::max(usual, kDarkest);
}

}  // namespace

GroundContrast MeasureGroundContrast(ImageView picture) {
  if (std::min(picture.width_px, picture.height_px) < kLeastSide) {
    return {};
  }
  const cv::Mat linear = LinearOf(picture);
  const double shrink = std::max(1.0, static_cast<double>(picture.width_px) / kPixelsAcross);
  cv::Mat small;
  cv::resize(linear, small, {}, 1.0 / shrink, 1.0 / shrink, cv::INTER_AREA);
  if (std::min(small.rows, small.cols) <= 2 * kBorder) {
    return {};  // a strip: all of it is border
  }
  std::array<cv::Mat, 3> channels;
  cv::split(small, channels.data());
  const double noise = PixelNoise(linear) / shrink / std::max(cv::mean(small)[1], kDarkest);
  const auto beyond_noise = [noise](const cv::Mat& channel) {
    const double spread = SpreadOverMean(channel);
    return std::sqrt(std::max(0.0, spread * spread - noise * noise));
  };
  return {.exposure = 0.0,
          .blue = beyond_noise(channels[0]),
          .green = beyond_noise(channels[1]),
          .red = beyond_noise(channels[2]),
          .noise = noise};
}

}  // namespace limpet

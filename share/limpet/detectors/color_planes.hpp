// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <opencv2/core.hpp>

namespace limpet {

/// Four views of one image in which objects are brighter than what surrounds them: yellowness,
/// redness and greenness (differences over the sum, so that shading drops out), and distance from
/// the scene's usual colours. 16-bit signed. Keeps its buffers from one image to the next.
class ColorPlanes {
 public:
  /// `noise` is the least standard deviation of a colour [levels]; `bgr` has 8 bits per channel.
  void Fill(const cv::Mat& bgr, double noise);
  [[nodiscard]] const std::array<cv::Mat, 4>& planes() const { return planes_; }
  /// Levels from just above a plane's spread to its brightest pixel.
  [[nodiscard]] const std::vector<int>& LevelsOf(const cv::Mat& plane);

 private:
  void FillOpponents();
  void FillUnusual(const cv::Mat& bgr, double noise);

  cv::Mat colors_;
  cv::Mat mixed_;
  cv::Mat squared_;
  std::array<cv::Mat, 4> parts_;
  std::array<cv::Mat, 4> planes_;
  cv::Mat histogram_;
  std::vector<int> levels_;
};

}  // namespace limpet

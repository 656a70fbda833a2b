// SPDX-License-Identifier: MIT
#include "limpet/vision/image_mat.hpp"

#include <cstdint>

#include <opencv2/core.hpp>

namespace limpet {

cv::Mat MatOf(const ImageView& image) {
  auto* pixels = const_cast<std::uint8_t*>(image.bgr);
  return {image.height_px, image.width_px, CV_8UC3, pixels};
}

ImageView ViewOf(const cv::Mat& pixels) {
  return {pixels.ptr<std::uint8_t>(), pixels.cols, pixels.rows};
}

}  // namespace limpet

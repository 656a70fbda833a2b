// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core.hpp>

#include "limpet/vision/image.hpp"

namespace limpet {

/// OpenCV takes no const pixels: for what only reads them.
[[nodiscard]] inline cv::Mat MatOf(const ImageView& image) {
  auto* pixels =
      const_cast<std::uint8_t*>(image.bgr);  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  return {image.height_px, image.width_px, CV_8UC3, pixels};
}

/// And back. `pixels` has 3 bytes a pixel and no gaps between its rows.
[[nodiscard]] inline ImageView ViewOf(const cv::Mat& pixels) {
  return {pixels.ptr<std::uint8_t>(), pixels.cols, pixels.rows};
}

}  // namespace limpet

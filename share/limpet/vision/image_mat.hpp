// SPDX-License-Identifier: MIT
// OpenCV's type by its name alone: other libraries reach this header.
#pragma once

#include "limpet/vision/image.hpp"

namespace cv {
class Mat;
}

namespace limpet {

/// The same pixels. OpenCV takes no const ones: for what only reads them.
[[nodiscard]] cv::Mat MatOf(const ImageView& image);

/// A view of the matrix. `pixels` has 3 bytes a pixel and no gaps between its rows.
[[nodiscard]] ImageView ViewOf(const cv::Mat& pixels);

}  // namespace limpet

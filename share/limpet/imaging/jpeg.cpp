// SPDX-License-Identifier: MIT
#include "limpet/imaging/jpeg.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "limpet/core/require.hpp"

namespace limpet {

void Jpeg::Compress(Image& image) {
  if (quality_ < 1) return;
  cv::Mat pixels(image.height_px, image.width_px, CV_8UC3, image.bgr.data());
  const std::uint8_t* const memory = pixels.data;
  cv::imencode(".jpg", pixels, bytes_, {cv::IMWRITE_JPEG_QUALITY, quality_});
  cv::imdecode(bytes_, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION, &pixels);
  LIMPET_REQUIRE(pixels.data == memory, "a picture of the same size is decoded in place");
}

}  // namespace limpet

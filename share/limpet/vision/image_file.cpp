// SPDX-License-Identifier: MIT
#include "limpet/vision/image_file.hpp"

#include <algorithm>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "limpet/vision/cut_image.hpp"
#include "limpet/vision/image_mat.hpp"

namespace limpet {
namespace {

/// Words on a header that asks for more pixels than OpenCV takes, or than there is memory for.
std::string WordsOn(const cv::Exception& exception) {
  return exception.code == cv::Error::StsNoMem
             ? "too large an image for this machine's memory"
             : "more pixels than an image may have (2^20 a side, 2^30 in all), or damaged";
}

}  // namespace

Expected<Image> ReadImage(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    return Error{file.string() + ": no such file"};
  }
  if (IsCutShort(file)) {
    return Error{file.string() + ": the image is cut short, its end is missing"};
  }
  cv::Mat pixels;
  try {
    pixels = cv::imread(file.string(), cv::IMREAD_COLOR);
  } catch (const cv::Exception& exception) {
    return Error{file.string() + ": " + WordsOn(exception)};
  }
  if (pixels.empty()) {
    return Error{file.string() + ": not an image that can be read"};
  }
  Image image{pixels.cols, pixels.rows, {}};
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(pixels.cols);
  image.bgr.resize(row_bytes * static_cast<std::size_t>(pixels.rows));
  for (int row = 0; row < pixels.rows; ++row) {
    std::copy_n(pixels.ptr(row), row_bytes, &image.bgr[static_cast<std::size_t>(row) * row_bytes]);
  }
  return image;
}

std::optional<Error> WriteImage(const std::filesystem::path& file, const Image& image) {
  const cv::Mat pixels = MatOf(image.view());
  try {
    if (cv::imwrite(file.string(), pixels)) return std::nullopt;
  } catch (const cv::Exception& exception) {
    return Error{file.string() + ": " + exception.what()};
  }
  return Error{file.string() + ": cannot be written"};
}

}  // namespace limpet

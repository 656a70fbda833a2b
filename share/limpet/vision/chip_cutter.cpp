// SPDX-License-Identifier: MIT
#include "limpet/vision/chip_cutter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "limpet/vision/image_mat.hpp"

namespace limpet {
namespace {

/// The square to be cut out around the box: at least one pixel, all inside the image.
cv::Rect SquareAround(const Box& box, double context, const ImageView& image) {
  const double half = 0.5 * context * std::max({box.w, box.h, 1.0});
  const auto edge = [](double at, int size) {
    return static_cast<int>(std::clamp(std::round(at), 0.0, static_cast<double>(size)));
  };
  const int left = std::min(edge(box.u - half, image.width_px), image.width_px - 1);
  const int top = std::min(edge(box.v - half, image.height_px), image.height_px - 1);
  const int right = std::max(edge(box.u + half, image.width_px), left + 1);
  const int bottom = std::max(edge(box.v + half, image.height_px), top + 1);
  return {left, top, right - left, bottom - top};
}

}  // namespace

ImageChip CutChip(const ImageView& image, const Box& box, const ChipForm& form) {
  const cv::Mat whole = MatOf(image);
  cv::Mat chip = whole(SquareAround(box, form.context, image));
  const int longest = std::max(chip.cols, chip.rows);
  if (longest > form.side_px) {
    const double scale = static_cast<double>(form.side_px) / longest;
    const cv::Size size(std::max(1, cvRound(scale * chip.cols)),
                        std::max(1, cvRound(scale * chip.rows)));
    cv::Mat reduced;
    cv::resize(chip, reduced, size, 0.0, 0.0, cv::INTER_AREA);
    chip = reduced;
  }
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", chip, bytes, {cv::IMWRITE_JPEG_QUALITY, form.quality});
  return {.box = box, .jpeg = std::string(bytes.begin(), bytes.end())};
}

}  // namespace limpet

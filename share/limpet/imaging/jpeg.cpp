// SPDX-License-Identifier: MIT
#include "limpet/imaging/jpeg.hpp"

#include <algorithm>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace limpet {

/// Kept from picture to picture.
struct Jpeg::Scratch {
  cv::Mat mixed, planes, decoded;
  std::vector<cv::Mat> split, joined = std::vector<cv::Mat>(3);
};

Jpeg::Jpeg(int quality) : scratch_(std::make_unique<Scratch>()), quality_(quality) {}
Jpeg::~Jpeg() = default;
Jpeg::Jpeg(Jpeg&&) noexcept = default;
Jpeg& Jpeg::operator=(Jpeg&&) noexcept = default;

// As one grey picture of luminance with both halved colour planes below it: OpenCV's codec spends
// as long on the order of blue and red as on the transform. Colour is quantised by luminance's
// table, as many cameras do.
void Jpeg::Compress(Image& image) {
  if (quality_ < 1) return;
  auto& [mixed, planes, decoded, split, joined] = *scratch_;
  cv::Mat pixels(image.height_px, image.width_px, CV_8UC3, image.bgr.data());
  cv::cvtColor(pixels, mixed, cv::COLOR_BGR2YCrCb);
  cv::split(mixed, split);
  const cv::Size whole = pixels.size();
  const cv::Size half((whole.width + 1) / 2, (whole.height + 1) / 2);
  // Parts start at whole blocks of 8 pixels.
  const auto blocks = [](int size) { return (size + 7) / 8 * 8; };
  const int low = blocks(whole.height);
  const int right = blocks(half.width);
  planes.create(low + half.height, std::max(whole.width, right + half.width), CV_8UC1);
  if (planes.size() != decoded.size()) planes.setTo(128);
  const cv::Rect luminance({0, 0}, whole);
  const cv::Rect reds({0, low}, half);
  const cv::Rect blues({right, low}, half);
  split[0].copyTo(planes(luminance));
  cv::resize(split[1], planes(reds), half, 0.0, 0.0, cv::INTER_AREA);
  cv::resize(split[2], planes(blues), half, 0.0, 0.0, cv::INTER_AREA);
  cv::imencode(".jpg", planes, bytes_, {cv::IMWRITE_JPEG_QUALITY, quality_});
  cv::imdecode(bytes_, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION, &decoded);
  joined[0] = decoded(luminance);
  cv::resize(decoded(reds), joined[1], whole, 0.0, 0.0, cv::INTER_LINEAR);
  cv::resize(decoded(blues), joined[2], whole, 0.0, 0.0, cv::INTER_LINEAR);
  cv::merge(joined, mixed);
  cv::cvtColor(mixed, pixels, cv::COLOR_YCrCb2BGR);
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#include "limpet/vision/box_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace limpet {
namespace {

/// Light on dark is seen on any ground.
cv::Scalar Light() { return {255.0, 255.0, 255.0}; }
cv::Scalar Dark() { return {0.0, 0.0, 0.0}; }

void DrawText(const std::string& text, const cv::Point& at, double scale, cv::Mat& picture) {
  const int line = std::max(1, static_cast<int>(std::lround(2.0 * scale)));
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, scale, Dark(), 2 * line + 1,
              cv::LINE_AA);
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, scale, Light(), line, cv::LINE_AA);
}

}  // namespace

void DrawBoxes(std::span<const Box> boxes, Image& image) {
  constexpr double kUsualWidth = 1000.0;  // pixels across at which text of scale 0.6 reads well
  const double scale = 0.6 * std::max(1.0, image.width_px / kUsualWidth);
  const int line = std::max(1, static_cast<int>(std::lround(2.0 * scale)));
  cv::Mat picture(image.height_px, image.width_px, CV_8UC3, image.bgr.data());
  for (const Box& box : boxes) {
    const cv::Rect rectangle(static_cast<int>(std::lround(box.u - 0.5 * box.w)),
                             static_cast<int>(std::lround(box.v - 0.5 * box.h)),
                             static_cast<int>(std::lround(box.w)),
                             static_cast<int>(std::lround(box.h)));
    cv::rectangle(picture, rectangle, Dark(), line + 2);
    cv::rectangle(picture, rectangle, Light(), line);
    const std::string text = fmt::format("{} {:.2f}", box.color, box.confidence);
    const int above = rectangle.y - 3 * line;
    const int below = std::min(rectangle.y + rectangle.height + static_cast<int>(30.0 * scale),
                               image.height_px - 2 * line);
    const bool has_room = above > static_cast<int>(20.0 * scale);
    DrawText(text, {std::max(0, rectangle.x), has_room ? above : below}, scale, picture);
  }
}

}  // namespace limpet

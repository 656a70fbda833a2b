// SPDX-License-Identifier: MIT
#include "limpet/imaging/lens.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace limpet {

/// Kept from frame to frame, so that none is allocated.
struct Lens::Scratch {
  cv::Mat sharp, small, wide;
};

Lens::Lens(const ImageParams::Lens& params)
    : scratch_(std::make_unique<Scratch>()), blur_px_(params.blur) {}
Lens::~Lens() = default;
Lens::Lens(Lens&&) noexcept = default;
Lens& Lens::operator=(Lens&&) noexcept = default;

void Lens::Blur(LinearImage& image, double glow) {
  constexpr double kLeastBlur = 0.2;  // narrower ones stay within their pixel
  for (auto& plane : image.planes) {
    const cv::Mat whole(image.height_px, static_cast<int>(image.stride), CV_32F, plane.data());
    cv::Mat light = whole.colRange(0, image.width_px);
    if (blur_px_ >= kLeastBlur) {
      light.copyTo(scratch_->sharp);
      const int size = blur_px_ < 1.0 ? 5 : 2 * static_cast<int>(2.5 * blur_px_) + 1;
      cv::GaussianBlur(scratch_->sharp, light, {size, size}, blur_px_, blur_px_,
                       cv::BORDER_REPLICATE);
    }
    if (glow > 0.0) {
      constexpr int kScale = 8;
      cv::resize(light, scratch_->small, {image.width_px / kScale, image.height_px / kScale}, 0.0,
                 0.0, cv::INTER_AREA);
      cv::GaussianBlur(scratch_->small, scratch_->small, {7, 7}, 2.0, 2.0, cv::BORDER_REPLICATE);
      cv::resize(scratch_->small, scratch_->wide, light.size(), 0.0, 0.0, cv::INTER_LINEAR);
      cv::addWeighted(light, 1.0 - glow, scratch_->wide, glow, 0.0, light);
    }
  }
}

}  // namespace limpet

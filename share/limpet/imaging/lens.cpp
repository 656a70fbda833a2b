// SPDX-License-Identifier: MIT
#include "limpet/imaging/lens.hpp"

#include <algorithm>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace limpet {
namespace {

constexpr int kScale = 8;  // pixels of a picture per pixel of its glow

/// Replaces the share `glow` of `light` by the small picture, bilinear.
void AddGlow(const cv::Mat& small, float glow, cv::Mat& light) {
  std::vector<float> nodes(static_cast<std::size_t>(small.cols));
  const auto mix = [glow](float& value, float around) { value += around - glow * value; };
  for (int row = 0; row < light.rows; ++row) {
    // Middles of small pixels lie at 3.5, 11.5, ...
    const float at = (static_cast<float>(row) - 0.5F * (kScale - 1)) / kScale;
    const float inside = std::clamp(at, 0.0F, static_cast<float>(small.rows - 1));
    const int upper = std::min(static_cast<int>(inside), small.rows - 2);
    const float low = inside - static_cast<float>(upper);
    const float* above = small.ptr<float>(upper);
    const float* below = small.ptr<float>(upper + 1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      nodes[i] = glow * (above[i] + low * (below[i] - above[i]));
    }
    float* out = light.ptr<float>(row);
    for (int i = 0; i < kScale / 2; ++i)
      mix(out[i], nodes.front());
    int column = kScale / 2;
    for (std::size_t node = 0; node + 1 < nodes.size(); ++node, column += kScale) {
      const float step = (nodes[node + 1] - nodes[node]) / kScale;
      for (int i = 0; i < kScale; ++i) {
        mix(out[column + i], nodes[node] + (static_cast<float>(i) + 0.5F) * step);
      }
    }
    for (; column < light.cols; ++column)
      mix(out[column], nodes.back());
  }
}

}  // namespace

/// Kept from frame to frame, so that none is allocated.
struct Lens::Scratch {
  cv::Mat sharp, small;
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
    if (glow > 0.0 && std::min(image.width_px, image.height_px) >= 2 * kScale) {
      cv::resize(light, scratch_->small, {image.width_px / kScale, image.height_px / kScale}, 0.0,
                 0.0, cv::INTER_AREA);
      cv::GaussianBlur(scratch_->small, scratch_->small, {7, 7}, 2.0, 2.0, cv::BORDER_REPLICATE);
      AddGlow(scratch_->small, static_cast<float>(glow), light);
    }
  }
}

}  // namespace limpet

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <opencv2/core.hpp>

#include "limpet/vision/ellipse.hpp"
#include "limpet/vision/image.hpp"
#include "limpet/vision/outline_refiner.hpp"

namespace limpet {

/// Least width and height of an image in which a ball can be told [px].
inline constexpr int kLeastImageSide = 32;

/// The outline of what may be a ball, pixels of the full image.
struct BallOutline {
  RefinedOutline outline;
  Contrast contrast;
  int factor = 1;  ///< full resolution over the one it was found at

  /// How much it looks like a ball's, 0 to 1: edges all around, close to an ellipse that is hardly
  /// longer than a ball's image at this place.
  [[nodiscard]] double Roundness(const ImageView& image) const;
};

/// Finds outlines in one image, at the finest resolution at which the colour stands out from the
/// noise: faint outlines need the mean of more pixels.
class BallOutlines {
 public:
  /// Who calls keeps the image until the next one.
  void Take(const ImageView& image);
  /// The outline that `guess` is near to, if there is one.
  [[nodiscard]] std::optional<BallOutline> Find(const Ellipse& guess) const;
  /// The image, reduced to about 160 columns.
  [[nodiscard]] const cv::Mat& small() const { return small_; }
  /// Full over least resolution.
  [[nodiscard]] int factor() const { return factor_; }

  static constexpr double kSmallNoise = 0.8;  ///< least standard deviation of its colours [levels]

 private:
  ImageView image_{};
  int factor_ = 4;
  cv::Mat half_;
  cv::Mat small_;
};

}  // namespace limpet

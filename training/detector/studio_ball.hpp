// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <opencv2/core.hpp>

#include "limpet/core/random.hpp"

#include "training/detector/studio_canvas.hpp"

namespace limpet {

/// A painted ball in a studio picture; pixels of the canvas.
struct StudioBall {
  std::string color;
  cv::Point2f middle;
  double radius = 20.0;
  double stretch = 1.0;  ///< long over short half-axis: perspective
  double tilt = 0.0;     ///< of the long axis [rad]

  /// Distance from the middle in radii: 1 on the outline.
  [[nodiscard]] double ScaleAt(const cv::Point2d& at_px) const;
  /// Box around the ball's whole outline.
  [[nodiscard]] cv::Rect2d Outline() const;
};

[[nodiscard]] StudioBall DrawBall(Random& random);
/// Paints a ball with shading, gloss, band and growth, behind water; often on a post or a rope,
/// with a collar.
void PaintBall(StudioCanvas& canvas, const StudioBall& ball, Random& random);

}  // namespace limpet

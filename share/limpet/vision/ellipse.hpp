// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "limpet/objects/pixel_rect.hpp"

namespace limpet {

/// The outline { center + axes * (cos t, sin t) }, pixels.
struct Ellipse {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Matrix2d axes = Eigen::Matrix2d::Identity();

  /// The ellipse whose filled region has these second moments.
  [[nodiscard]] static Ellipse OfMoments(const Eigen::Vector2d& center,
                                         const Eigen::Matrix2d& covariance);
  /// The point in the direction (cos t, sin t), at `scale` of the outline's distance from the
  /// centre.
  [[nodiscard]] Eigen::Vector2d At(const Eigen::Vector2d& direction, double scale) const {
    return center + scale * (axes * direction);
  }
  /// Distance of a point from the centre, in radii towards it: 1 on the outline.
  [[nodiscard]] double Scale(const Eigen::Vector2d& point) const;
  /// Radius of the circle with the same area.
  [[nodiscard]] double MeanRadius() const;
  [[nodiscard]] double Elongation() const;
  /// Upright rectangle around the part inside an image of this size.
  [[nodiscard]] PixelRect VisiblePart(int width_px, int height_px) const;
};

/// Least squares over points on an outline: an ellipse if they go round far enough. Works in the
/// coordinates of `guess`, where the outline is nearly the unit circle.
[[nodiscard]] std::optional<Ellipse> FitEllipse(std::span<const Eigen::Vector2d> points,
                                                const Ellipse& guess);

}  // namespace limpet

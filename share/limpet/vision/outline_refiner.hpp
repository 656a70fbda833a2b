// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "limpet/vision/ellipse.hpp"
#include "limpet/vision/image.hpp"

namespace limpet {

/// How an ellipse's inside differs from what is around it.
struct Contrast {
  Eigen::Vector3d inside = Eigen::Vector3d::Zero();   ///< mean blue, green, red
  Eigen::Vector3d lit = Eigen::Vector3d::Zero();      ///< mean of the brighter half of the inside
  Eigen::Vector3d outside = Eigen::Vector3d::Zero();  ///< mean blue, green, red of the ring around
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();  ///< projection that separates the two best
  double separation = 0.0;  ///< distance of the means in standard deviations of both
  double support = 0.0;     ///< share of directions that show at least half of the difference
};

/// Looks at the inside and at a ring around `ellipse`. `noise` is the least standard deviation of a
/// colour [levels]. Nothing if too little of the ring is inside the image.
[[nodiscard]] std::optional<Contrast> MeasureContrast(const ImageView& image,
                                                      const Ellipse& ellipse, double noise);

struct RefinedOutline {
  Ellipse ellipse;
  double support = 0.0;    ///< share of directions inside the image whose edge lies on the ellipse
  double sides = 0.0;      ///< share of all directions whose edge lies inside the image
  double roughness = 0.0;  ///< rms distance of those edges from the ellipse, in radii

  /// True if much of the outline is missing, mostly as the image's border cuts it.
  [[nodiscard]] bool IsCut() const { return sides < 0.8; }
};

/// Moves an outline to where the colour changes, to a fraction of a pixel. Nothing if no ellipse
/// fits.
[[nodiscard]] std::optional<RefinedOutline> RefineOutline(const ImageView& image,
                                                          const Ellipse& guess,
                                                          const Contrast& contrast);

}  // namespace limpet

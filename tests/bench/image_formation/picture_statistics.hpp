// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/vision/image.hpp"

namespace limpet {

/// What tells a clean picture from a real one. Levels are of 8-bit luminance (CIE Y of the coded
/// values) unless stated.
struct PictureStatistics {
  double dark = 0.0;           ///< 1 % of the pixels are darker
  double bright = 0.0;         ///< 1 % are brighter
  double spread = 0.0;         ///< standard deviation over the picture
  double local_spread = 0.0;   ///< mean standard deviation within windows of 16 x 16 pixels
  double fine_spread = 0.0;    ///< likewise, 8 x 8
  double gradient_50 = 0.0;    ///< median of the gradient's magnitude [levels/px]
  double gradient_95 = 0.0;    ///< its 95th percentile
  double edges = 0.0;          ///< share of Canny's edge pixels (thresholds 50, 150), 0 to 1
  double chroma = 0.0;         ///< mean distance from grey in CIE Lab
  double chroma_spread = 0.0;  ///< sqrt(var a + var b) in CIE Lab
};

/// Of a picture brought to a width of 640 pixels first, so that scales compare.
[[nodiscard]] PictureStatistics StatisticsOf(const ImageView& picture);

}  // namespace limpet

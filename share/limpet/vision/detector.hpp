// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/topics/sensors.hpp"
#include "limpet/vision/image.hpp"

namespace limpet {

/// Finds objects of potential interest in single images. Not thread-safe: it may keep buffers.
class Detector {
 public:
  virtual ~Detector() = default;
  /// Boxes of what is visible, clipped at the image's border, the most confident first. Equal
  /// images give equal boxes, whatever was seen before.
  [[nodiscard]] virtual std::vector<Box> Detect(const ImageView& image) = 0;
};

}  // namespace limpet

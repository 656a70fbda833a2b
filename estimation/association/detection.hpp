// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace limpet {

/// A detector's box in an image: centre and size [px], its confidence (0 to 1) and class.
struct BoxDetection {
  double u = 0.0, v = 0.0, w = 0.0, h = 0.0;
  double confidence = 0.0;
  std::string color;
};

/// All boxes of one image exposed at `t` [s]; also when it shows nothing.
struct FrameDetections {
  int frame = 0;
  double t = 0.0;
  std::vector<BoxDetection> boxes;
};

}  // namespace limpet
